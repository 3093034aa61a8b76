import pytest

from barchan.errors import BarchanError, ScenarioError
from barchan.studio.server.security import is_plain_name
from barchan.studio.server.workspace import Store


@pytest.mark.parametrize("name", ["run-1", "a", "My.run_2"])
def test_plain_names_are_taken(tmp_path, name):
    assert Store(tmp_path).run(name) == tmp_path / name


@pytest.mark.parametrize(
    "name", ["", ".", "..", "../x", "a/b", "/etc", "a\\b", ".hidden", "a" * 101, "a\n", "a..b"]
)
def test_names_that_could_lead_elsewhere_are_not(tmp_path, name):
    assert not is_plain_name(name)
    with pytest.raises(BarchanError, match="cannot be a run's name"):
        Store(tmp_path).run(name)


def test_a_link_out_of_the_folder_is_not_followed(tmp_path):
    store = Store(tmp_path / "mine")
    kept = store.keep("hill.npy", b"x")
    (kept.parent / "out.npy").symlink_to("/etc/passwd")
    store.check({"ground": {"path": str(kept)}})
    with pytest.raises(ScenarioError, match=r"sand\[0\].path"):
        store.check({"sand": [{"path": str(kept.parent / "out.npy")}]})


def test_a_path_that_is_not_given_opens_nothing(tmp_path):
    Store(tmp_path).check({"wind": {"kind": "record", "path": None}})


def test_files_of_the_same_name_do_not_replace_each_other(tmp_path):
    store = Store(tmp_path)
    first, second = store.keep("hill.npy", b"1"), store.keep("hill.npy", b"2")
    assert store.keep("hill.npy", b"1") == first
    assert first.read_bytes() == b"1"
    assert second.read_bytes() == b"2"
