"""The engine of slab models: base class, parameters, rules, and the code that makes kernel structs of them.

Published models stand in ``models``, one a file; nothing here is one.
"""
