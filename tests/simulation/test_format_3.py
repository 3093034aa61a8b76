"""Files and archives of format 3 on hexagons keep their shadow lines and their bits under winds off the axes.

The numbers are those of the version that wrote them, commit 4fef516.
"""

import shutil
from pathlib import Path

from barchan import Simulation, load, open_run, resume
from tests.simulation.old_runs import counts

OLD = Path(__file__).parents[1] / "data" / "format_3"


def test_a_file_of_format_3_on_hexagons_gives_the_same_bits():
    scenario = load(OLD / "hexagons.json")
    assert scenario.model.shadow_from == "centre"
    simulation = Simulation(scenario)
    simulation.advance(40)
    assert counts(simulation) == (76800, 47718, "185a7e78e5399b59")


def test_a_run_of_format_3_on_hexagons_goes_on_with_the_same_bits(tmp_path):
    shutil.copytree(OLD / "hexagons-run", tmp_path / "run")
    with open_run(tmp_path / "run") as run:
        assert run.attrs["scenario"].count('"shadow_from": "auto"') == 1
    simulation = resume(tmp_path / "run", steps=80).simulation
    assert counts(simulation) == (153600, 77241, "5d9bf254cc94636c")
    assert simulation.scenario.model.shadow_from == "centre"
    assert simulation.scenario.barchan == 5
