"""A decorator for functions that only kernels call: they need no wrapper for Python.

To take a rule apart that Python hands over takes more code, and longer to compile, than most such functions.
"""

from functools import partial

from numba import njit

internal = partial(njit, cache=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)

woven = partial(internal, inline="always")
"""The same for a function that becomes a part of the one that calls it before either is compiled.

A function of its own is compiled once by itself and again within every function above it, so each layer of a
long chain of calls costs as much as the whole of what lies below. Of layers that do little themselves only
the lowest and the highest should stand alone.
"""
