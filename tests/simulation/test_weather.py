"""A model of snow that falls and packs, on the weather, layers and reasons to finish of the core."""

import numpy as np
import pytest

from barchan.bed import Bed
from barchan.fields import FieldInfo, LayerInfo
from barchan.model import Model, Tally
from barchan.simulation import Ledger, Simulation
from tests.tiny import tiny

SNOW = LayerInfo("snow", "int32", "kg/m²", "snow", mass=1.0, height_field="height")
HEIGHT = FieldInfo("height", "int32", "µm", "thickness of the snow")
LIMIT = 5
"""Mass (kg/m²) of snow that weighs the bed down until nothing moves."""


class Packing(Model):
    """Snow falls at the forcing's rate, and packs to 100 kg/m³ whatever the wind does."""

    name = "packing"
    layers = (SNOW,)
    fields = (HEIGHT,)

    def advance(self, bed, segment, stream):
        self.temperatures = [*getattr(self, "temperatures", []), segment.weather.temperature]
        fallen = round(segment.weather.snowfall * segment.seconds)
        bed.lay(np.full(self.lattice.shape, fallen))
        bed.arrays["height"][...] = bed.arrays["snow"] * 10_000
        heavy = bed.arrays["snow"].max() >= LIMIT
        finished = "the snow is too heavy to move" if heavy else None
        return Tally(steps=segment.steps, entered=fallen * self.lattice.cells, finished=finished)

    def relax(self, bed, where=None):
        return 0


def snowing(**wind):
    scenario = tiny(
        wind={"kind": "steady", "speed": 0.0, "temperature": -8.0, "snowfall": 1e-3, **wind},
        clock={"step_seconds": 1000.0},
    )
    simulation = Simulation(scenario)
    simulation.model = Packing(scenario.model, scenario.lattice)
    nothing = np.zeros(scenario.lattice.shape)
    simulation.bed = Bed(scenario.lattice, nothing, nothing, layers=Packing.layers)
    simulation.bed.add(HEIGHT, nothing)
    simulation.ledger = Ledger(0)
    return simulation


def test_snowfall_in_a_calm_reaches_the_model_and_is_booked_as_entered():
    simulation = snowing()
    for _ in range(3):
        simulation.advance(1)
    cells = simulation.lattice.cells
    assert simulation.ledger.entered == simulation.bed.units == 3 * cells
    np.testing.assert_allclose(simulation.elevation, 0.03, rtol=1e-12)
    assert simulation.model.temperatures == [-8.0] * 3


def test_a_model_that_is_finished_ends_the_run_and_says_why():
    simulation = snowing()
    for _ in range(10):
        simulation.advance(1)
    assert simulation.steps_done == LIMIT
    assert simulation.finished == "the snow is too heavy to move"
    assert simulation.done


def test_the_weather_of_a_step_with_several_winds_is_their_mean():
    winds = {
        "kind": "regimes",
        "regimes": [
            {"direction": 0.0, "speed": 1.0, "seconds": 250.0, "temperature": -10.0, "snowfall": 4e-3},
            {"direction": 90.0, "speed": 1.0, "seconds": 750.0, "temperature": -2.0, "snowfall": 0.0},
        ],
    }
    simulation = Simulation(tiny(wind=winds, clock={"step_seconds": 1000.0}))
    weather = simulation.forcing.wind_of(0).weather
    assert weather.temperature == pytest.approx(-4.0)
    assert weather.snowfall == pytest.approx(1e-3)


def test_nothing_is_known_of_the_weather_unless_it_is_stated():
    weather = Simulation(tiny()).forcing.wind_of(0).weather
    assert (weather.temperature, weather.snowfall) == (None, None)
