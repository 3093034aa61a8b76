"""Analysis of runs: measures over time, fields by name, paths of grains.

Measures themselves are in ``measures``, expectations of theory in ``theory``.
"""
