"""Folders of runs that were saved together."""

import json

import pytest

from barchan.errors import BarchanError
from barchan.studio.server.together import NAME, Member, is_together, name_together, read_together

MEMBERS = [Member("werner", "Two winds", "werner1995", 40, 100), Member("momiji", "", "momiji2000", 40, 100)]


def filled(folder):
    for member in MEMBERS:
        (folder / member.folder).mkdir(parents=True)
        (folder / member.folder / "checkpoint.npz").write_bytes(b"sand")
    return folder


def test_runs_saved_together_are_named_in_their_order_with_their_steps(tmp_path):
    name_together(filled(tmp_path / "pair"), MEMBERS)
    found = read_together(tmp_path / "pair")
    assert found.members == tuple(MEMBERS)
    assert found.folders == [tmp_path / "pair" / "werner", tmp_path / "pair" / "momiji"]
    assert is_together(tmp_path / "pair")
    assert not is_together(tmp_path)


def test_a_sealed_file_that_lost_a_byte_is_named(tmp_path):
    name_together(filled(tmp_path), MEMBERS, sealed=True)
    read_together(tmp_path)
    (tmp_path / "momiji" / "checkpoint.npz").write_bytes(b"san")
    with pytest.raises(BarchanError, match=r"momiji/checkpoint\.npz: damaged"):
        read_together(tmp_path)


def test_runs_that_are_not_sealed_may_have_gone_on_since(tmp_path):
    name_together(filled(tmp_path), MEMBERS)
    (tmp_path / "werner" / "checkpoint.npz").write_bytes(b"more sand")
    assert read_together(tmp_path).digests == {}


@pytest.mark.parametrize(
    "change",
    [
        lambda _: "half a fi",
        lambda _: "[1]",
        lambda data: json.dumps({**data, "runs": []}),
        lambda data: json.dumps({**data, "barchan_together": 99}),
        lambda data: json.dumps({**data, "runs": [{**data["runs"][0], "folder": "../outside"}]}),
    ],
)
def test_a_damaged_list_of_runs_is_named_and_leads_nowhere(tmp_path, change):
    name_together(filled(tmp_path), MEMBERS)
    data = json.loads((tmp_path / NAME).read_text())
    (tmp_path / NAME).write_text(change(data))
    with pytest.raises(BarchanError, match=NAME):
        read_together(tmp_path)
