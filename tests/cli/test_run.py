"""``barchan run``: one command from a scenario to a picture."""

import subprocess
import sys

import pytest
from PIL import Image

from barchan.analysis.declared_measures import MEASURES
from barchan.archive import open_run, run_info
from barchan.entry import load
from barchan.scenario import load_scenario
from tests.tiny import tiny

SMALL = ["--lattice.rows", 16, "--lattice.columns", 24, "--run.steps", 4, "--run.save-every", 2]
QUIET = ["--quiet", "--no-picture"]


def folders_in(place):
    return sorted(path.name for path in place.iterdir() if path.is_dir())


def test_a_run_tells_what_it_does_and_where_it_is(here, barchan):
    result = barchan("run", "tiny.json")
    assert (result.code, result.err) == (0, "")
    assert "Tiny" in result.out
    assert "24 × 16 cells of 1 m, slabs of 0.333 m, 20 steps, seed 7" in result.out
    assert "effective repose angle: 33.7° towards faces (2 slabs)" in result.out
    assert "all steps done at step 20" in result.out
    assert "run: tiny\n" in result.out
    assert f"picture: {'tiny'}/last.png\n" in result.out


@pytest.mark.parametrize(
    ("preset", "counts"),
    [("werner-strip", "polls"), ("szabo-10", "grain updates"), ("coupled-map", "cell updates")],
)
def test_a_run_tells_its_rate_in_what_its_model_counts(here, barchan, preset, counts):
    """The first steps do not count, so there are more."""
    out = barchan("run", preset, *SMALL, "--run.save-every", 1, "--no-picture", "--out", "rated").out
    assert f" million {counts}/s)" in out


def test_a_run_ends_with_a_table_of_all_measures(here, barchan):
    out = barchan("run", "tiny.json").out
    for measure in MEASURES:
        assert measure.title in out
    sand = load_scenario("tiny.json").sand
    assert sand.kind == "random"
    with open_run("tiny") as dataset:
        highest = int(dataset["sand"][-1].max())
    assert f", {highest} slabs\n" in out


def test_a_run_ends_with_a_picture(here, barchan):
    barchan("run", "tiny.json", "--quiet")
    with Image.open("tiny/last.png") as picture:
        assert picture.format == "PNG"
        assert min(picture.size) > 300


def test_a_quiet_run_prints_nothing(here, barchan):
    result = barchan("run", "tiny.json", "--quiet")
    assert (result.code, result.out, result.err) == (0, "", "")
    assert run_info("tiny").frames == 5


def test_a_run_without_a_picture_draws_none(here, barchan):
    result = barchan("run", "tiny.json", "--no-picture")
    assert "picture" not in result.out
    assert not (here / "tiny" / "last.png").exists()


def test_every_run_without_a_folder_gets_a_new_one(here, barchan):
    for _ in range(3):
        assert barchan("run", "tiny.json", *QUIET).code == 0
    assert folders_in(here) == ["tiny", "tiny-2", "tiny-3"]


def test_a_preset_is_run_into_a_folder_of_its_name(here, barchan):
    assert barchan("run", "barchans", *QUIET, *SMALL).code == 0
    assert folders_in(here) == ["barchans"]


def test_a_preset_that_was_run_before_is_run_again_with_another_seed(here, barchan):
    for _ in range(2):
        assert barchan("run", "barchans", *QUIET, *SMALL).code == 0
    assert folders_in(here) == ["barchans", "barchans-2"]
    assert load(here / "barchans").seed != load("barchans-2").seed


def test_a_folder_that_is_no_run_does_not_hide_a_preset(here, barchan):
    (here / "barchans").mkdir()
    assert barchan("run", "barchans", *QUIET, *SMALL).code == 0


def test_a_file_of_the_folders_name_is_passed_by(here, barchan):
    (here / "tiny").write_text("a file")
    barchan("run", "tiny.json", *QUIET)
    assert (here / "tiny").read_text() == "a file"
    assert run_info("tiny-2").frames == 5


def test_a_seed_that_was_drawn_is_told_and_kept(here, barchan):
    out = barchan("run", "tiny.json", "--no-picture", "--run.seed", "null").out
    seed = load("tiny").run.seed
    assert f"seed {seed} (random)" in out


def test_a_long_hop_is_warned_of(here, barchan):
    out = barchan("run", "tiny.json", "--no-picture", "--model.hop-length", 13).out
    assert "note: hop length 13 cells is longer than half the field along the wind (24 cells)" in out


def test_the_folder_of_a_run_is_run_again(here, barchan, finished):
    assert barchan("run", "tiny", *QUIET, "--out", "again").code == 0
    with open_run("tiny") as one, open_run("again") as other:
        assert one.identical(other)


def test_the_folder_of_a_run_is_run_again_with_other_values(here, barchan, finished):
    barchan("run", "tiny", *QUIET, "--out", "again", "--run.steps", 7)
    assert load("again") == tiny(run__steps=7)


def test_a_run_is_not_overwritten_unless_asked(here, barchan, finished):
    refused = barchan("run", "tiny.json", "--out", "tiny", "--run.seed", 8, *QUIET)
    assert (refused.code, refused.out) == (1, "")
    assert "tiny is not empty; choose another folder, or add --overwrite to replace it" in refused.err
    assert load("tiny").seed == 7
    (finished / "letter.txt").write_text("dear")
    assert barchan("run", "tiny.json", "--out", "tiny", "--run.seed", 8, "--overwrite", *QUIET).code == 0
    assert load("tiny").seed == 8
    assert (finished / "letter.txt").read_text() == "dear"


def test_sand_that_left_is_told(here, barchan):
    out = barchan("run", "tiny.json", "--no-picture", "--lattice.boundary-x", "open").out
    with open_run("tiny") as dataset:
        left = int(dataset["left"][-1])
    assert f"{left} slabs left through open edges" in out


def test_the_reason_of_an_early_end_is_told(here, barchan):
    bare = ["--sand", '{"kind": "flat", "mean": 0}', "--run.until.idle_steps", 3]
    assert "nothing moved for 3 steps at step 3" in barchan("run", "tiny.json", "--no-picture", *bare).out


def test_a_field_of_one_row_runs_to_its_picture(here, barchan):
    result = barchan("run", "tiny.json", "--lattice.rows", 1, "--quiet")
    assert (result.code, result.err) == (0, "")
    assert (here / "tiny" / "last.png").exists()


@pytest.mark.parametrize("name", ["dunes[a]", "dunes[/a]", "dunes[red]"])
def test_a_folder_with_brackets_is_told_by_its_name(here, barchan, name):
    result = barchan("run", "tiny.json", "--no-picture", "--out", name)
    assert result.code == 0
    assert f"run: {name}\n" in result.out


CACHE = """
import sys
sys.argv = ["barchan", "run", sys.argv[1], "--quiet", "--no-picture", "--out", sys.argv[2]]
import atexit
from barchan.cli import main
atexit.register(lambda: print(__import__("numba").config.CACHE_DIR))
main()
"""


def test_kernels_of_a_checkout_are_kept_by_their_sources(here, monkeypatch):
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    command = [sys.executable, "-c", CACHE, "tiny.json", "run"]
    run = subprocess.run(command, check=True, capture_output=True, text=True)
    assert ".numba_cache" in run.stdout
