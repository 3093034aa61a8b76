"""The layers along a section, as a table and as a dataset.

Right values: fields of a frame are set by hand, and thickness, age and date follow with pencil and paper.
"""

import csv

import numpy as np
import pytest
import xarray as xr

from barchan.analysis.fields import field_names
from barchan.errors import BarchanError, ExportError
from barchan.export import export, layer_table
from barchan.export.writing import opened
from barchan.kernels.snow.state import pack_word
from barchan.scenario import load_scenario
from barchan.simulation import Simulation

ROWS, COLUMNS, CELL = 8, 10, 0.5
NOW = 1000
"""The bond clock at the last frame, in 600 s at -10 °C: 100 ticks after the first."""


def of_snow(wind, step=900) -> xr.Dataset:
    """Two frames of snow, 0 and ``step``: two layers on the cell in row 1, column 2, else bare ground."""
    scenario = load_scenario(
        {
            "barchan": 2,
            "lattice": {"rows": ROWS, "columns": COLUMNS, "cell_size": CELL},
            "sand": {"kind": "flat", "mean": 0},
            "wind": wind,
            "model": {"name": "snow", "layers": 2, "quantum": 0.5},
            "run": {"steps": step, "seed": 1},
        }
    )
    bed = Simulation(scenario).bed
    shape = (2, ROWS, COLUMNS)
    fields = {name: np.zeros(shape, array.dtype) for name, array in bed.arrays.items()}
    fields["snow_epoch"][0], fields["snow_epoch"][1] = NOW - 100, NOW
    fields["snow_layer_1"][1, 1, 2] = pack_word(8, NOW - 900, 250.0)
    fields["snow_top"][1, 1, 2] = pack_word(3, NOW - 12, 100.0)
    fields["snow"][1, 1, 2] = 11
    fields["snow_height"][1, 1, 2] = 31_000
    fields["ground"] = np.full(shape, 2.0)
    fields["elevation"] = fields["ground"] + fields["snow_height"] * 1e-6
    named = {"unit": "1", "long_name": "of the scene"}
    variables = {name: (("step", "y", "x"), values, named) for name, values in fields.items()}
    variables["wind_direction"] = ("step", np.array([270.0, 270.0]))
    x, y = (np.arange(COLUMNS) + 0.5) * CELL, (np.arange(ROWS) + 0.5) * CELL
    coordinates = {"step": [0, step], "y": y, "x": x}
    return xr.Dataset(variables, coordinates, {"scenario": scenario.text()})


STEADY = {"kind": "steady", "speed": 10.0, "unit": "m/s"}


def test_layers_of_snow_have_place_age_density_mass_and_state():
    run = of_snow(STEADY)
    table = layer_table(run, step="last")
    # 8 quanta of 0.5 kg/m² at 250 kg/m³ are 4 kg/m² in 16 mm; 3 at 100 kg/m³ are 1.5 kg/m² in 15 mm
    assert table["layer"].values.tolist() == [1, 2]
    np.testing.assert_allclose(table["bottom"], [2.0, 2.016])
    np.testing.assert_allclose(table["top"], [2.016, 2.031])
    np.testing.assert_allclose(table["mass"], [4.0, 1.5])
    np.testing.assert_allclose(table["density"], [250.0, 100.0])
    np.testing.assert_allclose(table["age"], [150.0, 2.0])  # 900 and 12 times ten minutes
    assert table["state"].values.tolist() == ["bonded", "loose"]  # bonded from 3 hours on
    # a west wind: the section is row 1, and the third cell lies two cells from the first
    assert set(table["distance"].values) == {1.0}
    assert set(zip(table["x"].values, table["y"].values, strict=True)) == {(1.25, 0.75)}


def test_layers_of_snow_state_when_they_came_to_rest_and_nothing_of_snow_older_than_the_run():
    run = of_snow(STEADY)
    _, scenario = opened(run)
    when = layer_table(run, step="last")["deposited"].values
    # 100 ticks of the bond clock passed in 900 steps; the upper layer came to rest 12 ticks before the end
    assert np.isnan(when[0])
    assert when[1] == pytest.approx(0.88 * 900 * scenario.step_seconds)


def test_dates_of_layers_go_on_over_the_rows_of_the_record(tmp_path):
    record = tmp_path / "storm.csv"
    rows = ["time,wind_speed (m/s),wind_dir", *(f"2024-01-10T{hour:02d}:00,10,270" for hour in range(6, 18))]
    record.write_text("\n".join(rows) + "\n", "utf-8")
    run = of_snow({"kind": "record", "path": str(record), "repeat": False})
    table = layer_table(run, step="last")
    seconds = float(table["deposited"].values[1])
    assert 0 < seconds < 12 * 3600
    expected = np.datetime64("2024-01-10T06:00:00") + np.timedelta64(round(seconds), "s")
    assert np.isnat(table["date"].values[0])
    assert table["date"].values[1] == expected


def test_the_table_of_layers_has_units_in_its_headings(tmp_path):
    export(of_snow(STEADY), tmp_path / "layers.csv", format="layers")
    with (tmp_path / "layers.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    places = ["step", "distance (m)", "x (m)", "y (m)", "layer", "bottom (m)", "top (m)"]
    stated = ["age (h at -10 °C)", "density (kg/m³)", "state", "mass (kg/m²)", "deposited (s)"]
    assert list(rows[0]) == [*places, *stated]
    assert [row["step"] for row in rows] == ["900", "900"]  # all frames, and the first one is bare
    assert rows[0]["deposited (s)"] == ""


def test_layers_of_snow_grains_are_bonded_and_loose_snow():
    scenario = load_scenario(
        {"barchan": 2, "lattice": {"rows": 8, "columns": 8}, "model": {"name": "snow_grains"}}
    ).seeded()
    simulation = Simulation(scenario)
    bed, model = simulation.bed, simulation.model
    bed.sand[...], bed.arrays["loose_1"][...] = 10, 4
    density = scenario.model.grain_density * (1.0 - scenario.model.porosity)
    found = {one.name: one.compute(model, bed) for one in model.strata}
    held = [number for number, (thickness, _) in enumerate(found["age"]) if thickness[0, 0] > 0]
    step = scenario.lattice.thickness
    assert [found["state"][n][1][0, 0] for n in held] == [1.0, 0.0]
    assert [found["mass"][n][1][0, 0] for n in held] == pytest.approx(
        [6 * step * density, 4 * step * density]
    )


def test_sand_without_layers_is_refused():
    from tests.export.scenes import asymmetric

    with pytest.raises(ExportError, match="Werner 1995 keeps no layers"):
        layer_table(asymmetric())


def test_packed_layers_are_no_fields(tmp_path):
    run = of_snow(STEADY)
    _, scenario = opened(run)
    names = field_names(run.isel(step=-1), scenario)
    assert not {"snow_top", "snow_epoch", "snow_layer_1", "snow_layer_2", "snow_height"} & set(names)
    model = scenario.new_model()
    titles = [field.meaning for field in (*model.fields, *model.derived) if field.name in names]
    assert len(set(titles)) == len(titles)
    assert {"snow", "density", "age", "snow_stress"} <= set(names)
    with pytest.raises(BarchanError, match="no field 'snow_top'"):
        export(run, tmp_path / "top.asc", fields="snow_top")
    export(run, tmp_path / "section.csv", format="section")
    heading = (tmp_path / "section.csv").read_text("utf-8").splitlines()[0]
    assert "snow_stress (1)" in heading
    assert "epoch" not in heading
    usual = {
        "density (kg/m³)",
        "age (h at -10 °C)",
        "threshold_wind (m/s)",
        "mean_density (kg/m³)",
        "depth (m)",
    }
    assert usual <= set(heading.split(","))
