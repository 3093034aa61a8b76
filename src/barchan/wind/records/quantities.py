"""The quantities of a record, and the names that columns and variables of each go by.

This is the one list: tables, NetCDF files and the declared formats of providers all read from it. A quantity
is added by adding it here.
"""

from dataclasses import dataclass

from barchan.wind.records.units import ANGLE, SPEED, TIME, Dimension


@dataclass(frozen=True)
class Quantity:
    """Something that a column may hold."""

    name: str
    dimension: Dimension
    names: tuple[str, ...]
    """Plain names (lower case, without unit, height and filling words), the likeliest first."""
    standard: tuple[str, ...] = ()
    """Standard names of the CF conventions."""
    usual_unit: str = ""
    """Unit that a column without one is taken in."""
    said: bool = True
    """Whether taking the usual unit is worth a remark."""


TIMES = Quantity(
    "time",
    TIME,
    (
        "time", "datetime", "date_time", "timestamp", "valid_time", "valid", "mess_datum", "utc",
        "observation_time", "obstime", "obs_time", "time_stamp", "date",
    ),
    ("time",),
)  # fmt: skip
SPEEDS = Quantity(
    "speed",
    SPEED,
    (
        "speed", "wind_speed", "windspeed", "windspd", "wndspd", "wind_spd", "ws", "wspd", "sknt", "ff", "f",
        "wind_velocity", "windgeschwindigkeit", "si", "wind", "spd",
    ),
    ("wind_speed",),
    "m/s",
)  # fmt: skip
DIRECTIONS = Quantity(
    "direction",
    ANGLE,
    (
        "direction", "wind_direction", "winddirection", "wind_dir", "winddir", "wd", "wdir", "drct",
        "dir", "dd", "d", "windrichtung", "wdirection", "wind_bearing",
    ),
    ("wind_from_direction", "wind_to_direction"),
    "deg",
    said=False,
)  # fmt: skip
EASTWARD = Quantity(
    "eastward",
    SPEED,
    ("u", "u_component_of_wind", "eastward_wind", "u_wind", "uwnd", "wind_u", "u_component", "ugrd", "uas"),
    ("eastward_wind", "x_wind"),
    "m/s",
)
NORTHWARD = Quantity(
    "northward",
    SPEED,
    ("v", "v_component_of_wind", "northward_wind", "v_wind", "vwnd", "wind_v", "v_component", "vgrd", "vas"),
    ("northward_wind", "y_wind"),
    "m/s",
)

QUANTITIES: dict[str, Quantity] = {q.name: q for q in (TIMES, SPEEDS, DIRECTIONS, EASTWARD, NORTHWARD)}

WIND = ("speed", "direction", "eastward", "northward")
"""Quantities that a wind is made of: the first two, or the last two."""

UNIT_OF_NAME = {"sknt": "kn"}
"""Names that contain the unit."""
