"""Units of fields and parameters in the words of UDUNITS, which the CF conventions ask for."""

import re

_ATOMS = {
    "m": "m",
    "µm": "um",
    "kg": "kg",
    "s": "s",
    "h": "h",
    "days": "day",
    "yr": "year",
    "K": "K",
    "°C": "degC",
    "Pa": "Pa",
    "J": "J",
    "mol": "mol",
    "degrees": "degree",
    **dict.fromkeys(
        (
            *("1", "-", "fraction", "bonding time", "bounces", "cell", "cells", "grain diameters", "grains"),
            *("hops", "iterations", "layers", "parcels", "quanta", "slab", "slabs", "step", "steps"),
        ),
        "",
    ),
}
"""Units that others are made of; counts, and ratios to what the run itself sets, are plain numbers."""

_POWERS = {"": 1, "²": 2, "³": 3}

_CONDITION = re.compile(r" at .*")
"""What a value is reduced to, as in hours at -10 °C: it changes no unit."""

_NUMBER = re.compile(r"\d*\.?\d+")


def udunits(unit: str) -> str | None:
    """A unit as UDUNITS spells it, ``1`` for plain numbers; None for one that is not known."""
    over, *under = _CONDITION.sub("", unit).split("/")
    numerator = [over] if over in _ATOMS else over.split()
    factor = numerator.pop(0) if len(numerator) > 1 and _NUMBER.fullmatch(numerator[0]) else ""
    parts = [(factor, 1)] if factor else []
    for sign, atoms in ((1, numerator), (-1, under)):
        for atom in atoms:
            name = atom.rstrip("²³")
            if name not in _ATOMS:
                return None
            parts.append((_ATOMS[name], sign * _POWERS[atom.removeprefix(name)]))
    told = [f"{name}{power}" if power != 1 else name for name, power in parts if name]
    return " ".join(told) or "1"


def cf_units(unit: str) -> dict[str, str]:
    """The attributes of a variable that tell its unit: in CF's words where there are any, and in ours."""
    known = udunits(unit)
    return {**({} if known is None else {"units": known}), "unit": unit}
