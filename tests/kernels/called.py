"""Kernels that only other kernels call, called from Python."""

from functools import cache

from numba import njit


@cache
def from_python(kernel):
    """A kernel that has no wrapper for Python, within a function that has one."""

    @njit
    def call(*arguments):
        return kernel(*arguments)

    return call
