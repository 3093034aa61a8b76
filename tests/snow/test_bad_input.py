"""Snow and weather that cannot be, or that lead to nothing: each is refused or remarked on with its value.

What a record's columns may hold is tested beside the records (tests/wind).
"""

import numpy as np
import pytest

import barchan
from barchan.errors import RecordError, ScenarioError
from barchan.simulation import SetWind, Simulation
from barchan.wind.records import RecordFormat, read_record

HOURS = np.datetime64("2024-01-01T00:00") + np.arange(72) * np.timedelta64(1, "h")


def scene(**parts):
    data = {
        "barchan": 5,
        "lattice": {"rows": 8, "columns": 12, "cell_size": 0.1},
        "sand": {"kind": "flat", "mean": 4},
        "wind": {"kind": "steady", "speed": 10.0, "unit": "m/s"},
        "model": {"name": "snow"},
        "run": {"steps": 100, "seed": 1},
    }
    return barchan.load({**data, **parts})


def table(path, heading, rows):
    lines = [f"time,speed (m/s),direction,{heading}"]
    lines += [f"{time},{row}" for time, row in zip(HOURS, rows, strict=False)]
    path.write_text("\n".join(lines) + "\n")
    return path


@pytest.mark.parametrize(
    ("model", "said"),
    [
        ({"start_density": 20.0}, r"start_density: is 20.*30"),
        ({"start_density": 950.0}, r"start_density: is 950.*917"),
        ({"drift": {"density": 12.0}}, r"drift\.density: is 12.*30"),
        ({"beneath": [{"density": 1000.0}]}, r"beneath\[0\]\.density: is 1000.*917"),
        ({"snowfall": {"density": 10.0}}, r"snowfall\.density: is 10.*30"),
        ({"repose": {"drift": 4.0}}, r"repose\.drift: is 4.*5"),
        ({"repose": {"wet": 2.0}}, r"repose\.wet: is 2.*5"),
        ({"layers": 1}, r"layers: is 1;.*≥ 2 and ≤ 16"),
        ({"layers": 17}, r"layers: is 17;.*≥ 2 and ≤ 16"),
        ({"temperature": 6.0}, r"temperature: is 6.*≥ -90 and ≤ 5"),
        ({"beneath": [{"mass": 2e5}], "quantum": 0.1}, r"beneath\[0\]\.mass: is 200000.*100000"),
        ({"quantum": 0.01}, r"quantum: is 0\.01.*0\.1"),
    ],
)
def test_parameters_of_snow_keep_to_what_snow_can_be(model, said):
    with pytest.raises(ScenarioError, match=said):
        scene(model={"name": "snow", **model})


@pytest.mark.parametrize(
    ("wind", "said"),
    [
        ({"temperature": 6.0}, r"wind\.temperature.*6 °C; allowed with snow: temperatures from -90 to 5"),
        ({"snowfall": -1e-4}, r"wind\.snowfall: is -0\.0001"),
        ({"snowfall": 0.2}, r"wind\.snowfall: is 0\.2"),
    ],
)
def test_a_stated_weather_keeps_to_what_air_can_be(wind, said):
    with pytest.raises(ScenarioError, match=said):
        scene(wind={"kind": "steady", "speed": 10.0, "unit": "m/s", **wind})


def test_more_quanta_than_a_layer_can_count_are_refused():
    """A layer counts up to 2**20 - 1 quanta; a start has a million at most."""
    with pytest.raises(ScenarioError, match=r"sand\.mean: is 1048576; allowed: .* ≤ 1000000"):
        scene(sand={"kind": "flat", "mean": 1_048_576})


def test_a_quantum_so_large_that_hardly_any_falls_is_remarked_on():
    """1e-6 kg/m²/s for 100 steps of 4.3 s: 0.00043 kg/m²."""
    wind = {"kind": "steady", "speed": 10.0, "unit": "m/s", "snowfall": 1e-6}
    (said,) = scene(wind=wind).remarks()
    assert "0.00043 kg/m² of snow fall during the run, 0.00043 quanta of 1 kg/m² on a cell" in said
    assert scene(wind={**wind, "snowfall": 0.01}).remarks() == []


def test_cells_wider_than_two_hops_are_remarked_on():
    assert scene(lattice={"rows": 8, "columns": 12, "cell_size": 0.2}).remarks() == []
    (said,) = scene(lattice={"rows": 8, "columns": 12, "cell_size": 0.25}).remarks()
    assert said.startswith("cells of 0.25 m are more than 2 hops of 0.1 m wide")


def test_bonds_that_grow_within_a_step_are_remarked_on():
    """0.1 h at -10 °C are 360 s; at 100 kg/m² a quantum and 6.7 m/s a step is far longer."""
    model = {"name": "snow", "quantum": 100.0, "reference_wind": 7.7, "bonding": {"loose_hours": 0.1}}
    found = scene(model=model, wind={"kind": "steady", "speed": 9.0, "unit": "m/s"}).remarks()
    assert any("snow bonds within 360 s at -10 °C" in said and "it locks at once" in said for said in found)


@pytest.mark.parametrize("kind", ["steady", "record"])
def test_winds_below_every_threshold_are_remarked_on(tmp_path, kind):
    wind = {"kind": "steady", "speed": 4.0, "unit": "m/s"}
    if kind == "record":
        path = table(tmp_path / "calm.csv", "temperature (°C)", ["4,270,-8"] * 5)
        wind = {"kind": "record", "path": str(path)}
    assert any(said.startswith("nothing moves: no wind of the run") for said in scene(wind=wind).remarks())


@pytest.mark.parametrize("value", ["7.5", "-95"])
def test_a_record_too_warm_or_too_cold_for_snow_is_refused_with_its_time(tmp_path, value):
    path = table(tmp_path / "thaw.csv", "temperature (°C)", ["9,270,-2", f"9,270,{value}", "9,270,-1"])
    wind = {"kind": "record", "path": str(path)}
    if value == "-95":  # no air is that cold: the column is no temperature, and not read
        record = read_record(path)
        assert record.temperature is None
        assert any("row 3, column 'temperature (°C)': is -95 °C" in remark for remark in record.remarks)
        return
    said = r"thaw\.csv has a temperature of 7\.5 °C at 2024-01-01T01:00:00; allowed with snow: -90 to 5 °C"
    with pytest.raises(ScenarioError, match=said):
        Simulation(scene(wind=wind))
    running = Simulation(scene())
    with pytest.raises(ScenarioError, match=r"7\.5 °C"):
        running.apply(SetWind(wind=wind))


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("-3,270,-5", r"row 3, column 'speed \(m/s\)': is -3; allowed: speeds from 0"),
        ("6999,270,-5", r"row 3, column 'speed \(m/s\)': is 6999; allowed: speeds from 0"),
        ("9,400,-5", r"row 3, column 'direction': is 400; allowed: directions from 0 to 360"),
    ],
)
def test_winds_that_cannot_blow_are_refused(tmp_path, row, said):
    with pytest.raises(RecordError, match=said):
        read_record(table(tmp_path / "w.csv", "temperature (°C)", ["8,270,-5", row, "8,270,-5"]))


@pytest.mark.parametrize("code", ["-999", "9999"])
def test_codes_for_missing_values_need_no_declaration(tmp_path, code):
    path = table(tmp_path / "w.csv", "temperature (°C)", ["8,270,-5", f"{code},270,{code}", "8,270,-6"])
    record = read_record(path)
    assert (len(record), record.missing) == (2, 1)
    assert record.temperature.tolist() == [-5.0, -6.0]


def summed(path, change=lambda rows: rows):
    """Three days of sums that start over at 1 h: an hour's mm, two in the second, and so on."""
    rows = [f"8,270,-5,{(hour - 1) % 24 + 1}" for hour in range(72)]
    return table(path, "temperature (°C),tp (mm)", change(rows))


def test_running_sums_are_turned_into_amounts(tmp_path):
    """The sum grows by a millimetre in each hour, also in the one in which it starts over."""
    record = read_record(summed(tmp_path / "sums.csv"), RecordFormat(accumulated=True))
    np.testing.assert_allclose(record.snowfall[1:-1] * 3600, 1.0)


def test_sums_that_nobody_declared_are_not_read_as_amounts(tmp_path):
    path = summed(tmp_path / "sums.csv")
    record = read_record(path)
    assert record.snowfall is None
    assert any("is it a running sum? State accumulated" in remark for remark in record.remarks)
    with pytest.raises(RecordError, match=r"column 'tp \(mm\)': falls at one time of the day only"):
        read_record(path, RecordFormat(precipitation="tp (mm)"))


def test_a_sum_that_falls_by_itself_is_refused_with_its_row(tmp_path):
    path = summed(
        tmp_path / "sums.csv", lambda rows: [r if n != 30 else "8,270,-5,0.5" for n, r in enumerate(rows)]
    )
    form = RecordFormat(accumulated=True, precipitation="tp (mm)")
    with pytest.raises(RecordError, match=r"row 32, column 'tp \(mm\)': is 0\.5 after 5; allowed: sums"):
        read_record(path, form)
