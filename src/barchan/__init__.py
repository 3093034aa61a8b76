"""Surfaces that wind shapes."""
