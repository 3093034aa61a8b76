"""Files and archives of format 2 keep their shadow lines and their bits under winds off the axes.

The numbers are those of the version that wrote them, commit ff59197.
"""

import shutil
from pathlib import Path

from barchan import Simulation, load, open_run, resume
from tests.simulation.old_runs import counts

OLD = Path(__file__).parents[1] / "data" / "format_2"


def test_a_file_of_format_2_gives_the_same_bits():
    scenario = load(OLD / "oblique.json")
    assert scenario.model.shadow_from == "centre"
    simulation = Simulation(scenario)
    simulation.advance(40)
    assert counts(simulation) == (122880, 95340, "e114bf7dcdae1860")


def test_a_run_of_format_2_goes_on_with_the_same_bits_after_its_wind_was_changed(tmp_path):
    shutil.copytree(OLD / "oblique-run", tmp_path / "run")
    with open_run(tmp_path / "run") as run:
        assert run.attrs["scenario"].count('"shadow_from": "centre"') == 1
    simulation = resume(tmp_path / "run", steps=80).simulation
    assert counts(simulation) == (245760, 191806, "e862158ca96721cf")
    assert simulation.scenario.barchan == 5
