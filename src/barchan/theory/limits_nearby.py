"""How near a wind lies to the limits of its classes, and the class or dune to expect beyond them."""

import math
from collections.abc import Iterator
from dataclasses import replace

from barchan.theory.drift import Drift
from barchan.theory.dune_types import PLENTY, STEADINESS, dune_type
from barchan.theory.variability import LIMITS, Limits, variability

NEAR_SHARE = 0.05
"""Share of the drift, or RDP/DP, within which a limit is near; ours."""

NEAR_ANGLE = 10.0
"""Degrees within which a limit is near; ours."""

NEAR_PEAK = 0.05
"""Share of a height within which the limit of a mode is near; ours."""

NEAR_SUPPLY = 1.5
"""Factor within which the limit of the sand's thickness is near; ours."""


def class_nearby(drift: Drift) -> list[str]:
    """The directional classes that a drift would be of if a limit of the classes were a little other.

    Which limit, its value and the one tried are named; empty where no class is near.
    """
    own = variability(drift)
    said, seen = [], {own.name}
    for words, limits in _tried():
        other = variability(drift, limits).name
        if other not in seen:
            seen.add(other)
            said.append(f"the directions are nearly {other}: they would be so {words}")
    return said


def _tried() -> Iterator[tuple[str, Limits]]:
    """Limits that differ from the usual ones in one number, and in what, in words."""
    for sign in (-1, 1):
        share = LIMITS.narrow + sign * NEAR_SHARE
        yield (
            f"if narrow were {100 * share:.0f} % from within 45° ({100 * LIMITS.narrow:.0f} %)",
            replace(LIMITS, narrow=share),
        )
        angle = LIMITS.acute + sign * NEAR_ANGLE
        yield (
            f"if two winds counted as acute up to {angle:.0f}° ({LIMITS.acute:.0f}°)",
            replace(LIMITS, acute=angle),
        )
        least, above = (value + sign * NEAR_PEAK for value in (LIMITS.least, LIMITS.prominence))
        yield (
            f"if a peak counted from {100 * least:.0f} % of the highest on ({100 * LIMITS.least:.0f} %)",
            replace(LIMITS, least=least),
        )
        yield (
            f"if peaks counted that rise by {100 * above:.0f} % ({100 * LIMITS.prominence:.0f} %)",
            replace(LIMITS, prominence=above),
        )


def dunes_nearby(steadiness: float, supply: float | None = None) -> list[str]:
    """The other dunes to expect where RDP/DP or the supply (m) is near a limit of theirs; empty elsewhere."""
    own, said = dune_type(steadiness, supply), []
    if math.isnan(steadiness):
        return []
    for limit in STEADINESS:
        if abs(steadiness - limit) <= NEAR_SHARE:
            beyond = limit + NEAR_SHARE if steadiness <= limit else limit - NEAR_SHARE
            side = "above" if steadiness <= limit else "below"
            said.append(
                f"RDP/DP {steadiness:.2f} is near {limit:g}, {side} which one would expect "
                f"{dune_type(beyond, supply)}"
            )
    if supply is not None and PLENTY / NEAR_SUPPLY <= supply <= PLENTY * NEAR_SUPPLY:
        other = dune_type(steadiness, 0.0 if supply >= PLENTY else PLENTY)
        side = "less" if supply >= PLENTY else "more"
        if other != own:
            said.append(f"the sand supply of {supply:.3g} m is near {PLENTY:g} m; with {side} sand: {other}")
    return said
