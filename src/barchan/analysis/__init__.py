"""Analysis of runs: measures over time, fields by name, paths of grains.

Measures themselves are in ``measures``, what theory expects of a wind in ``theory``.
"""
