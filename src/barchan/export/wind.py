"""The wind over a frame, for programs that show vectors."""

import math
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import as_modelled
from barchan.export.numbers import plain
from barchan.export.source import Sheet, Source


@dataclass(frozen=True)
class WindOver:
    """The wind over a whole frame; of several in a step where their mean transport comes from."""

    direction: float
    """Where it comes from, degrees clockwise from north."""
    speed: float | None
    """Its speed (m/s), where it states one."""
    friction_velocity: float | None
    """Friction velocity (m/s) over a flat bed, of models that know one."""

    @classmethod
    def of(cls, source: Source, step: int) -> Self:
        """The wind over a frame of a run."""
        model, _, segment = as_modelled(source.frame(step), source.scenario)
        speed = segment.speed if segment.driving_speed is None else segment.driving_speed
        return cls(segment.direction, speed, model.friction_velocity(segment))

    @property
    def towards(self) -> NDArray[np.float64]:
        """Where it blows: a vector (east, north, up) of length 1."""
        angle = math.radians(self.direction)
        return np.array([-math.sin(angle), -math.cos(angle), 0.0])

    @property
    def arrays(self) -> dict[str, NDArray[np.float64]]:
        """The wind as data of the whole field: ``wind`` (m/s, or of length 1), direction, friction."""
        found = {
            "wind": self.towards * (1.0 if self.speed is None else self.speed),
            "wind_from": np.array([self.direction]),
        }
        if self.friction_velocity is not None:
            found["wind_friction_velocity"] = np.array([self.friction_velocity])
        return found

    @property
    def facts(self) -> dict[str, Any]:
        """What the side-car file says of it."""
        unit = "1" if self.speed is None else "m/s"
        return {
            "wind": {
                "points": "where it blows: x to the east, y to the north",
                "unit": unit,
                "wind_from": "degrees",
            }
        }

    def over(self, sheets: dict[str, Sheet]) -> dict[str, NDArray]:
        """The values of fields; of those that point along the wind vectors (east, north, up) too."""
        found: dict[str, NDArray] = {}
        for name, sheet in sheets.items():
            found[name] = plain(sheet.values)
            if sheet.along_wind:
                found[f"{name}_vector"] = plain(sheet.values[..., None] * self.towards)
        return found
