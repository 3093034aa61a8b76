"""Names, units, height and convention of a file's columns, and its marks of missing values."""

from typing import Literal

from barchan.aeolian.snow.density import GREATEST_DENSITY, LEAST_DENSITY
from barchan.missing import Marks, codes_in, missing_key, texts_in
from barchan.parameters import Parameters, parameter
from barchan.wind.records.units import AngleUnit, SpeedUnit

MISSING = [
    -9999.0, -999.0, -999.9, -99.9, 999.0, 999.9, 9999.0, 99999.0, -9999.9, -99999.0, -32768.0,
    -32767.0, 9999.9,
]  # fmt: skip
"""Numbers that usually stand for a missing value."""

USUAL_TEXTS = frozenset((
    "", "-", "--", "---", "m", "mm", "mq", "na", "n/a", "#n/a", "nan", "null", "none", "missing", "nd", "*",
    "***", "/", "//", "///",
))  # fmt: skip
"""Texts that stand for a missing value among numbers, in lower case."""


class RecordFormat(Parameters):
    """How a wind record is written, where the file does not say it."""

    time: str | None = parameter(
        None,
        unit="-",
        meaning="Column of the times; guessed where it is not given. date+hour joins two columns.",
    )
    speed: str | None = parameter(
        None, unit="-", meaning="Column of the speeds; guessed where it is not given."
    )
    direction: str | None = parameter(
        None, unit="-", meaning="Column of the directions; guessed where it is not given."
    )
    eastward: str | None = parameter(
        None, unit="-", meaning="Column of the eastward wind u; guessed where it is not given."
    )
    northward: str | None = parameter(
        None, unit="-", meaning="Column of the northward wind v; guessed where it is not given."
    )
    temperature: str | None = parameter(
        None, unit="-", meaning="Column of the temperature of the air; guessed where it is not given."
    )
    snowfall: str | None = parameter(
        None,
        unit="-",
        meaning="Column of the snowfall, a rate or the amount since the row before; guessed where it is not "
        "given.",
    )
    precipitation: str | None = parameter(
        None,
        unit="-",
        meaning="Column of rain and snow together, parted by temperature; guessed where it is not given.",
    )
    rain_share: str | None = parameter(
        None,
        unit="-",
        meaning="Column of the share of precipitation that is rain, 0 to 1, as SMET's PSUM_PH; guessed where "
        "it is not given.",
    )
    precipitation_type: str | None = parameter(
        None,
        unit="-",
        meaning="Column of the type of precipitation in ERA5's codes (ptype); guessed where it is not given.",
    )
    accumulated: bool | None = parameter(
        None,
        unit="-",
        meaning="Whether amounts of snowfall and precipitation are running sums that start over at one time "
        "of the day, as in ERA5-Land; where it is not given they are those since the row before.",
    )
    snow_depth: str | None = parameter(
        None,
        unit="-",
        meaning="Column of the depth of snow: where neither snowfall nor precipitation is known, snow falls "
        "as it rises. Guessed in SMET (HS), elsewhere only read where it is given.",
    )
    fresh_density: float | None = parameter(
        None,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        meaning="Density of fresh snow by which a rising depth counts; by temperature where it is not given.",
        source="by temperature: Hedstrom & Pomeroy 1998",
    )
    boom_height: str | None = parameter(
        None,
        unit="-",
        meaning="Column of the height of the wind's sensor over the snow, by which each row's speed is "
        "brought to 10 m; known of PROMICE and GC-Net where it is not given.",
    )
    unit: SpeedUnit | None = parameter(
        None, unit="-", meaning="Unit of the speeds; from the file where it is not given, else m/s."
    )
    direction_unit: AngleUnit | None = parameter(
        None, unit="-", meaning="Unit of the directions; from the file where it is not given, else degrees."
    )
    convention: Literal["from", "to"] | None = parameter(
        None,
        unit="-",
        meaning="Whether directions are where the wind comes from or goes to; from the file where it is not "
        "given, else from.",
    )
    height: float | None = parameter(
        None,
        unit="m",
        gt=0,
        le=1000,
        meaning="Height of the speeds above the ground: which of several, or that of a file that does "
        "not state it.",
    )
    time_format: str | None = parameter(
        None,
        unit="-",
        meaning="How times are written, as in %d.%m.%Y %H:%M, or the unit of counted times (s, min, h, d); "
        "ISO 8601 where it is not given.",
    )
    time_zone: str | None = parameter(
        None,
        unit="-",
        pattern=r"^(?:UTC|Z|[+-](?:0\d|1[0-4]):[0-5]\d)$",
        examples=["+01:00", "UTC"],
        meaning="Zone of times that state none, as +01:00 or UTC: times are then turned to UTC.",
    )
    missing: Marks = missing_key(
        lambda: list(MISSING),
        "Numbers, in the file's own unit, and texts, in upper or lower case,",
        ". Numbers replace the usual codes; texts count beside the usual ones, such as NA, M, /// and -.",
    )
    skip_rows: int = parameter(0, unit="-", ge=0, meaning="Lines to pass over at the top of a table.")
    sheet: str | None = parameter(
        None, unit="-", meaning="Sheet of a spreadsheet; the first where it is not given."
    )
    station: str | None = parameter(None, unit="-", meaning="Which station of a table that holds several.")
    member: int | None = parameter(None, unit="-", ge=0, meaning="Which member of an ensemble.")
    latitude: float | None = parameter(
        None, unit="degrees", ge=-90, le=90, meaning="Which point of a grid to read: the nearest to it."
    )
    longitude: float | None = parameter(
        None, unit="degrees", ge=-180, le=360, meaning="Which point of a grid to read: the nearest to it."
    )

    @property
    def codes(self) -> list[float]:
        """Numbers for a missing value: the stated ones, or the usual ones where texts alone are stated."""
        return self.stated_codes if self.stated_codes or not self.missing else list(MISSING)

    @property
    def stated_codes(self) -> list[float]:
        """Numbers that the user states beside or in place of the usual ones."""
        codes = codes_in(self.missing)
        return [] if codes == MISSING else codes

    @property
    def texts(self) -> frozenset[str]:
        """Texts that stand for a missing value, in lower case."""
        return USUAL_TEXTS | texts_in(self.missing)
