"""The engine of models of grains in flight: base class, closures, and code that makes kernel structs.

Published models stand in ``models``, one a file; nothing here is one.
"""
