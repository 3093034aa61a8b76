"""What the page is told has words of the page, not those of a file or of the command line."""

import json
import re

import pytest

from barchan.errors import ScenarioError
from barchan.ground.surface import FileGround
from barchan.lattice import Lattice
from barchan.scenario import validate
from barchan.simulation import Simulation
from barchan.streams import Stream
from barchan.studio.page_words import page_words
from barchan.studio.server.queries import QUERIES
from barchan.studio.server.workspace import Workspace
from barchan.studio.worker.description import description

TINY = {"barchan": 5, "lattice": {"rows": 16, "columns": 16}, "run": {"seed": 1}}

OF_THE_COMMAND_LINE = re.compile(r'--|\{"|"unit":|\bkey \b|\bmodel\.|\brio\b')


def assert_of_the_page(text: str) -> None:
    assert not OF_THE_COMMAND_LINE.search(text), text


@pytest.mark.parametrize(
    ("wind", "model", "advice"),
    [
        ({"kind": "steady", "speed": 8.0, "unit": "m/s"}, "werner", "switch Clock on in the panel, or"),
        ({"kind": "record"}, "werner", "switch Clock on in the panel"),
        ({"kind": "regimes", "regimes": [{"direction": 0, "seconds": 60}]}, "werner", "or state it in steps"),
        ({"kind": "steady", "speed": 5.0}, "ripples", "in m/s, chosen as its unit, or leave it out"),
        ({"kind": "steady", "speed": 800.0, "unit": "m/s"}, "werner", "a hop length (unit cells)"),
    ],
)
def test_what_is_wrong_with_a_scenario_is_said_in_words_of_the_page(tmp_path, wind, model, advice):
    data = {**TINY, "wind": wind, "model": {"name": model}}
    told = QUERIES["check"](Workspace(tmp_path), {"text": json.dumps(data)})
    (problem,) = told["problems"]
    assert advice in problem["message"]
    assert_of_the_page(problem["message"])
    with pytest.raises(ScenarioError) as refused:
        validate(data)
    text, (problem,) = Workspace(tmp_path).plainly(
        str(refused.value), [vars(one) for one in refused.value.problems]
    )
    assert advice in text
    assert problem["key"] == refused.value.problems[0].key
    assert_of_the_page(text + problem["message"])
    assert OF_THE_COMMAND_LINE.search(str(refused.value)), "the command line keeps its own words"


def test_a_remark_is_said_in_words_of_the_page():
    data = {**TINY, "lattice": {**TINY["lattice"], "boundary_x": "open"}}
    simulation = Simulation(validate(data))
    said = " ".join(description(simulation, simulation.scenario)["remarks"])
    assert "choose what enters under Influx in the panel" in said
    assert_of_the_page(said)
    assert 'with "influx"' in " ".join(simulation.scenario.remarks())


def test_a_map_in_degrees_is_refused_in_words_of_the_page(tmp_path):
    path = tmp_path / "dem.asc"
    head = "ncols 8\nnrows 8\nxllcorner 14.2\nyllcorner 40.1\ncellsize 0.000277777778\n"
    path.write_text(head + "1 2 3 4 5 6 7 8\n" * 8)
    lattice = Lattice(rows=8, columns=8)
    with pytest.raises(ScenarioError) as refused:
        FileGround(path=str(path)).elevation(lattice, Stream(1, "ground"))
    assert "rio warp" in str(refused.value)
    text, _ = Workspace(tmp_path).plainly(str(refused.value), [])
    assert "EPSG:32633 (UTM zone 33N), which a GIS does" in text
    assert_of_the_page(text)


def test_other_texts_are_left_as_they_are():
    assert page_words("hop length is 0; allowed: from 1") == "hop length is 0; allowed: from 1"
