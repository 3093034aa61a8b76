"""A record gives the same drift potential in whatever unit, height, convention and layout it is written.

The right value is that of numpy from the winds at 10 m before they are written (``known.potential``).
Speeds at other heights are written by the law of the wall over 1 mm, which the drift potential assumes.
"""

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.wind.records.known import SIZE, potential, read_potential

LENGTHS = {"deg": 1.0, "rad": 180 / np.pi, "10s deg": 10.0, "gon": 0.9}
SPELLED = {"m/s": "m s-1", "0.1 m/s": "0.1 m/s", "km/h": "km/h", "kn": "knots", "mph": "mph"}


@st.composite
def written(draw):
    """Winds at 10 m, their hours, and a way to write them."""
    seed = draw(st.integers(0, 2**32 - 1))
    random = np.random.default_rng(seed)
    count = draw(st.integers(2, 40))
    speeds, ways = 1.0 + 12.0 * random.random(count), 360.0 * random.random(count)
    speeds[random.random(count) < 0.1] = 0.0
    speeds[0] = 15.0
    way = {
        "unit": draw(st.sampled_from(sorted(SIZE))),
        "angle": draw(st.sampled_from(sorted(LENGTHS))),
        "height": draw(st.sampled_from([None, 10.0, 2.0, 50.0, 100.0])),
        "to": draw(st.booleans()),
        "components": draw(st.booleans()),
        "order": random.permutation(count) if draw(st.booleans()) else np.arange(count),
        "mark": draw(st.sampled_from([",", ";", "\t", "|"])),
        "twice": draw(st.booleans()),
        "units_below": draw(st.booleans()),
    }
    return speeds, ways, way


def columns_of(speeds, ways, way):
    """Names, units and values of the two columns, as they are written."""
    height = way["height"] or 10.0
    there = speeds * np.log(height / 1e-3) / np.log(10.0 / 1e-3) / SIZE[way["unit"]]
    tall = "" if way["height"] is None else f"_{height:g}m"
    if way["components"]:
        angle = np.radians(ways)
        return [
            (f"u{tall}", way["unit"], -there * np.sin(angle)),
            (f"v{tall}", way["unit"], -there * np.cos(angle)),
        ]
    angle = ((ways + 180.0 * way["to"]) % 360.0) / LENGTHS[way["angle"]]
    name = "wind_to_direction" if way["to"] else "wind_direction"
    return [(f"wind_speed{tall}", way["unit"], there), (f"{name}{tall}", way["angle"], angle)]


def table_of(speeds, ways, way):
    """The text of a table."""
    pair = columns_of(speeds, ways, way)
    mark = way["mark"]
    if way["units_below"]:
        lines = [
            mark.join(["time", *(name for name, _, _ in pair)]),
            mark.join(["", *(u for _, u, _ in pair)]),
        ]
    else:
        lines = [mark.join(["time", *(f"{name} ({unit})" for name, unit, _ in pair)])]
    hours = np.datetime64("2020-02-28T20") + np.arange(len(speeds)) * np.timedelta64(1, "h")
    rows = [mark.join([f"{hours[k]}:00", *(repr(float(v[k])) for _, _, v in pair)]) for k in way["order"]]
    return "\n".join([*lines, *rows, *(rows[:1] if way["twice"] else [])]) + "\n"


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(written())
def test_a_table_gives_the_drift_potential_of_its_winds(tmp_path, case):
    speeds, ways, way = case
    path = tmp_path / "wind.dat"
    path.write_text(table_of(speeds, ways, way), "utf-8")
    found, record = read_potential(path)
    np.testing.assert_allclose(found, potential(speeds, ways), rtol=1e-9, atol=1e-9 * found[0])
    assert (len(record), record.duplicates, record.height) == (len(speeds), int(way["twice"]), way["height"])


@settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(written())
def test_a_grid_gives_the_drift_potential_of_its_winds(tmp_path, case):
    speeds, ways, way = case
    hours = pd.date_range("2020-02-28T20", periods=len(speeds), freq="h")
    spelled = SPELLED | {"deg": "degrees", "rad": "radians", "10s deg": "10s deg", "gon": "gon"}
    variables = {
        name: ("time", values[way["order"]], {"units": spelled[unit]})
        for name, unit, values in columns_of(speeds, ways, way)
    }
    path = tmp_path / "wind.nc"
    xr.Dataset(variables, {"time": hours[way["order"]]}).to_netcdf(path, engine="h5netcdf")
    found, record = read_potential(path)
    np.testing.assert_allclose(found, potential(speeds, ways), rtol=1e-9, atol=1e-9 * found[0])
    assert record.height == way["height"]


@pytest.mark.parametrize(("hours", "counted"), [([3] * 20 + [1] * 20, None), ([6] * 20 + [1] * 20, None)])
def test_each_row_counts_for_its_own_duration_where_intervals_change(tmp_path, hours, counted):
    random = np.random.default_rng(3)
    speeds, ways = 5 + 10 * random.random(40), 360 * random.random(40)
    times = np.cumsum([0, *hours[:-1]])
    rows = "\n".join(
        f"{t},{s!r},{w!r}" for t, s, w in zip(times, speeds.tolist(), ways.tolist(), strict=True)
    )
    path = tmp_path / "wind.csv"
    path.write_text("time (h),speed (m/s),direction\n" + rows)
    found, record = read_potential(path)
    np.testing.assert_allclose(found, potential(speeds, ways, hours), rtol=1e-9)
    assert record.gaps == 0
