"""The public names of ``import barchan``, and the modules that importing it does not load."""

import subprocess
import sys

import pytest

import barchan
from barchan.scenario import Scenario
from tests.tiny import DATA, tiny


@pytest.mark.parametrize("name", barchan.__all__)
def test_every_public_name_is_there(name):
    assert getattr(barchan, name) is not None


def test_the_public_names_are_listed():
    assert dir(barchan) == sorted(barchan.__all__)


def test_a_name_that_is_not_there_is_an_attribute_error():
    with pytest.raises(AttributeError, match="module 'barchan' has no attribute 'simluate'"):
        _ = barchan.simluate


def test_importing_barchan_imports_nothing_heavy():
    code = "import sys, barchan; print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert not {"numba", "numpy", "xarray", "zarr", "pydantic", "matplotlib"} & set(run.stdout.split())


def test_a_scenario_loads_from_preset_data_and_file(tmp_path):
    path = tmp_path / "tiny.json"
    path.write_text(tiny().text(), "utf-8")
    assert barchan.load("barchans").lattice.shape == (256, 256)
    assert barchan.load(DATA) == barchan.load(path) == barchan.load(str(path)) == tiny()


def test_single_values_are_overridden_as_keywords():
    scenario = barchan.load("barchans", run__steps=5, model__polling="non_repeated", run__seed=None)
    assert (scenario.run.steps, scenario.model.polling, scenario.run.seed) == (5, "non_repeated", None)


@pytest.mark.parametrize("title", ["Dunes", "2024", 'with "quotes"'])
def test_a_title_is_overridden_as_a_keyword(title):
    assert barchan.load("barchans", title=title).title == title


def test_a_mistyped_keyword_is_refused():
    with pytest.raises(barchan.ScenarioError, match=r"run\.stpes: unknown key; did you mean 'steps'\?"):
        barchan.load("barchans", run__stpes=5)


def test_every_error_of_barchans_is_one_kind_of_error():
    assert issubclass(barchan.ScenarioError, barchan.BarchanError)
    assert issubclass(barchan.ArchiveError, barchan.BarchanError)


def test_models_and_presets_are_known_by_name():
    assert "werner" in barchan.model_names()
    assert "barchans" in barchan.preset_names()


def test_a_run_in_memory_and_one_on_disk_are_read_in_the_same_way(tmp_path):
    scenario = tiny()
    dataset = barchan.simulate(scenario)
    outcome = barchan.run(barchan.Simulation(scenario), tmp_path / "run")
    with barchan.open_run(outcome.path) as read:
        assert dict(read.sizes) == dict(dataset.sizes) == {"step": 5, "y": 16, "x": 24}
        assert set(read.variables) == set(dataset.variables)
    assert isinstance(barchan.load(outcome.path), Scenario)
    assert barchan.resume(outcome.path).reason == "all steps done"
    for number, what in enumerate((scenario, scenario.data())):
        same = barchan.run(what, tmp_path / f"same-{number}")
        with barchan.open_run(same.path) as read:
            assert read["sand"].equals(dataset["sand"])


def test_events_are_public():
    simulation = barchan.Simulation(tiny())
    simulation.apply(barchan.SetParameter(key="model.hop_length", value=2.0))
    simulation.apply(barchan.SetWind(wind={"direction": 90.0}))
    simulation.apply(barchan.Stroke(x=1.0, y=2.0, radius=3.0, amount=4))
    assert [type(record.event).__name__ for record in simulation.events] == [
        "SetParameter",
        "SetWind",
        "Stroke",
    ]
