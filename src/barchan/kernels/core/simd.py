"""Reading memory by address: one number, or sixteen at once in the processor's vector unit.

The shadow test is asked at every landing and is most of a simulation's work. The compiler does not turn a
short loop inside a larger one into vector instructions, and it counts references to every array that a
loop hands on; so the test gets addresses and reads through these three. LLVM lowers them to whatever the
machine has. Nothing is checked against the ends of the memory: the caller keeps room around it.
"""

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from barchan.kernels.core.state import SIMD_WIDTH

_INDEX = ir.IntType(32)


@intrinsic
def load_at(typing: Any, address: Any, like: Any) -> Any:
    """The number at ``address``, of the type of ``like``."""
    signature = like(types.int64, like)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        kind = context.get_value_type(signature.return_type)
        size = context.get_abi_sizeof(kind)
        return builder.load(builder.inttoptr(arguments[0], kind.as_pointer()), align=size)

    return signature, generate


@intrinsic
def any_above(typing: Any, heights: Any, falls: Any, here: Any) -> Any:
    """Whether any of 16 numbers at ``heights`` exceeds its partner at ``falls`` plus ``here``.

    Both addresses lead to whole numbers of the type of ``here``.
    """

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _any(builder, _above(builder, *arguments))

    return types.boolean(types.int64, types.int64, here), generate


@intrinsic
def any_of_last_above(typing: Any, heights: Any, falls: Any, here: Any, keep: Any) -> Any:
    """The same for only the last ``keep`` of the 16 numbers (all of them where it is 16 or more)."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        *compared, keep = arguments
        from_last = ir.Constant(ir.VectorType(_INDEX, SIMD_WIDTH), list(range(SIMD_WIDTH, 0, -1)))
        kept = builder.icmp_signed("<=", from_last, _spread(builder, builder.trunc(keep, _INDEX)))
        return _any(builder, builder.and_(_above(builder, *compared), kept))

    return types.boolean(types.int64, types.int64, here, types.int64), generate


def _above(builder: Any, heights: Any, falls: Any, here: Any) -> Any:
    """Lane by lane, whether a height exceeds its fall plus ``here``."""
    place = ir.VectorType(here.type, SIMD_WIDTH).as_pointer()
    height, fall = (
        builder.load(builder.inttoptr(address, place), align=here.type.width // 8)
        for address in (heights, falls)
    )
    return builder.icmp_signed(">", height, builder.add(fall, _spread(builder, here)))


def _spread(builder: Any, value: Any) -> Any:
    """One value in every lane."""
    undefined = ir.Constant(ir.VectorType(value.type, SIMD_WIDTH), ir.Undefined)
    first = builder.insert_element(undefined, value, ir.Constant(_INDEX, 0))
    everywhere = ir.Constant(ir.VectorType(_INDEX, SIMD_WIDTH), [0] * SIMD_WIDTH)
    return builder.shuffle_vector(first, undefined, everywhere)


def _any(builder: Any, lanes: Any) -> Any:
    """Whether any lane holds."""
    bits = builder.bitcast(lanes, ir.IntType(SIMD_WIDTH))
    return builder.icmp_unsigned("!=", bits, ir.Constant(bits.type, 0))
