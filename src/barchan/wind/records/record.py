"""A wind record: speed and direction over time; and the rows of a file that it is made of."""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class WindlessRows:
    """Rows of a record that hold weather and no wind."""

    time: NDArray[np.float64]
    """Beginning of each row (s), as in the record."""
    duration: NDArray[np.float64]
    """How long it stands for (s)."""
    temperature: NDArray[np.float64] | None = None
    """Of the air (°C)."""
    snowfall: NDArray[np.float64] | None = None
    """kg/m²/s."""


@dataclass(frozen=True)
class WindRecord:
    """Winds in the order of time, each with its duration; missing rows are left out and counted."""

    time: NDArray[np.float64]
    """Beginning of each wind (s) since ``start``."""
    duration: NDArray[np.float64]
    """How long it stands for (s)."""
    speed: NDArray[np.float64]
    """m/s."""
    direction: NDArray[np.float64]
    """Where it comes from, degrees clockwise from north in [0, 360); 0 in a calm.

    A wind without a known direction (``undirected``) has that of the wind before it.
    """
    start: np.datetime64 | None = None
    """Time of the first row where the file has dates."""
    missing: int = 0
    """Rows without a speed."""
    gaps: int = 0
    """Times at which rows are absent from the file."""
    source: str = ""
    """Where it is from."""
    remarks: tuple[str, ...] = field(default=())
    """Assumptions made in reading it."""
    height: float | None = None
    """Height of the speeds above the ground (m), where the file or the user states it."""
    format: str = ""
    """Whose format the file is in, where it is one that is known."""
    columns: str = ""
    """The columns that were read as the wind."""
    place: str = ""
    """The point of a grid that was read."""
    duplicates: int = 0
    """Rows of a time that another row already has, left out."""
    warnings: tuple[str, ...] = field(default=())
    """What makes the record implausible."""
    direction_width: float = 0.0
    """Degrees that each direction stands for, as 10 where all are multiples of 10; 0 where they are exact."""
    temperature: NDArray[np.float64] | None = None
    """Of the air (°C), NaN where a row states none; None where the record has none."""
    snowfall: NDArray[np.float64] | None = None
    """kg/m²/s, NaN where a row states none; None where the record has none."""
    windless: WindlessRows | None = None
    """Rows that hold weather and no wind, where the record has any."""
    supposed: NDArray[np.bool_] | None = None
    """Rows in gaps, whose wind is supposed and not measured; None where there are none."""
    undirected: NDArray[np.bool_] | None = None
    """Rows that state a speed and no direction while the air moved (VRB); None where there are none."""
    unit_stated: bool = True
    """Whether file or user state the unit of the speeds."""
    utc: bool = False
    """Whether times are in UTC, as the file or the user states a zone; else they are as the file has them."""

    @property
    def measured(self) -> "WindRecord":
        """The record without the rows whose wind is supposed."""
        if self.supposed is None:
            return self
        return replace(self.picked(~self.supposed), supposed=None)

    def picked(self, which: NDArray) -> "WindRecord":
        """The record with some of its rows, by a mask or by numbers, each with its own duration."""
        return replace(
            self,
            time=self.time[which],
            duration=self.duration[which],
            speed=self.speed[which],
            direction=self.direction[which],
            temperature=None if self.temperature is None else self.temperature[which],
            snowfall=None if self.snowfall is None else self.snowfall[which],
            supposed=None if self.supposed is None else self.supposed[which],
            undirected=None if self.undirected is None else self.undirected[which],
        )

    @property
    def without_direction(self) -> NDArray[np.bool_]:
        """For each row whether its direction is not known while the air moves."""
        return np.zeros(len(self), bool) if self.undirected is None else self.undirected

    @property
    def calm_share(self) -> float:
        """Share of calms in the time whose speed is known."""
        return float(self.duration[self.speed == 0.0].sum()) / self.seconds

    @property
    def calms(self) -> int:
        """Rows without wind."""
        return int(np.count_nonzero(self.speed == 0.0))

    @property
    def seconds(self) -> float:
        """Time that the record covers (s), missing rows left out."""
        return float(self.duration.sum())

    def __len__(self) -> int:
        """Number of winds."""
        return len(self.time)


@dataclass(frozen=True)
class Rows:
    """The rows of a file, not yet checked; NaN where a value is missing."""

    source: str
    time: NDArray[np.float64]
    """Seconds since ``start``, in the order of the file."""
    start: np.datetime64 | None
    speed: NDArray[np.float64]
    """m/s."""
    direction: NDArray[np.float64]
    names: dict[str, str]
    """Names of time, speed and direction in the file."""
    numbers: NDArray[np.int64]
    """Number of each row in the file."""
    unit: tuple[str, float] = ("m/s", 1.0)
    """Unit of the file's speeds and how many m/s it is."""
    remarks: tuple[str, ...] = ()
    height: float | None = None
    """Height of the speeds (m), where it is known."""
    format: str = ""
    temperature: NDArray[np.float64] | None = None
    """°C, where the file has it."""
    snowfall: NDArray[np.float64] | None = None
    """kg/m²/s, where the file has it."""
    several_reports: bool = False
    """Whether rows of one time and different winds are usual."""
    place: str = ""
    unit_stated: bool = True
    """Whether file or user state the unit of the speeds."""
    utc: bool = False
    """Whether times are known to be in UTC."""
