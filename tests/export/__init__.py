"""Frames of runs that go to other programs."""
