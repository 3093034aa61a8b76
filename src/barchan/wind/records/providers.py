"""Formats of the usual providers of wind data, recognised by the columns or the first lines of a file.

Each is a declaration of what its provider documents: units, heights, codes and the columns of the time.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from barchan.wind.records.claims import Documented, Stated


@dataclass(frozen=True)
class Provider:
    """A format that is recognised."""

    name: str
    begins: str = ""
    """Word that the file begins with."""
    headings: tuple[str, ...] = ()
    """Columns that all must be there, as spelled; ``a|b`` where either will do."""
    documented: Documented = field(default_factory=dict)
    times: tuple[tuple[str, ...], ...] = ()
    """Columns that make the time: the first of these whose columns are all there."""
    time_format: str | None = None
    row: str = ""
    """Pattern of the rows of a file without a heading."""
    columns: tuple[str, ...] = ()
    """Columns of a file without a heading."""
    station: str = ""
    """Column of the station."""
    several_reports: bool = False
    """Whether a station may report more than once for a time."""
    remark: str = ""
    """Something to know of the format."""
    utc: bool = False
    """Whether its times are in UTC."""

    def fits(self, headings: Sequence[str], text: str) -> bool:
        """Whether a table with these headings, in a file that begins with this text, is in this format."""
        if self.begins:
            return text.lstrip(' "').startswith(self.begins)
        return bool(self.headings) and all(
            any(name in headings for name in wanted.split("|")) for wanted in self.headings
        )

    def fits_rows(self, lines: Sequence[str]) -> bool:
        """Whether rows without a heading are in this format."""
        return bool(self.row) and bool(lines) and all(re.fullmatch(self.row, line.strip()) for line in lines)


def _wind(speed: Stated | tuple[Stated, ...], direction: Stated | tuple[Stated, ...]) -> Documented:
    return {
        "speed": speed if isinstance(speed, tuple) else (speed,),
        "direction": direction if isinstance(direction, tuple) else (direction,),
    }


_NUMBER = r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?"
_DATE = r"(?:18|19|20)\d\d-\d\d-\d\d"
_BOM_TIME = "Year Month Day Hour Minutes in YYYY"
_BOM_END = "MI format in Local"
_ISD_WRONG = ("2", "3", "6", "7")
_METEOSTAT = (
    "date", "hour", "temp", "dwpt", "rhum", "prcp", "snow", "wdir", "wspd", "wpgt", "pres", "tsun", "coco",
)  # fmt: skip

PROVIDERS = (
    Provider(
        "ISD global hourly (NOAA)",
        headings=("STATION", "DATE", "WND"),
        documented=_wind(
            Stated("WND", "0.1 m/s", 10.0, part=3, missing=(9999.0,), doubt=("WND", 4, _ISD_WRONG)),
            Stated("WND", "deg", 10.0, part=0, missing=(999.0,), doubt=("WND", 1, _ISD_WRONG)),
        ),
        times=(("DATE",),),
        utc=True,
        station="STATION",
        several_reports=True,
    ),
    Provider(
        "ISD-Lite (NOAA)",
        utc=True,
        documented=_wind(Stated("speed", "0.1 m/s", 10.0), Stated("direction", "deg", 10.0)),
        times=(("year", "month", "day", "hour"),),
        time_format="%Y %m %d %H",
        row=r"(?:19|20)\d\d\s+\d\d?\s+\d\d?\s+\d\d?(?:\s+-?\d+){8}",
        columns=(
            "year", "month", "day", "hour", "temperature", "dew_point", "pressure", "direction", "speed",
            "sky", "rain_1h", "rain_6h",
        ),
    ),
    Provider(
        "ASOS (Iowa Environmental Mesonet)",
        headings=("station", "valid", "sknt", "drct"),
        documented=_wind(Stated("sknt", "kn", 10.0), Stated("drct", "deg", 10.0)),
        times=(("valid",),),
        station="station",
        several_reports=True,
    ),
    Provider(
        "KNMI hourly",
        utc=True,
        headings=("STN", "YYYYMMDD", "HH|H|UUR", "DD", "FF|FH"),
        documented=_wind(
            (Stated("FF", "0.1 m/s", 10.0), Stated("FH", "0.1 m/s", 10.0)),
            Stated("DD", "deg", 10.0, calm=0.0),
        ),
        times=(("YYYYMMDD", "HH"), ("YYYYMMDD", "H"), ("YYYYMMDD", "UUR")),
        time_format="%Y%m%d %H",
        station="STN",
    ),
    Provider(
        "DWD (Open Data)",
        headings=("STATIONS_ID", "MESS_DATUM", "F|FF|FF_10", "D|DD|DD_10"),
        documented=_wind(
            tuple(Stated(name, "m/s", 10.0) for name in ("F", "FF", "FF_10")),
            tuple(Stated(name, "deg", 10.0) for name in ("D", "DD", "DD_10")),
        ),
        times=(("MESS_DATUM",),),
        station="STATIONS_ID",
    ),
    Provider(
        "Bureau of Meteorology (Australia)",
        headings=(_BOM_TIME, f"{_BOM_END} standard time|{_BOM_END} time"),
        documented=_wind(
            tuple(
                Stated(name, unit, 10.0, doubt=("Quality of wind speed", None, ("W", "S", "I")))
                for unit, word in (("km/h", "km/h"), ("m/s", "m/s"), ("kn", "knots"))
                for name in (f"Wind speed in {word}", f"Wind speed measured in {word}")
            ),
            Stated(
                "Wind direction in degrees true",
                "deg",
                10.0,
                calm=0.0,
                doubt=("Quality of wind direction", None, ("W", "S", "I")),
            ),
        ),
        times=(
            (f"{_BOM_TIME}.1", "MM.1", "DD.1", "HH24.1", f"{_BOM_END} standard time"),
            (_BOM_TIME, "MM", "DD", "HH24", f"{_BOM_END} standard time"),
            (_BOM_TIME, "MM", "DD", "HH24", f"{_BOM_END} time"),
        ),
        time_format="%Y %m %d %H %M",
        station="Station Number",
    ),
    Provider(
        "Environment Canada hourly",
        headings=("Date/Time (LST)|Date/Time", "Wind Dir (10s deg)", "Wind Spd (km/h)"),
        documented=_wind(
            Stated("Wind Spd (km/h)", "km/h", 10.0), Stated("Wind Dir (10s deg)", "10 deg", 10.0, calm=0.0)
        ),
        times=(("Date/Time (LST)",), ("Date/Time",)),
        station="Climate ID",
    ),
    Provider(
        "NDBC",
        utc=True,
        headings=("YY|YYYY", "MM", "DD", "hh", "WDIR|WD", "WSPD"),
        documented=_wind(
            Stated("WSPD", "m/s", missing=(99.0,)),
            (Stated("WDIR", "deg", missing=(999.0,)), Stated("WD", "deg", missing=(999.0,))),
        ),
        times=(
            ("YY", "MM", "DD", "hh", "mm"), ("YYYY", "MM", "DD", "hh", "mm"), ("YY", "MM", "DD", "hh"),
            ("YYYY", "MM", "DD", "hh"),
        ),
        remark="NDBC files do not state the height of the anemometer, which on buoys is 3 to 5 m; state "
        "it as height",
    ),
    Provider(
        "NASA POWER",
        headings=("YEAR", "MO", "DY", "HR", "WS10M|WS50M|WS2M", "WD10M|WD50M|WD2M"),
        documented=_wind(
            tuple(Stated(f"WS{h}M", "m/s", float(h)) for h in (10, 50, 2)),
            tuple(Stated(f"WD{h}M", "deg", float(h)) for h in (10, 50, 2)),
        ),
        times=(("YEAR", "MO", "DY", "HR"),),
        time_format="%Y %m %d %H",
    ),
    Provider(
        "Open-Meteo",
        headings=("time", "|".join(f"wind_speed_10m ({unit})" for unit in ("km/h", "m/s", "mp/h", "kn"))),
    ),
    Provider(
        "Meteostat",
        headings=("wdir", "wspd", "wpgt", "pres", "coco|tsun"),
        documented=_wind(Stated("wspd", "km/h", 10.0), Stated("wdir", "deg", 10.0)),
        times=(("date", "hour"), ("year", "month", "day", "hour"), ("time",), ("date",)),
    ),
    Provider(
        "Meteostat (without heading)",
        documented=_wind(Stated("wspd", "km/h", 10.0), Stated("wdir", "deg", 10.0)),
        times=(("date", "hour"),),
        row=rf"{_DATE},\d{{1,2}}(?:,(?:{_NUMBER})?){{11}}",
        columns=_METEOSTAT,
    ),
    Provider(
        "ERA5",
        utc=True,
        headings=("u10", "v10", "time|valid_time"),
        documented={
            "eastward": (Stated("u10", "m/s", 10.0), Stated("u100", "m/s", 100.0)),
            "northward": (Stated("v10", "m/s", 10.0), Stated("v100", "m/s", 100.0)),
            "temperature": (Stated("t2m", "K", 2.0),),
            "snowfall": (Stated("sf", "m"),),
            "precipitation": (Stated("tp", "m"),),
            "precipitation_type": (Stated("ptype", "1"),),
        },
    ),
    Provider(
        "PROMICE and GC-Net (GEUS)",
        headings=("time", "wspd_u", "wdir_u", "t_u"),
        documented={
            "speed": (Stated("wspd_u", "m/s"),),
            "direction": (Stated("wdir_u", "deg"),),
            "temperature": (Stated("t_u", "°C"),),
        },
        times=(("time",),),
    ),
    Provider("HOBO (Onset)", begins="Plot Title", time_format="%m/%d/%y %I:%M:%S %p"),
    Provider("TOA5 (Campbell Scientific)", begins="TOA5"),
    Provider(
        "AeoLiS",
        documented=_wind(Stated("speed", "m/s"), Stated("direction", "deg")),
        times=(("time (s)",),),
        row=rf"{_NUMBER}\s+{_NUMBER}\s+{_NUMBER}",
        columns=("time (s)", "speed", "direction"),
    ),
)  # fmt: skip


def provider_of(headings: Sequence[str], text: str = "") -> Provider | None:
    """The format of a table with these headings, in a file that begins so; None if none is known."""
    return next((p for p in PROVIDERS if p.fits(headings, text)), None)


def provider_of_rows(lines: Sequence[str]) -> Provider | None:
    """The format of rows without a heading; None if it is none that is known."""
    return next((p for p in PROVIDERS if p.fits_rows(lines)), None)


UNKNOWN = Provider("")
