"""Files and archives of format 1 still open, and go on with the same bits."""

import hashlib
import shutil
from pathlib import Path

import pytest

from barchan import load, open_run, resume
from barchan.archive import run_info

OLD = Path(__file__).parents[1] / "data" / "format_1"


@pytest.mark.parametrize("path", sorted(OLD.glob("*.json")), ids=lambda path: path.stem)
def test_a_scenario_of_format_1_is_the_preset_of_today(path):
    today, old = load(path.stem).data(), load(path).data()
    for words in ("title", "citation", "look_for", "question"):
        today.pop(words), old.pop(words)
    if "relief_flow" in today["model"]:  # the file states the coefficients that were the defaults of its time
        coefficients = [
            old["model"]["relief_flow"].pop(f"stress_in_{name}") for name in ("phase", "quadrature")
        ]
        assert coefficients == [4.0, 2.0]
        old["model"]["relief_flow"] |= {"stress_in_phase": None, "stress_in_quadrature": None}
    if today["wind"]["kind"] == "record":  # the file states the codes for missing values of its time
        assert set(old["wind"]["columns"].pop("missing")) < set(today["wind"]["columns"].pop("missing"))
    if today["model"].get("shadow_from") == "auto":  # the file states where lines started in its time
        assert (old["model"].pop("shadow_from"), today["model"].pop("shadow_from")) == ("centre", "auto")
    if today["model"].get("neighbour_order") == "auto":  # and where slabs slid
        assert (old["model"].pop("neighbour_order"), today["model"].pop("neighbour_order")) == (
            "wind",
            "auto",
        )
        tops = old["model"].pop("stack_tops"), today["model"].pop("stack_tops")
        assert tops in {
            ("level", "sloping"),
            ("sloping", "sloping"),
        }  # where they do not act it is all the same
    assert old == today


def digest(simulation):
    return hashlib.sha256(simulation.bed.sand.tobytes()).hexdigest()[:16]


def test_an_archive_of_format_1_opens(tmp_path):
    with open_run(OLD / "momiji-run") as run:
        assert list(run["step"].values) == [20, 40]
    assert run_info(OLD / "momiji-run").checkpoint == 40


def test_a_run_of_format_1_goes_on_with_the_same_bits(tmp_path):
    """As it went on in the version that wrote it."""
    shutil.copytree(OLD / "momiji-run", tmp_path / "run")
    simulation = resume(tmp_path / "run", steps=80).simulation
    assert (simulation.tally.polls, simulation.tally.moved) == (30720, 16429)
    assert digest(simulation) == "9e05fd09f805110d"
    assert [record.event.kind for record in simulation.events] == ["stroke", "set", "set"]


def test_a_run_of_grains_of_format_1_goes_on_with_the_same_bits(tmp_path):
    """As it went on in the version that wrote it."""
    shutil.copytree(OLD / "ripples-run", tmp_path / "run")
    simulation = resume(tmp_path / "run", steps=4).simulation
    assert (simulation.tally.polls, simulation.tally.moved) == (17650, 1168)
    assert digest(simulation) == "8551ccf76a507e37"
