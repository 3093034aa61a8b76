"""What the page is told speaks of neither files nor the command line: the texts suit whoever reads them."""

import json
import re

import pytest

from barchan.errors import ScenarioError
from barchan.ground.surface import FileGround
from barchan.lattice import Lattice
from barchan.scenario import validate
from barchan.simulation import Simulation
from barchan.streams import Stream
from barchan.studio.server.queries import QUERIES
from barchan.studio.server.workspace import UPLOADS, Workspace
from barchan.studio.worker.description import description

TINY = {"barchan": 5, "lattice": {"rows": 16, "columns": 16}, "run": {"seed": 1}}

OF_THE_COMMAND_LINE = re.compile(r'--|\{"|"unit":|\bkey \b|\bmodel\.|\brio\b')


def assert_plain(text: str) -> None:
    assert not OF_THE_COMMAND_LINE.search(text), text


@pytest.mark.parametrize(
    ("wind", "model", "advice"),
    [
        ({"kind": "steady", "speed": 8.0, "unit": "m/s"}, "werner", "give the scenario a clock, or"),
        ({"kind": "record"}, "werner", "give the scenario a clock"),
        ({"kind": "regimes", "regimes": [{"direction": 0, "seconds": 60}]}, "werner", "or state it in steps"),
        ({"kind": "steady", "speed": 5.0}, "ripples", "(unit m/s), or leave it out"),
        ({"kind": "steady", "speed": 800.0, "unit": "m/s"}, "werner", "a hop length (unit cells)"),
    ],
)
def test_what_is_wrong_with_a_scenario_is_said_in_plain_words(tmp_path, wind, model, advice):
    data = {**TINY, "wind": wind, "model": {"name": model}}
    told = QUERIES["check"](Workspace(tmp_path), {"text": json.dumps(data)})
    (problem,) = told["problems"]
    assert advice in problem["message"]
    assert_plain(problem["message"])


def test_a_remark_is_said_in_plain_words():
    data = {**TINY, "lattice": {**TINY["lattice"], "boundary_x": "open"}}
    simulation = Simulation(validate(data))
    said = " ".join(description(simulation, simulation.scenario)["remarks"])
    assert "state what enters, for instance an influx of kind saturation" in said
    assert_plain(said)


def test_a_map_in_degrees_is_refused_in_plain_words(tmp_path):
    path = tmp_path / UPLOADS / "dem.asc"
    path.parent.mkdir()
    head = "ncols 8\nnrows 8\nxllcorner 14.2\nyllcorner 40.1\ncellsize 0.000277777778\n"
    path.write_text(head + "1 2 3 4 5 6 7 8\n" * 8)
    lattice = Lattice(rows=8, columns=8)
    with pytest.raises(ScenarioError) as refused:
        FileGround(path=str(path)).elevation(lattice, Stream(1, "ground"))
    text, _ = Workspace(tmp_path).plainly(str(refused.value), [])
    assert "EPSG:32633 (UTM zone 33N), to which a GIS" in text
    assert str(tmp_path) not in text
    assert_plain(text)
