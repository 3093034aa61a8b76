"""The quantities of a record, and the names that columns and variables of each go by.

This is the one list: tables, NetCDF files and the declared formats of providers all read from it. A quantity
is added by adding it here.
"""

from dataclasses import dataclass

from barchan.wind.records.units import ANGLE, FALL, KIND, LENGTH, SPEED, TEMPERATURE, TIME, Dimension


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
        "observation_time", "obstime", "obs_time", "time_stamp", "zeitstempel", "zeitpunkt", "datum_zeit",
        "datum_uhrzeit", "datum_tijd", "fecha_hora", "data_ora", "date_heure", "date", "datum", "fecha",
        "zeit",
    ),
    ("time",),
)  # fmt: skip
SPEEDS = Quantity(
    "speed",
    SPEED,
    (
        "speed", "wind_speed", "windspeed", "windspd", "wndspd", "wind_spd", "ws", "wspd", "sknt", "ff", "f",
        "wind_velocity", "windgeschwindigkeit", "vitesse_du_vent", "velocidad_del_viento",
        "velocita_del_vento", "velocità_del_vento", "windsnelheid", "si", "wind", "spd",
    ),
    ("wind_speed",),
    "m/s",
)  # fmt: skip
DIRECTIONS = Quantity(
    "direction",
    ANGLE,
    (
        "direction", "wind_direction", "winddirection", "wind_dir", "winddir", "wd", "wdir", "drct",
        "dir", "dd", "d", "windrichtung", "direction_du_vent", "direccion_del_viento", "dirección_del_viento",
        "direzione_del_vento", "wdirection", "wind_bearing",
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

TEMPERATURES = Quantity(
    "temperature",
    TEMPERATURE,
    (
        "temperature", "air_temperature", "ta", "tair", "air_temp", "temp", "t_air", "temp_air", "t_u", "tt",
        "temp_single_mean", "t",
    ),
    ("air_temperature",),
    "°C",
)  # fmt: skip
SNOWFALLS = Quantity(
    "snowfall",
    FALL,
    ("snowfall", "snowf", "sf", "precsno", "precsn", "snowfall_flux", "snow_fall", "psum_s", "prsn"),
    ("snowfall_flux", "lwe_thickness_of_snowfall_amount", "snowfall_amount"),
)
PRECIPITATIONS = Quantity(
    "precipitation",
    FALL,
    ("precipitation", "psum", "pint", "tp", "total_precipitation", "precip", "prectotcorr", "prectot", "pr"),
    ("precipitation_flux", "precipitation_amount", "lwe_thickness_of_precipitation_amount"),
)

RAIN_SHARES = Quantity("rain_share", KIND, ("psum_ph", "rain_share"), usual_unit="1", said=False)
PRECIPITATION_TYPES = Quantity(
    "precipitation_type", KIND, ("ptype", "precipitation_type"), usual_unit="1", said=False
)
SNOW_DEPTHS = Quantity("snow_depth", LENGTH, ("snow_depth", "hs", "snowdepth"), ("surface_snow_thickness",))

QUANTITIES: dict[str, Quantity] = {
    q.name: q
    for q in (
        TIMES, SPEEDS, DIRECTIONS, EASTWARD, NORTHWARD, TEMPERATURES, SNOWFALLS, PRECIPITATIONS, RAIN_SHARES,
        PRECIPITATION_TYPES, SNOW_DEPTHS,
    )
}  # fmt: skip

WIND = ("speed", "direction", "eastward", "northward")
"""Quantities that a wind is made of: the first two, or the last two."""

WEATHER = ("temperature", "snowfall", "precipitation", "rain_share", "precipitation_type", "snow_depth")
"""Quantities of the weather that comes with it."""

UNIT_OF_NAME = {"sknt": "kn"}
"""Names that contain the unit."""
