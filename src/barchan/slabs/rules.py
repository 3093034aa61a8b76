"""The rules that a model adds to slab transport."""

from dataclasses import dataclass

from barchan.checked import finite


@dataclass(frozen=True)
class HopRule:
    """How hops grow with height above a reference: cells a slab, and a slab squared."""

    linear: float
    quadratic: float
    follows_relief: bool
    """Whether the reference is the mean less half the mean distance from it, or the mean itself."""
    whole: bool
    every_hop: bool

    def __post_init__(self) -> None:
        """Refuse growth that is no number."""
        finite(self.linear, "linear growth of hops")
        finite(self.quadratic, "quadratic growth of hops")


@dataclass(frozen=True)
class ErosionChance:
    """Chance that a polled cell erodes: ``factor`` times its mobility, plus ``offset``."""

    factor: float = 1.0
    offset: float = 0.0

    def __post_init__(self) -> None:
        """Refuse chances that are no numbers."""
        finite(self.factor, "factor of the chance of erosion")
        finite(self.offset, "offset of the chance of erosion")


@dataclass(frozen=True)
class Rules:
    """The rules that a model adds to slab transport."""

    hop: HopRule | None = None
    erosion: ErosionChance = ErosionChance()
    stabilised_angle: float | None = None
    """Angle of repose (degrees) of stabilised cells, those where plants hold the sand."""
    stabilised_mobility: float = 0.0
    """Mobility up to which a cell is stabilised."""
