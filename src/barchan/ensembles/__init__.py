"""Many runs of one scenario: plans, members brought to their end by any executor, results as one dataset.

Each member is an ordinary run. Nothing here draws pictures or compares.
"""
