"""Analysis of runs: declared measures and their doubts, measures over time, fields by name, paths of grains.

Measures themselves are in ``measures``, expectations of theory in ``theory``.
"""
