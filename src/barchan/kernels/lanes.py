"""Reading memory by address: one number, or sixteen at once in the processor's vector unit.

The shadow test is asked at every landing and is most of a simulation's work. The compiler does not turn a
short loop inside a larger one into vector instructions, and it counts references to every array that a
loop hands on; so the test gets addresses and reads through these two. LLVM lowers them to whatever the
machine has. Nothing is checked against the ends of the memory: the caller keeps room around it.
"""

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

LANES = 16

_INDEX = ir.IntType(32)


@intrinsic
def peek(typing: Any, address: Any, like: Any) -> Any:
    """The number at ``address``, of the type of ``like``."""
    signature = like(types.int64, like)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        kind = context.get_value_type(signature.return_type)
        size = context.get_abi_sizeof(kind)
        return builder.load(builder.inttoptr(arguments[0], kind.as_pointer()), align=size)

    return signature, generate


@intrinsic
def any_above(typing: Any, heights: Any, falls: Any, here: Any, keep: Any) -> Any:
    """Whether any of the last ``keep`` of 16 numbers at ``heights`` exceeds its partner at ``falls`` + here.

    Both addresses lead to whole numbers of the type of ``here``.
    """
    signature = types.boolean(types.int64, types.int64, here, types.int64)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        heights, falls, here, keep = arguments
        lanes = ir.VectorType(here.type, LANES)

        def load(address: Any) -> Any:
            place = builder.inttoptr(address, lanes.as_pointer())
            return builder.load(place, align=here.type.width // 8)

        def spread(value: Any) -> Any:
            undefined = ir.Constant(ir.VectorType(value.type, LANES), ir.Undefined)
            first = builder.insert_element(undefined, value, ir.Constant(_INDEX, 0))
            everywhere = ir.Constant(ir.VectorType(_INDEX, LANES), [0] * LANES)
            return builder.shuffle_vector(first, undefined, everywhere)

        above = builder.icmp_signed(">", load(heights), builder.add(load(falls), spread(here)))
        from_last = ir.Constant(ir.VectorType(_INDEX, LANES), list(range(LANES, 0, -1)))
        kept = builder.icmp_signed("<=", from_last, spread(builder.trunc(keep, _INDEX)))
        bits = builder.bitcast(builder.and_(above, kept), ir.IntType(LANES))
        return builder.icmp_unsigned("!=", bits, ir.Constant(bits.type, 0))

    return signature, generate
