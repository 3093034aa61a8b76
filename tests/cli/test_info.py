"""``barchan info``: what a run holds and how far it is."""

import csv
import io
import json
import os
import re

import pytest

from barchan.analysis.declared_measures import in_rows
from barchan.analysis.time_series import last_values
from barchan.archive import Archive, open_run
from barchan.entry import load
from barchan.simulation import Simulation, Stroke
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
    assert rows["unit"] == "slabs of 0.333 m"
    assert rows["wind"] == "from 270° with hops of 5 cells (model.hop_length)"
    assert rows["seed"] == "7"
    assert rows["frames"] == "5, the last at step 20 of 20"
    assert rows["checkpoint"] == "step 20"
    assert rows["state"] == "all steps done"
    assert rows["size"].endswith(" MB")


@pytest.mark.parametrize(
    ("wind", "told"),
    [
        ({"speed": 9.0, "unit": "m/s"}, "from 270° at 9 m/s with hops of 5 cells (model.hop_length)"),
        ({"speed": 7.0, "spread": 15.0}, "from 270° ± 15° with hops of 7 cells"),
    ],
)
def test_runs_whose_winds_differ_in_speed_alone_look_unlike(here, barchan, wind, told):
    Archive.create(here / "begun", Simulation(tiny(wind={"kind": "steady", **wind}, clock={}))).close()
    assert rows_of(barchan("info", "begun").out)["wind"] == told


def test_a_run_without_frames_tells_how_to_go_on(here, barchan):
    Archive.create(here / "begun", Simulation(tiny())).close()
    rows = rows_of(barchan("info", "begun").out)
    assert rows["frames"] == "none"
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


def rows_of_last(run):
    with open_run(run) as dataset:
        return in_rows(last_values(dataset, load(str(run))))


def test_a_measure_has_one_row_with_its_units_side_by_side(finished, barchan):
    table = barchan("info", finished).out.split("\n\n")[1]
    titles = [line.split("  ")[0] for line in table.splitlines()]
    assert titles == [row[0].measure.title for row in rows_of_last(finished)]
    assert len(set(titles)) == len(titles)
    highest = next(line for line in table.splitlines() if line.startswith("highest stack"))
    assert " m, " in highest
    assert highest.endswith(" slabs")
    assert "clockwise from north" in next(line for line in table.splitlines() if "resultant wind" in line)


def test_a_measure_that_should_not_be_quoted_is_marked_with_the_reason(here, barchan):
    barchan("run", "tiny.json", "--quiet", "--no-picture", "--run.steps", 0)
    table = barchan("info", "tiny").out.split("\n\n")[1]
    (speed,) = [line for line in table.splitlines() if line.startswith("migration downwind")]
    assert " – " in speed
    assert speed.endswith("? no earlier frame to compare with")


def test_measures_are_written_as_json_with_their_units_and_doubts(finished, barchan):
    data = json.loads(barchan("info", finished, "--json").out)
    assert data["contents"]["model"] == "werner"
    rows = rows_of_last(finished)
    assert [measure["name"] for measure in data["measures"]] == [row[0].measure.name for row in rows]
    for measure, row in zip(data["measures"], rows, strict=True):
        assert [value["unit"] for value in measure["values"]] == [value.measure.unit for value in row]
        assert measure["doubt"] == (row[0].doubt or None)
        for written, value in zip(measure["values"], row, strict=True):
            assert written["value"] is None or written["value"] == value.value


def test_measures_are_written_as_csv_a_row_each(finished, barchan):
    table = list(csv.DictReader(io.StringIO(barchan("info", finished, "--csv").out)))
    rows = rows_of_last(finished)
    assert [line["name"] for line in table] == [row[0].measure.name for row in rows]
    speed = next(line for line in table if line["name"] == "speed")
    assert (speed["unit"], speed["unit_2"]) == ("m/step", "cells/step")
    assert all(None not in line for line in table)


def test_json_and_csv_exclude_each_other(finished, barchan):
    result = barchan("info", finished, "--json", "--csv")
    assert result.code == 1
    assert "--json and --csv are both given" in result.err


def test_a_run_without_frames_has_no_measures_in_json_and_csv(here, barchan):
    Archive.create(here / "begun", Simulation(tiny())).close()
    assert json.loads(barchan("info", "begun", "--json").out)["measures"] == []
    assert barchan("info", "begun", "--csv").out.splitlines() == ["name,title,value,unit,reference,doubt"]


def test_windward_may_refer_to_the_last_wind(finished, barchan):
    assert barchan("info", finished, "--wind", "last").code == 0
    assert barchan("info", finished, "--wind", "first").code != 0


@pytest.fixture
def changed(finished, barchan):
    """A branch from step 10 with another wind and another hop length."""
    values = ("--wind.direction", 200, "--model.hop-length", 2)
    barchan("resume", finished, "--at", 10, "--out", "branch", "--no-picture", "--quiet", *values)
    return "branch"


def test_a_branch_tells_the_wind_of_now_and_what_was_changed(changed, barchan):
    out = barchan("info", changed).out
    assert rows_of(out)["wind"] == "from 200° with hops of 2 cells (model.hop_length)"
    told = [line.split(None, 1)[1] for line in out.splitlines() if line.startswith("changed")]
    assert told == ["at step 10: model.hop_length 2", "at step 10: wind from 200°"]


def test_the_wind_of_a_branch_is_that_of_now(changed, barchan):
    rows = rows_of(barchan("wind", changed).out)
    assert rows["wind"] == "from 200° with hops of 2 cells (model.hop_length)"
    assert rows["changed"] == "at step 10: wind from 200°"


@pytest.mark.parametrize(("step", "times"), [(5, 0), (10, 0), (20, 2)])
def test_a_picture_says_what_had_been_changed_before_its_frame(changed, barchan, step, times):
    assert barchan("show", changed, "--step", step).out.count("note: changed at step 10") == times


def test_a_run_that_is_being_written_says_so(finished, barchan):
    archive = Archive(finished)
    during = rows_of(barchan("info", finished).out)["state"]
    archive.close()
    assert during == f"being written by process {os.getpid()}"
    assert rows_of(barchan("info", finished).out)["state"] == "all steps done"


def test_paint_is_listed_and_long_lists_are_cut(here, barchan):
    simulation = Simulation(tiny())
    for _ in range(25):
        simulation.apply(Stroke(x=4.0, y=5.0, radius=3.0, amount=5))
    Archive.create(here / "painted", simulation).close()
    told = [line for line in barchan("info", "painted").out.splitlines() if line.startswith("changed")]
    assert told[0].endswith("5 times before")
    assert told[-1].endswith("at step 0: sand +5 slabs within 3 m of x 4 m, y 5 m")
    assert len(told) == 21


def test_the_balance_of_snow_is_told_to_the_quantum(here, barchan):
    """0.000463 kg/m²/s for 10 steps of 24.9 s are 0.0384 quanta of 3 kg/m² on each of 384 cells: 14.8."""
    words = ["--lattice.rows", "16", "--lattice.columns", "24", "--run.steps", "10", "--quiet"]
    assert barchan("run", "snow-storm", *words, "--no-picture", "--out", "snow").code == 0
    (line,) = (row for row in barchan("info", "snow").out.splitlines() if row.startswith("balance"))
    numbers = re.fullmatch(
        r"balance\s+(\d+) quanta held = (\d+) at the start \+ (\d+) fallen \+ 0 entered - 0 left", line
    )
    held, start, fallen = map(int, numbers.groups())
    assert start == 7 * 16 * 24
    assert fallen == pytest.approx(14.8, abs=1)
    assert held == start + fallen
