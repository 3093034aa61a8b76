"""``barchan measure``: any surface, and two dates of one."""

import csv
import io
import json

import numpy as np
import pytest

from tests.measures.landforms import PLACES, field_of_dunes
from tests.measures.landforms import barchan as one_barchan


@pytest.fixture
def surface(here):
    np.save(here / "before.npy", field_of_dunes(one_barchan, PLACES))
    np.save(here / "after.npy", np.roll(field_of_dunes(one_barchan, PLACES), 4, axis=1))
    return here


def test_a_file_is_measured_and_its_crests_and_dunes_are_written(surface, barchan):
    done = barchan(
        "measure", "before.npy", "--cell-size", 2, "--crests", "c.geojson", "--dunes", "d.csv", "--wind", 270
    )
    assert done.code == 0
    lines = done.out.splitlines()
    assert lines[0] == "128 × 128 cells of 2 m"
    assert lines[1].startswith("class: barchan (horns point downwind")
    assert "single dunes              3" in done.out
    assert lines[-2:] == ["c.geojson", "d.csv"]
    assert len((surface / "d.csv").read_text("utf-8").splitlines()) == 4
    assert json.loads((surface / "c.geojson").read_text("utf-8"))["features"]


def test_numbers_come_as_json_and_as_csv(surface, barchan):
    data = json.loads(barchan("measure", "before.npy", "--cell-size", 2, "--json").out)
    assert data["class"]["name"] == "barchan"
    by_name = {row["name"]: row for row in data["measures"]}
    rows = list(csv.DictReader(io.StringIO(barchan("measure", "before.npy", "--cell-size", 2, "--csv").out)))
    heights = {row["name"]: row["value"] for row in rows}
    assert float(heights["dune_height"]) == by_name["dune_height"]["values"][0]["value"]
    assert heights["class"] == "barchan"


def test_two_dates_tell_the_way_with_its_error(surface, barchan):
    done = barchan("measure", "before.npy", "after.npy", "--cell-size", 2, "--years", 4, "--json")
    found = {row["name"]: row for row in json.loads(done.out)["change"]}
    assert found["east"]["value"] == pytest.approx(8.0, abs=0.1)
    assert found["speed"]["value"] == pytest.approx(2.0, abs=0.03)
    assert found["net"]["value"] == pytest.approx(0.0, abs=1e-6)
    assert "migration eastwards" in barchan("measure", "before.npy", "after.npy", "--cell-size", 2).out
    header = barchan("measure", "before.npy", "after.npy", "--cell-size", 2, "--csv").out.splitlines()[0]
    assert header == "name,title,value,error,unit,doubt"


def test_a_run_is_measured_with_its_wind_and_frames_are_compared(finished, barchan):
    done = barchan("measure", finished, "--json")
    data = json.loads(done.out)
    by_name = {row["name"]: row for row in data["measures"]}
    assert {"flux", "speed", "defect_density", "crest_spacing"} <= set(by_name)
    assert by_name["wind"]["values"][0]["value"] == pytest.approx(270.0)
    assert data["file"].endswith("tiny at step 20")
    assert "volume deposited" in barchan("measure", finished, "--step", "5,20").out
    assert "no frame at step 7; saved: 0, 5, 10, 15, 20" in barchan("measure", finished, "--step", 7).err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["before.npy"], "has no coordinates; give --cell-size"),
        (["before.npy", "--cell-size", 2, "--json", "--csv"], "give one of them"),
        (["before.npy", "--cell-size", 2, "--years", 2], "--years: for two surfaces; one is given"),
        (["before.npy", "after.npy", "--cell-size", 2, "--dunes", "d.csv"], "are for one surface"),
        (["before.npy", "--cell-size", 2, "--missing", "x"], "--missing x; allowed: numbers"),
        (["before.npy", "--cell-size", 2, "--step", "1"], "--step 1 is for runs"),
        (["before.npy", "--cell-size", 2, "--step", "a"], "--step a; allowed: a saved step"),
        (["before.npy", "--cell-size", 2, "--flatten", 1], "--flatten 1 m; allowed: 8 m"),
        (["before.npy", "--cell-size", 2, "--crests", "c.shp"], "written as .shp; allowed: .geojson"),
    ],
)
def test_what_does_not_fit_is_refused_with_what_is_allowed(surface, barchan, words, message):
    done = barchan("measure", *words)
    assert (done.code, message in done.err) == (1, True), done.err
