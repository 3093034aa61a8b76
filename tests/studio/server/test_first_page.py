"""What a page gets first: quickly, compressed, and with headers that keep other sites away."""

import gzip
import io
import json
import re
import subprocess
import sys

import httpx
import numpy as np
import pytest
from PIL import Image

from barchan.errors import BarchanError
from barchan.scenario import preset_names
from barchan.studio.colours import TABLE, drawn
from barchan.studio.pictures import HEIGHT, WIDTH
from barchan.studio.server import gallery, launch, workspace
from barchan.studio.server.app import CLIENT
from barchan.studio.server.security import HEADERS
from barchan.studio.server.workspace import Workspace

FIRST_PAGE = """
import sys
from barchan.cli.studio import studio
from barchan.studio.colours import colours
from barchan.studio.server import app, gallery, launch
from barchan.scenario import load_scenario
load_scenario("barchans")
for given in (gallery.presets, gallery.schema, gallery.files_taken, colours):
    assert given()
print(*(name for name in ("scipy", "matplotlib", "xarray", "zarr") if name in sys.modules))
"""


def test_the_first_page_needs_neither_scipy_nor_matplotlib():
    run = subprocess.run([sys.executable, "-c", FIRST_PAGE], capture_output=True, text=True, check=True)
    assert run.stdout.split() == []


@pytest.mark.extended
def test_a_worker_draws_its_first_picture_without_what_takes_seconds_to_load():
    text = "import sys, barchan.studio.worker.commands; print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert not {"scipy.signal", "scipy.stats", "zarr", "xarray", "matplotlib"} & set(run.stdout.split())


def test_the_colours_that_are_shipped_are_those_of_the_figures():
    shipped = json.loads(TABLE.read_text("utf-8"))
    found = drawn()
    assert set(shipped) == set(found)
    for name, colours in found.items():
        assert np.abs(np.subtract(shipped[name], colours)).max() <= 1, name


def sent(served, path: str, encoding: str) -> bytes:
    """The bytes of an answer as they come over the line."""
    headers = {"x-barchan-token": served.guard.token, "accept-encoding": encoding}
    with httpx.stream("GET", f"{served.address}{path}", headers=headers) as answer:
        assert answer.headers.get("content-encoding", "identity") == encoding
        return b"".join(answer.iter_raw())


def test_long_answers_are_sent_compressed(served):
    assert len(sent(served, "/api/schema", "gzip")) < len(sent(served, "/api/schema", "identity")) / 4


@pytest.mark.skipif(not (CLIENT / "index.html").is_file(), reason="the client is not built")
def test_script_and_styles_of_the_page_are_sent_compressed(served):
    page = httpx.get(served.address).text
    names = re.findall(r'(?:src|href)="\.?(/assets/[^"]+\.(?:js|css))"', page)
    assert {name.rpartition(".")[2] for name in names} == {"js", "css"}
    for name in names:
        whole, packed = sent(served, name, "identity"), sent(served, name, "gzip")
        assert gzip.decompress(packed) == whole
        assert len(packed) < len(whole) / 3


def test_pages_of_others_can_neither_open_the_studio_nor_be_reached_by_it(served):
    headers = httpx.get(served.address).headers
    policy = headers["content-security-policy"]
    assert f"connect-src 'self' ws://127.0.0.1:{served.port};" in policy
    assert headers["cross-origin-opener-policy"] == "same-origin"
    assert set(map(str.lower, HEADERS)) <= set(headers)
    assert "server" not in headers


def test_the_usual_port_is_taken_and_a_free_one_where_it_is_in_use(monkeypatch):
    with launch.listener("127.0.0.1", 0) as free:
        usual = free.getsockname()[1]
    monkeypatch.setattr(launch, "PORT", usual)
    with launch.usual_listener("127.0.0.1") as first, launch.usual_listener("127.0.0.1") as second:
        assert first.getsockname()[1] == usual
        assert second.getsockname()[1] not in (usual, 0)


def test_uploads_are_limited_in_all(tmp_path, monkeypatch):
    monkeypatch.setattr(workspace, "QUOTA", 100)
    kept = Workspace(tmp_path)
    kept.keep("a.npy", b"1" * 60)
    with pytest.raises(BarchanError, match="would hold more than 0 MB; allowed: less"):
        kept.keep("b.npy", b"2" * 60)


@pytest.mark.parametrize("name", ["studio-uploads", "Studio-Uploads", "con", "AUX.1", "lpt3", "run."])
def test_no_run_takes_the_name_of_the_uploads_or_of_a_device(tmp_path, name):
    with pytest.raises(BarchanError, match="cannot be a run's name"):
        Workspace(tmp_path).run(name)
    assert Workspace(tmp_path).run("console-1").name == "console-1"


def test_every_preset_stands_under_one_landform():
    """In the documentation, where the group of dunes is parted by their forms."""
    listed = [name for names in gallery.landforms().values() for name in names]
    assert sorted(listed) == sorted(name for names in gallery.groups().values() for name in names)
    assert "Dunes" not in gallery.landforms()


@pytest.mark.parametrize("name", preset_names())
def test_every_preset_has_a_picture_for_the_gallery(name):
    picture = gallery.thumbnail(name)
    assert picture is not None, "python -m barchan.studio.pictures draws it"
    with Image.open(io.BytesIO(picture)) as drawn_picture:
        assert drawn_picture.size == (WIDTH, HEIGHT)
