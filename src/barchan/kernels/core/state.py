"""Widths that callers of kernels must know. Nothing here imports the compiler."""

SIMD_WIDTH = 16


TRAVEL_UNIT = 1 << 16
"""Parts of a cell in which travel is counted, so that sums are exact."""

LINE = 16
"""Numbers apart that never share a line of any cache."""
