"""The shape of the ground, the first sand on it, and brushes that change the sand.

Surfaces are made from parameters and random streams alone; nothing here knows of models.
"""
