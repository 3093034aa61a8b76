import pytest

from barchan.errors import BarchanError, ScenarioError
from barchan.studio.server.security import is_plain_name
from barchan.studio.server.workspace import Workspace


@pytest.mark.parametrize("name", ["run-1", "a", "My.run_2"])
def test_plain_names_are_taken(tmp_path, name):
    assert Workspace(tmp_path).run(name) == tmp_path / name


@pytest.mark.parametrize(
    "name", ["", ".", "..", "../x", "a/b", "/etc", "a\\b", ".hidden", "a" * 101, "a\n", "a..b"]
)
def test_names_that_could_lead_elsewhere_are_not(tmp_path, name):
    assert not is_plain_name(name)
    with pytest.raises(BarchanError, match="cannot be a run's name"):
        Workspace(tmp_path).run(name)


def test_a_link_out_of_the_folder_is_not_followed(tmp_path):
    workspace = Workspace(tmp_path / "mine")
    kept = workspace.keep("hill.npy", b"x")
    (kept.parent / "out.npy").symlink_to("/etc/passwd")
    workspace.check({"ground": {"path": str(kept)}})
    with pytest.raises(ScenarioError, match=r"sand\[0\].path"):
        workspace.check({"sand": [{"path": str(kept.parent / "out.npy")}]})


def test_a_path_that_is_not_given_opens_nothing(tmp_path):
    Workspace(tmp_path).check({"wind": {"kind": "record", "path": None}})


def test_files_of_the_same_name_do_not_replace_each_other(tmp_path):
    workspace = Workspace(tmp_path)
    first, second = workspace.keep("hill.npy", b"1"), workspace.keep("hill.npy", b"2")
    assert workspace.keep("hill.npy", b"1") == first
    assert first.read_bytes() == b"1"
    assert second.read_bytes() == b"2"


@pytest.mark.parametrize(
    ("given", "kept"),
    [
        ("my dune field.png", "my-dune-field.png"),
        ("naïve.NPY", "naive.npy"),
        ("DEM (1).tif", "DEM-1.tif"),
        ("../../etc/.hidden.asc", "hidden.asc"),
        ("C:\\data\\hill.v2.png", "hill-v2.png"),
        ("砂丘.jpg", "file.jpg"),
    ],
)
def test_an_uploaded_file_gets_a_plain_name(tmp_path, given, kept):
    path = Workspace(tmp_path).keep(given, b"x")
    assert path == tmp_path / "studio-uploads" / kept
    assert is_plain_name(path.name)


def test_a_file_that_is_neither_heights_nor_winds_is_not_kept(tmp_path):
    with pytest.raises(BarchanError, match=r"run\.exe.*allowed: \.npy"):
        Workspace(tmp_path).keep("run.exe", b"x")


def test_a_refusal_names_an_upload_without_the_folders_of_the_server(tmp_path):
    workspace = Workspace(tmp_path)
    said = f"'{workspace.keep('hill.png', b'x')}': cannot be read as an image"
    text, (problem,) = workspace.plainly(said, [{"key": "ground.path", "message": said, "place": ""}])
    assert text == problem["message"] == "'hill.png': cannot be read as an image"
    assert problem["key"] == "ground.path"
