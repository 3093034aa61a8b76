"""Expectations of theory for a wind: drift potential, crest orientation, variability, dune types, roses.

Nothing here looks at a bed or a run.
"""
