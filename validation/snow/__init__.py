"""Studies of snow that have not been run yet: ``python -m validation.snow [ranges] [arrest] [diagram]``.

They print their rows. Once run they become studies like the others, with a reading of their results.
"""
