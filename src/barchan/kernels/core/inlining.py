"""Keeping rarely used code out of hot loops.

LLVM inlines a function that is called from one place only, and Numba inlines every function that it compiles
on behalf of one with ``forceinline``. The registers that the rare code needs are then missing in the loop.
"""

from typing import Any

from numba import types
from numba.extending import intrinsic


@intrinsic
def never_inline(typing: Any) -> Any:
    """Keep the function that calls this out of line, wherever it is called."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        builder.function.attributes.discard("alwaysinline")
        builder.function.attributes.add("noinline")
        return context.get_dummy_value()

    return types.none(), generate
