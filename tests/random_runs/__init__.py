"""Runs of scenarios drawn at random from the declarations, and what must hold for each."""
