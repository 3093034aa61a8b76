"""Compiling kernels that do not count references to arrays.

Kernels make no arrays, and whoever calls them holds those that they get. Numba counts all the same, wherever
a branch hides from it that nothing changes: some hundred atomic additions for each grain that lands, more
than all its arithmetic, and two threads wait for each other at every one. Bits do not depend on it.
"""

from typing import Any

from numba import njit
from numba.core.options import DefaultOptions

_OPTIONS: dict[str, Any] = {"cache": True, "nogil": True, "error_model": "numpy"}
if hasattr(DefaultOptions, "_nrt"):
    # not among Numba's documented options: without it kernels are slower, and nothing else
    _OPTIONS["_nrt"] = False

uncounted = njit(**_OPTIONS)
"""Compile a kernel of arrays and numbers that makes no array."""

uncounted_inline = njit(**_OPTIONS, forceinline=True)
"""The same of a part of one, put in wherever it is called."""
