"""Arrays lent to kernels, which then do not count references to them.

Kernels make no arrays, and whoever calls them holds those that they get. Numba counts all the same, wherever
a branch hides from it that nothing changes: some hundred atomic additions for each grain that lands, more
than all its arithmetic, and two threads wait for each other at every one. An array without an owner has
nothing to count. Bits do not depend on it.
"""

from numba import types
from numba.core import cgutils
from numba.extending import intrinsic


def _without_owner(context, builder, kind, value):
    if isinstance(kind, types.Array):
        array = cgutils.create_struct_proxy(kind)(context, builder, value=value)
        array.meminfo = cgutils.get_null_value(array.meminfo.type)
        return array._getvalue()
    if isinstance(kind, types.BaseTuple):
        for at, part in enumerate(kind.types):
            lent_part = _without_owner(context, builder, part, builder.extract_value(value, at))
            value = builder.insert_value(value, lent_part, at)
    return value


@intrinsic
def borrowed(_typing_context, values):
    """The same ``values``, arrays and numbers in tuples of any depth, on loan from the caller.

    They must not outlive the kernel that asks for them, and they must be its arguments: an array that the
    kernel has made itself has no other owner, and its memory would be free at once.
    """

    def generate(context, builder, _signature, arguments):
        return _without_owner(context, builder, values, arguments[0])

    return values(values), generate
