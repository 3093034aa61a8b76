"""A decorator for functions that only kernels call: they need no wrapper for Python.

To take a rule apart that Python hands over takes more code, and longer to compile, than most such functions.
"""

from functools import partial

from numba import njit

internal = partial(njit, cache=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
