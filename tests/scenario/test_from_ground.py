"""A lattice taken from the ground's file."""

import json

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.scenario import load_scenario

HEAD = "ncols 24\nnrows 16\nxllcorner 500000\nyllcorner 4000000\ncellsize 2.5\n"


@pytest.fixture
def dem(tmp_path):
    heights = np.arange(16 * 24.0).reshape(16, 24) / 50
    (tmp_path / "dem.asc").write_text(HEAD + "\n".join(" ".join(map(str, row)) for row in heights))
    return str(tmp_path / "dem.asc")


def scenario(path, lattice="from ground", **ground):
    return {"barchan": 5, "lattice": lattice, "ground": {"kind": "file", "path": path, **ground}}


def refused(data, overrides=()):
    with pytest.raises(ScenarioError) as caught:
        load_scenario(data, overrides)
    return [(problem.key, problem.message) for problem in caught.value.problems]


def test_rows_columns_and_cell_size_are_those_of_the_file(dem):
    lattice = load_scenario(scenario(dem)).lattice
    assert (lattice.rows, lattice.columns, lattice.cell_size) == (16, 24, 2.5)


def test_the_scenario_states_the_sizes_that_it_took(dem):
    stated = load_scenario(scenario(dem)).data()["lattice"]
    assert (stated["kind"], stated["rows"], stated["cell_size"]) == ("square", 16, 2.5)


def test_slabs_and_edges_may_stand_beside_it(dem):
    lattice = load_scenario(
        scenario(dem, {"kind": "from ground", "slab_height": 0.1, "boundary_x": "open"})
    ).lattice
    assert (lattice.columns, lattice.slab_height, lattice.boundary_x) == (24, 0.1, "open")


def test_another_cell_size_gives_as_many_cells_as_the_file_covers(dem):
    """60 by 40 m in cells of 7 m: 8 whole columns and 5 whole rows."""
    lattice = load_scenario(scenario(dem, {"kind": "from ground", "cell_size": 7.0}, resample=True)).lattice
    assert (lattice.rows, lattice.columns, lattice.cell_size) == (5, 8, 7.0)


def test_on_the_command_line_the_sizes_of_a_preset_give_way(dem):
    values = [("ground.kind", "file"), ("ground.path", dem), ("lattice.kind", "from ground")]
    assert load_scenario("lone-barchan", values).lattice.shape == (16, 24)
    both = [*values, ("lattice.boundary-y", "open"), ("lattice", "from ground")]
    assert load_scenario("barchans", both).lattice.shape == (16, 24)
    assert refused("barchans", [*values, ("lattice.rows", "7")]) == [
        ("lattice.rows", "is given, but the lattice is 'from ground'")
    ]


def test_a_path_in_a_file_starts_where_the_file_lies(dem, tmp_path):
    (tmp_path / "dunes.json").write_text(json.dumps(scenario("dem.asc")))
    assert load_scenario(tmp_path / "dunes.json").lattice.shape == (16, 24)


def test_a_ground_that_cannot_give_a_lattice_is_refused(dem, tmp_path):
    assert refused({"barchan": 5, "lattice": "from ground"}) == [
        ("lattice", "is 'from ground', which needs a ground of kind 'file'")
    ]
    gone = str(tmp_path / "gone.asc")
    assert refused(scenario(gone)) == [("ground.path", f"'{gone}': no such file")]
    assert [key for key, _ in refused(scenario(dem, fil="no"))] == ["ground.fil"]


def test_an_array_gives_rows_and_columns_alone(tmp_path):
    np.save(tmp_path / "a.npy", np.zeros((9, 11)))
    given = scenario(str(tmp_path / "a.npy"), {"kind": "from ground", "cell_size": 0.5})
    lattice = load_scenario(given).lattice
    assert (lattice.rows, lattice.columns, lattice.cell_size) == (9, 11, 0.5)
