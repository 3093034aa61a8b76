"""The engine of slab models: base class, parameters, rules, and what turns them into kernel structs.

Published models stand in ``models``, one a file; nothing here is one.
"""
