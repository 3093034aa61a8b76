"""What a model adds to slab transport."""

from dataclasses import dataclass


@dataclass(frozen=True)
class HopRule:
    """How hops grow with height above a reference: cells a slab, and a slab squared."""

    linear: float
    quadratic: float
    follows_relief: bool
    """Whether the reference is the mean less half the mean distance from it, or the mean itself."""
    whole: bool
    every_hop: bool


@dataclass(frozen=True)
class Giving:
    """Chance that a polled cell gives a slab: ``share`` times its mobility, plus ``shift``."""

    share: float = 1.0
    shift: float = 0.0


@dataclass(frozen=True)
class Rules:
    """What a model adds to slab transport."""

    hop: HopRule | None = None
    giving: Giving = Giving()
    firm_angle: float | None = None
    """Angle of repose (degrees) of firm cells."""
    firm_mobility: float = 0.0
    """Mobility up to which a cell is firm."""
