"""Numbers that threads share: read, written and exchanged as a whole, in an order that all of them see.

What a thread wrote before it stored or added a number, another one sees that read that number (release and
acquire). All work on places of int64 arrays.
"""

import platform
import sys
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

_ALIGNED = 8


def _place(context: Any, builder: Any, kind: Any, arguments: Any) -> Any:
    """The address of a place in an array."""
    array = context.make_array(kind)(context, builder, arguments[0])
    return builder.gep(array.data, [arguments[1]])


@intrinsic
def load(typing: Any, numbers: Any, at: Any) -> Any:
    """The number at a place, and with it all that was written before it was."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = _place(context, builder, signature.args[0], arguments)
        return builder.load_atomic(place, "acquire", _ALIGNED)

    return types.int64(numbers, types.int64), generate


@intrinsic
def store(typing: Any, numbers: Any, at: Any, value: Any) -> Any:
    """Put a number at a place, after all that was written before."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = _place(context, builder, signature.args[0], arguments)
        builder.store_atomic(arguments[2], place, "release", _ALIGNED)
        return context.get_dummy_value()

    return types.none(numbers, types.int64, types.int64), generate


@intrinsic
def add(typing: Any, numbers: Any, at: Any, value: Any) -> Any:
    """Add to the number at a place; what it was before."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = _place(context, builder, signature.args[0], arguments)
        return builder.atomic_rmw("add", place, arguments[2], "acq_rel")

    return types.int64(numbers, types.int64, types.int64), generate


@intrinsic
def swap(typing: Any, numbers: Any, at: Any, before: Any, after: Any) -> Any:
    """Put ``after`` at a place if ``before`` is there; whether it was."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = _place(context, builder, signature.args[0], arguments)
        found = builder.cmpxchg(place, arguments[2], arguments[3], "acq_rel", "acquire")
        return builder.extract_value(found, 1)

    return types.boolean(numbers, types.int64, types.int64, types.int64), generate


@intrinsic
def pause(typing: Any) -> Any:
    """Tell the processor that this thread waits in a loop, where it has a word for it."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        if platform.machine().lower() in ("x86_64", "amd64"):
            kind = ir.FunctionType(ir.VoidType(), [])
            builder.call(cgutils.get_or_insert_function(builder.module, kind, "llvm.x86.sse2.pause"), [])
        return context.get_dummy_value()

    return types.none(), generate


@intrinsic
def give_way(typing: Any) -> Any:
    """Let another thread have the processor, where the system knows ``sched_yield``.

    The function is named, not pointed to: code with a pointer could not be kept in the cache.
    """

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        if sys.platform != "win32":
            kind = ir.FunctionType(ir.IntType(32), [])
            builder.call(cgutils.get_or_insert_function(builder.module, kind, "sched_yield"), [])
        return context.get_dummy_value()

    return types.none(), generate
