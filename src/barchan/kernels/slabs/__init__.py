"""Slabs that the wind takes one by one: polling, shadow, hops, obstacles, a poll, a step.

Nothing here knows which published model it serves: rules are data.
"""
