"""One station or point of a table that may hold several."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.layout import Layout
from barchan.words import counted

if TYPE_CHECKING:
    import pandas as pd

_STATIONS = ("station", "station_id", "stationid", "stn", "stations_id", "usaf", "site", "site_id", "name",
             "station_name",
             "station number", "station name", "climate id", "location", "location_id")  # fmt: skip
"""Names of columns that tell stations apart."""

_MOST_TOLD = 12


def one_place(
    table: "pd.DataFrame", numbers: NDArray[np.int64], layout: Layout, form: RecordFormat, source: str
) -> tuple["pd.DataFrame", NDArray[np.int64]]:
    """The rows of one station and one point, and their numbers.

    Raises RecordError where there are several and none, or one that is not there, is asked for.
    """
    station = layout.provider.station or next((h for h in table if h.lower() in _STATIONS), "")
    kept = np.ones(len(table), bool)
    if station in table:
        kept &= _of_station(table[station].str.strip(), form.station, source)
    elif form.station is not None:
        raise RecordError([Problem("station", "is stated, but the table has no column of stations")], source)
    kept &= _of_point(table, form, source)
    return table[kept], numbers[kept]


def _of_station(words: "pd.Series", wanted: str | None, source: str) -> NDArray[np.bool_]:
    """The rows of the wanted station, or of the only one."""
    there = [name for name in words.unique() if name]
    if wanted is None and len(there) <= 1:
        return np.ones(len(words), bool)
    told = ", ".join(there[:_MOST_TOLD]) + (
        f" and {len(there) - _MOST_TOLD} more" if len(there) > _MOST_TOLD else ""
    )
    if wanted is None:
        raise RecordError([Problem("station", f"the table holds several; state one of {told}")], source)
    if wanted not in there:
        raise RecordError([Problem("station", f"is '{wanted}'; the table has {told}")], source)
    return (words == wanted).to_numpy(bool)


def _of_point(table: "pd.DataFrame", form: RecordFormat, source: str) -> NDArray[np.bool_]:
    """The rows at the point that is asked for, or at the only one."""
    import pandas as pd

    named = {h.lower(): h for h in table}
    axes = [
        next((named[n] for n in names if n in named), None)
        for names in (("latitude", "lat"), ("longitude", "lon"))
    ]
    everywhere = np.ones(len(table), bool)
    if None in axes:
        return everywhere
    where = table[axes].apply(pd.to_numeric, errors="coerce")
    points = where.drop_duplicates().dropna()
    if len(points) <= 1 and form.latitude is None and form.longitude is None:
        return everywhere
    if form.latitude is None or form.longitude is None:
        if len(points) <= 1:
            return everywhere
        raise RecordError(
            [Problem("", f"holds {counted(len(points), 'point')}; state latitude and longitude")], source
        )
    turned = np.abs((points.to_numpy()[:, 1] - form.longitude + 180.0) % 360.0 - 180.0)
    away = np.hypot(points.to_numpy()[:, 0] - form.latitude, turned)
    nearest = points.iloc[int(np.argmin(away))]
    if away.min() > FARTHEST:
        message = (
            f"is {form.latitude:g}, {form.longitude:g}; the nearest point of the table is "
            f"{nearest.iloc[0]:g}, "
            f"{nearest.iloc[1]:g}, farther than {FARTHEST:g}°"
        )
        raise RecordError([Problem("latitude, longitude", message)], source)
    return ((where == nearest.to_numpy()).all(axis=1)).to_numpy(bool)


FARTHEST = 0.5
"""Degrees that a point may lie away from the one that is asked for, where the size of cells is not known."""
