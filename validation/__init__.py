"""Comparisons with published results, a script each: ``python -m validation`` writes docs/validation.md."""
