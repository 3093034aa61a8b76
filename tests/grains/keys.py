"""Parameters of closures, written in one line."""


def nested(**keys):
    """Groups of parameters, from names such as ``feedback__length``."""
    found = {}
    for name, value in keys.items():
        *groups, last = name.split("__")
        group = found
        for one in groups:
            group = group.setdefault(one, {})
        group[last] = value
    return found
