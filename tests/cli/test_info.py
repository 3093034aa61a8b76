"""``barchan info``: what a run holds and how far it is."""

import pytest

from barchan.archive import Archive
from barchan.simulation import Simulation
from tests.tiny import tiny


def rows_of(out):
    """The table as name and value."""
    rows = (line.split("  ", 1) for line in out.splitlines() if "  " in line)
    return {name.strip(): value.strip() for name, value in rows}


def test_a_finished_run_tells_what_it_is(finished, barchan):
    rows = rows_of(barchan("info", finished).out)
    assert rows["title"] == "Tiny"
    assert rows["model"] == "werner"
    assert rows["field"] == "24 × 16 cells of 1 m"
    assert rows["slab height"] == "0.3333 m"
    assert rows["wind"] == "from 270°"
    assert rows["seed"] == "7"
    assert rows["frames"] == "5, the last at step 20 of 20"
    assert rows["checkpoint"] == "step 20"
    assert rows["state"] == "all steps done"
    assert rows["size"].endswith(" MB")


def test_a_run_without_frames_tells_how_to_go_on(here, barchan):
    Archive.create(here / "begun", Simulation(tiny())).close()
    rows = rows_of(barchan("info", "begun").out)
    assert rows["frames"] == "0, the last at step 0 of 20"
    assert rows["state"] == "not finished; go on with: barchan resume begun"


def test_a_run_without_a_title_has_a_dash(here, barchan):
    barchan("run", "tiny.json", "--quiet", "--no-picture", "--title=")
    assert rows_of(barchan("info", "tiny").out)["title"] == "–"


def test_a_long_title_is_told_whole(here, barchan):
    title = " ".join(["a title that goes on and on"] * 6)
    barchan("run", "tiny.json", "--quiet", "--no-picture", "--title", title)
    assert title in " ".join(barchan("info", "tiny").out.split())


def test_the_command_that_goes_on_stands_on_one_line(here, barchan):
    folder = here / "a-folder-of-a-rather-long-name" / "with-another-one-in-it"
    Archive.create(folder, Simulation(tiny())).close()
    assert f"barchan resume {folder}" in barchan("info", folder).out


@pytest.mark.parametrize("title", ["[/]", "dunes [red] and blue", "[bold]dunes"])
def test_a_title_with_brackets_is_told_as_it_is(here, barchan, title):
    barchan("run", "tiny.json", "--quiet", "--no-picture", "--title", title)
    assert rows_of(barchan("info", "tiny").out)["title"] == title


def test_the_measures_of_the_last_frame_are_told_the_models_own_too(here, barchan):
    ran = barchan("run", "tiny.json", "--model.name", "momiji").out
    table = barchan("info", "tiny").out.split("\n\n")[1]
    assert table in ran
    assert "highest stack" in table
    assert "reference height of hops" in table
