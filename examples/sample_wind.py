"""Make the wind record that ships with Barchan: three years of hours at no real place.

Two seasons with two winds, stronger in the afternoon, with storms, calms and hours without a value. Each
season's speed has a Weibull distribution; a first-order autoregressive process correlates hour with hour.

Run ``python examples/sample_wind.py FILE`` to write it.
"""

import gzip
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.special import ndtr, ndtri

HOURS = 3 * 365 * 24
MEMORY = 0.93
"""Correlation from one hour to the next."""
CALM = 0.6
"""Speeds below this (m/s) are recorded as calm, without a direction."""
MISSING = 0.012
"""Share of hours without a value, besides a fortnight when the station was out of order."""


@dataclass(frozen=True)
class Season:
    """A season's wind."""

    direction: float  # where it comes from (degrees)
    spread: float  # standard deviation of the direction (degrees)
    scale: float  # of the Weibull distribution of speeds (m/s)
    shape: float
    diurnal: float  # share by which the speed swings between night and afternoon


SUMMER = Season(direction=340.0, spread=20.0, scale=5.2, shape=2.1, diurnal=0.45)
WINTER = Season(direction=235.0, spread=24.0, scale=6.2, shape=1.8, diurnal=0.15)


def main(path: Path) -> None:
    path.write_bytes(gzip.compress(sample().encode("utf-8"), compresslevel=9, mtime=0))


def sample() -> str:
    """The record as a table of text."""
    random = np.random.default_rng(1979)
    strength, veer = (remembered(random.random(HOURS)) for _ in range(2))
    gone = random.random(HOURS) < MISSING
    hours = np.arange(HOURS)
    gone |= (hours >= 9000) & (hours < 9000 + 14 * 24)
    summer = summer_share(hours / 24.0)
    is_summer = random.random(HOURS // 24).repeat(24) < summer
    speed = np.where(is_summer, speeds(SUMMER, strength, hours), speeds(WINTER, strength, hours))
    direction = np.where(
        is_summer, SUMMER.direction + SUMMER.spread * veer, WINTER.direction + WINTER.spread * veer
    )
    times = np.datetime64("2021-01-01T00:00") + hours.astype("timedelta64[h]")
    lines = [
        "# A made-up record: see examples/sample_wind.py. No real station.",
        "time,speed (m/s),direction (deg)",
    ]
    for time, u, d, absent in zip(times, speed, direction % 360.0, gone, strict=True):
        value = "," if absent else "0.0," if u < CALM else f"{u:.1f},{round(d) % 360}"
        lines.append(f"{time},{value}")
    return "\n".join(lines) + "\n"


def remembered(uniform: np.ndarray) -> np.ndarray:
    """Normal numbers, each correlated with the one before it."""
    fresh = ndtri(uniform)
    out = np.empty_like(fresh)
    out[0] = fresh[0]
    for k in range(1, len(out)):
        out[k] = MEMORY * out[k - 1] + np.sqrt(1 - MEMORY**2) * fresh[k]
    return out


def summer_share(days: np.ndarray) -> np.ndarray:
    """Chance that a day is one of summer: sure in July, none in January."""
    return np.clip(0.5 - 0.9 * np.cos(2 * np.pi * (days[::24] - 15) / 365), 0.0, 1.0).repeat(24)


def speeds(season: Season, strength: np.ndarray, hours: np.ndarray) -> np.ndarray:
    """Speeds (m/s) of a season, highest at three in the afternoon."""
    weibull = season.scale * (-np.log1p(-ndtr(strength))) ** (1 / season.shape)
    return weibull * (1 + season.diurnal * np.cos(2 * np.pi * (hours - 15) / 24))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
