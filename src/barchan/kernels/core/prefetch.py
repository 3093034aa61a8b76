"""Asking for memory before it is needed."""

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

_WRITTEN, _KEPT, _DATA = 1, 3, 1
"""What LLVM is told: the memory will be written to, is to stay in the nearest cache, and is no code."""


@intrinsic
def prefetch(typing: Any, address: Any) -> Any:
    """Ask for the cache line at an address (a whole number); no address is wrong, none changes a bit."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        byte, number = ir.IntType(8).as_pointer(), ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [byte, number, number, number])
        fetch = builder.module.declare_intrinsic("llvm.prefetch", [byte], kind)
        place = builder.inttoptr(arguments[0], byte)
        builder.call(fetch, [place, number(_WRITTEN), number(_KEPT), number(_DATA)])
        return context.get_dummy_value()

    return types.none(types.int64), generate
