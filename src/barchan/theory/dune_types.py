"""Which dunes to expect from a wind and a supply of sand: a rule of thumb.

After the diagram of Wasson & Hyde (1983, Nature 304, 337), equivalent sand thickness against RDP/DP, and the
mean RDP/DP that Fryberger & Dean (1979) found: about 0.7 for barchanoid, 0.45 for linear, 0.2 for star dunes.
Fields of dunes scatter widely about it; vegetation, history and the lie of the land are left out.
"""

import math

STEADINESS = (0.3, 0.7)
"""RDP/DP between complex, intermediate and steady winds."""

PLENTY = 3.0
"""Equivalent sand thickness (m) from which sand is plentiful; ours, for the diagram has no such line."""

TYPES = {
    "steady": ("barchans", "transverse dunes"),
    "intermediate": ("isolated linear dunes", "linear dunes, close and compound"),
    "complex": ("isolated domes", "star dunes and networks"),
}
"""Dunes where sand is scarce and where it is plentiful, by the wind's steadiness."""


def dune_type(steadiness: float, supply: float | None = None) -> str:
    """The expected dunes, by RDP/DP and equivalent sand thickness (m): all sand spread evenly.

    Without a supply both kinds are given; if nothing moves, none.
    """
    if math.isnan(steadiness):
        return "none: nothing moves"
    complex_below, steady_from = STEADINESS
    wind = (
        "complex" if steadiness < complex_below else "steady" if steadiness > steady_from else "intermediate"
    )
    scarce, plentiful = TYPES[wind]
    if supply is None:
        return f"{scarce} where sand is scarce, {plentiful} where it is plentiful"
    return plentiful if supply >= PLENTY else scarce
