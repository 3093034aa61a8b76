"""What the page is told of a run before its first frame."""

from barchan.ground.terrain import Georeference
from barchan.scenario import validate
from barchan.simulation import SetParameter, Simulation
from barchan.studio.worker.description import description

TINY = {"barchan": 4, "lattice": {"rows": 16, "columns": 16}, "run": {"seed": 1}}


def test_the_place_of_a_ground_with_coordinates_is_told(monkeypatch):
    simulation = Simulation(validate(TINY))
    assert description(simulation, simulation.scenario)["place"] is None
    place = Georeference(400_000.0, 5_300_000.0, "EPSG:32633")
    monkeypatch.setattr("barchan.ground.terrain.Terrain.georeference", lambda _: place)
    told = description(simulation, simulation.scenario)["place"]
    assert told == {"west": 400_000.0, "south": 5_300_000.0, "crs": "EPSG:32633"}


def test_a_scenario_without_a_title_is_called_untitled_once_it_was_changed():
    simulation = Simulation(validate(TINY))
    assert description(simulation, simulation.scenario)["scenario"]["title"] == ""
    origin = simulation.scenario
    simulation.apply(SetParameter(key="model.hop_length", value=3.0))
    told = description(simulation, origin)["scenario"]["title"]
    assert told == "Untitled scenario, changed: model.hop_length 3"


def test_how_long_a_step_lasts_is_told_where_there_is_a_clock():
    simulation = Simulation(validate({**TINY, "clock": {"step_seconds": 3600.0}}))
    assert description(simulation, simulation.scenario)["step_seconds"] == 3600.0
    without = Simulation(validate(TINY))
    assert description(without, without.scenario)["step_seconds"] is None
