"""Which way crests should run under given winds: three rules from the literature.

On a bed of sand, crests take the direction that grows fastest: across the wind for one wind, a compromise for
several. Where sand is scarce, dunes grow as fingers along the flux over their own crest.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.theory.drift import Drift

SPEEDUP = 1.6
"""γ, how much the flux grows up to a crest that lies across the wind: Courrech du Pont et al. (2014)."""

TIE = 0.01
"""Crest directions whose growth differs by less than this share are equally good; ours."""

FINEST = 0.1
"""Degrees from one direction that is tried to the next."""


@dataclass(frozen=True)
class Crest:
    """A predicted crest direction."""

    azimuth: float
    """Degrees clockwise from north, in [0, 180); NaN where there is none."""
    rivals: tuple[float, ...] = ()
    """Other directions that are as good within 1 %: with them the prediction is ambiguous."""
    contrast: float = float("nan")
    """1 less the worst over the best direction's growth: near 0 if no direction stands out."""

    @property
    def ambiguous(self) -> bool:
        """Whether other directions are as good."""
        return bool(self.rivals)


def gross_transport(drift: Drift, speedup: float = 0.0) -> Crest:
    """The crest with the most sand moving across it, one way or the other.

    Maximises ``Σ q_i (|sin| + γ sin²)`` of the angles between crest and winds. γ = 0 is the gross
    bedform-normal transport of Rubin & Hunter (1987, Science 237, 276); γ = 1.6, the bed instability of
    Courrech du Pont et al. (2014, Geology 42, 743), takes the speed-up over the crest into account.
    """
    azimuths = np.arange(0.0, 180.0, FINEST)
    if not drift.total > 0:
        return Crest(float("nan"))
    growth = _growth(azimuths, _few(drift), speedup)
    contrast = 1.0 - float(growth.min() / growth.max())
    if contrast < TIE:
        return Crest(float("nan"), (), contrast)
    best, *rivals = _summits(azimuths, growth)
    return Crest(best, tuple(rivals), contrast)


def bed_instability(drift: Drift) -> Crest:
    """The crest of a bed full of sand, by Courrech du Pont et al. (2014)."""
    return gross_transport(drift, SPEEDUP)


def elongation(drift: Drift, speedup: float = SPEEDUP) -> float:
    """Where fingers of scarce sand grow to, degrees clockwise from north; NaN where they grow nowhere.

    The direction along which the resultant of the flux over the crest, ``q_i (1 + γ |sin|)``, points itself:
    Courrech du Pont et al. (2014, Geology 42, 743). Of several, the one with the largest flux.
    """
    few = _few(drift)
    toward = np.arange(0.0, 360.0, FINEST)
    angle = np.radians(few.direction + 180.0)[:, None] - np.radians(toward)
    over = few.amount[:, None] * (1.0 + speedup * np.abs(np.sin(angle)))
    across, along = (over * np.sin(angle)).sum(0), (over * np.cos(angle)).sum(0)
    noise = 1e-9 * few.total
    turns = (across >= -noise) & (np.roll(across, -1) < -noise) & (along > noise)
    if not turns.any():
        return float("nan")
    place = int(np.flatnonzero(turns)[np.argmax(along[turns])])
    before, after = across[place], np.roll(across, -1)[place]
    return float((toward[place] + FINEST * before / (before - after)) % 360.0)


def _few(drift: Drift) -> Drift:
    """The drift by whole degrees, where its winds are many."""
    return drift.by_degree() if len(drift.direction) > 1000 else drift


def _growth(azimuths: NDArray, drift: Drift, speedup: float) -> NDArray[np.float64]:
    across = np.abs(np.sin(np.radians(azimuths[:, None] - drift.direction)))
    return (across + speedup * across**2) @ drift.amount


def _summits(azimuths: NDArray, growth: NDArray) -> list[float]:
    """Directions that are the best of their neighbourhood and nearly the best of all, the best first.

    A flat top, where neighbours are equal, counts once, by its middle.
    """
    before, after = np.roll(growth, 1), np.roll(growth, -1)
    level = 1e-12 * growth.max()
    tops = np.flatnonzero((growth >= before - level) & (growth >= after - level))
    tops = tops[growth[tops] >= (1.0 - TIE) * growth.max()]
    groups = np.split(tops, np.flatnonzero(np.diff(tops) > 1) + 1)
    if len(groups) > 1 and groups[0][0] == 0 and groups[-1][-1] == len(azimuths) - 1:
        groups[0] = np.concatenate([groups.pop() - len(azimuths), groups[0]])
    found = [(-growth[group].max(), float(np.mean(group) * FINEST % 180.0)) for group in groups]
    return [round(azimuth, 6) for _, azimuth in sorted(found)]
