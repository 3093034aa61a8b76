"""Names and units of a file's columns, and its marks of missing values."""

from typing import Literal

from barchan.parameters import Parameters, parameter

UNITS: dict[str, float] = {"m/s": 1.0, "kn": 1852 / 3600, "km/h": 1 / 3.6, "mph": 0.44704}
"""Metres a second in one unit of speed."""

MISSING = [-9999.0, -999.0, -999.9, -99.9, 999.0, 999.9, 9999.0, 99999.0]


class RecordFormat(Parameters):
    """How a wind record is written, where that cannot be guessed."""

    time: str | None = parameter(
        None,
        unit="-",
        meaning="Column of the times; guessed where it is not given. date+hour joins two columns.",
    )
    speed: str | None = parameter(
        None, unit="-", meaning="Column of the speeds; guessed where it is not given."
    )
    direction: str | None = parameter(
        None,
        unit="-",
        meaning="Column of where the wind comes from (degrees); guessed where it is not given.",
    )
    unit: Literal["m/s", "kn", "km/h", "mph"] | None = parameter(
        None, unit="-", meaning="Unit of the speeds; from the file where it is not given, else m/s."
    )
    time_format: str | None = parameter(
        None, unit="-", meaning="How times are written, as in %d.%m.%Y %H:%M; ISO 8601 where it is not given."
    )
    missing: list[float] = parameter(
        lambda: list(MISSING), unit="-", max_length=100, meaning="Numbers that stand for a missing value."
    )
    latitude: float | None = parameter(
        None, unit="degrees", ge=-90, le=90, meaning="Which point of a grid to read: the nearest to it."
    )
    longitude: float | None = parameter(
        None, unit="degrees", ge=-180, le=360, meaning="Which point of a grid to read: the nearest to it."
    )
