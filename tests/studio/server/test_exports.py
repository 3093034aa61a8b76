"""Runs exported from the page: read back by other libraries, and nothing else can be fetched."""

import io
import re
import zipfile
from datetime import datetime

import httpx
import numpy as np
import pytest
import trimesh
from PIL import Image

from barchan.errors import BarchanError, ExportError
from barchan.export.options import WORDING, Options, options_of
from barchan.studio.worker.exporting import export_states
from barchan.studio.worker.run import started, states_of
from tests.studio.worker.test_run import run_to


@pytest.fixture
def exported(served):
    """Runs 20 steps, exports them under a name, and fetches the file."""

    def fetch(name, **options):
        with served.browser() as browser:
            browser.until_frame()
            browser.send("pause")
            browser.send("run", steps=20)
            browser.until_frame(lambda status: status["step"] >= 20 and not status["running"])
            browser.send("export", name=name, id=3, **options)
            answer = browser.until(
                lambda header, _: header.get("id") == 3 and header["type"] in ("done", "refused")
            )[0]
        if answer["type"] == "refused":
            return answer, None
        headers = {"x-barchan-token": served.guard.token}
        return answer, httpx.get(f"{served.address}/api/exports/{answer['file']}", headers=headers)

    return fetch


def test_a_grid_of_the_shown_state_is_fetched(exported):
    """32 rows of 48 values; the elevation of a field in whole slabs of a third of a metre."""
    _, answer = exported("dunes.asc")
    lines = answer.text.splitlines()
    heads = dict(line.split() for line in lines[:6])
    values = np.loadtxt(io.StringIO("\n".join(lines[6:])))
    assert (int(heads["ncols"]), int(heads["nrows"])) == (48, 32) == values.shape[::-1]
    assert np.abs(values * 3 - np.rint(values * 3)).max() < 1e-3


def test_a_mesh_is_smoothed_on_request(exported):
    _, answer = exported("dunes.glb", options={"smooth": 1.0})
    mesh = trimesh.load(io.BytesIO(answer.content), file_type="glb", force="mesh")
    assert len(mesh.vertices) == 32 * 48


def test_several_files_come_in_one_archive_with_all_kept_states(exported):
    _, answer = exported("dunes.pvd")
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        names = archive.namelist()
    assert "dunes.pvd" in names
    assert sum(name.endswith(".vti") for name in names) >= 2
    assert "dunes.pvd.json" in names


def test_a_film_holds_the_states_that_were_asked_for_and_says_how_far_it_is(exported):
    """Of the states after 0, 10 and 20 steps the last two."""
    _, answer = exported("dunes.webp", states=2, options={"frames_per_second": 4.0, "pixels": 64})
    with Image.open(io.BytesIO(answer.content)) as picture:
        assert picture.n_frames == 2
        assert max(picture.size) == 48


def test_drawing_a_film_counts_its_frames_and_ends_where_counting_ends_it(scenario, tmp_path):
    """Two states: two are read, two are drawn."""
    run = started(scenario)
    run_to(run, 10)
    counts = []
    export_states(states_of(run), tmp_path / "f.webp", {"pixels": 48}, lambda *so_far: counts.append(so_far))
    assert counts == [(1, 4), (2, 4), (3, 4), (4, 4)]

    def until_drawing(done, _):
        if done > 2:
            raise BarchanError("broken off")

    with pytest.raises(BarchanError, match="broken off"):
        export_states(states_of(run), tmp_path / "g.webp", {"pixels": 48}, until_drawing)
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith("g")] == []


def test_grids_of_several_states_and_fields_come_a_file_each(exported):
    """Of two states two fields: four grids, all of 3 columns."""
    _, answer = exported("dunes.asc", states=2, fields=["depth", "slope"], options={"cells": [3, 2]})
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        grids = sorted(name for name in archive.namelist() if name.endswith(".asc"))
        heads = {archive.read(name).decode().split()[1] for name in grids}
    assert [name.split("-")[1] for name in grids] == ["depth", "depth", "slope", "slope"]
    assert heads == {"3"}


@pytest.mark.parametrize(
    ("name", "options", "said"),
    [
        ("d.glb", {"exaggerate": 0}, "heights ×: is 0; allowed: above 0"),
        ("d.asc", {"dpi": 100}, "dots per inch: asc does not take it; of these options it takes smoothing"),
        ("d.glb", {"split": "many"}, "vertices along a part: is 'many'"),
        ("d.glb", {"speed": 1}, "speed: no such option"),
    ],
)
def test_wrong_options_are_refused_in_the_words_of_the_page(scenario, tmp_path, name, options, said):
    states = states_of(started(scenario))
    with pytest.raises(ExportError, match=re.escape(said)) as refused:
        export_states(states, tmp_path / name, options_of(options), lambda *_: None)
    assert "--" not in str(refused.value)


def test_every_option_of_an_export_has_its_wording():
    assert set(WORDING) == set(Options.__dataclass_fields__)
    assert options_of({"cells": [3, 2], "epoch": "2020-05-01T06:00", "flip": False}) == {
        "cells": (3, 2),
        "epoch": datetime(2020, 5, 1, 6),
    }


@pytest.mark.parametrize("name", ["../dunes.asc", "dunes.doc", "dunes"])
def test_other_names_are_refused(exported, name):
    answer, _ = exported(name)
    assert answer["type"] == "refused"


@pytest.mark.parametrize("path", ["1/../../scenario.json", "x/dunes.asc", "1/none.asc"])
def test_only_exported_files_can_be_fetched(served, path):
    headers = {"x-barchan-token": served.guard.token}
    assert httpx.get(f"{served.address}/api/exports/{path}", headers=headers).status_code == 404


def test_without_the_token_there_are_neither_formats_nor_files(served):
    for path in ("formats", "exports/1/dunes.asc"):
        assert httpx.get(f"{served.address}/api/{path}").status_code == 403


def test_the_section_over_time_is_fetched_as_a_table(served):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("pause")
        browser.send("space_time_file", name="over-time.csv", line=[0.5, 5.5, 40.5, 5.5], id=5)
        answer = browser.until_message("done", id=5)
    headers = {"x-barchan-token": served.guard.token}
    rows = httpx.get(f"{served.address}/api/exports/{answer['file']}", headers=headers).text.splitlines()
    assert rows[0].startswith("step,0.0000,")
    assert rows[1].startswith("0,")
