"""Grains in flight: drag and gravity, landing, splash, creep, entrainment, and the parcels they exchange.

Nothing here knows which published model it serves: closures are data.
"""
