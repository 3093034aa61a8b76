"""Reports on runs over files: named by what differs, without folders, with a warning of unequal times."""

import base64
import json
import re

import pytest
from matplotlib.text import Text

from barchan import simulate
from barchan.archive import run
from barchan.archive.file_names import file_names
from barchan.comparison.conditions import clock_time
from barchan.comparison.of_runs import compare_runs, members_home
from barchan.comparison.variants import MOST_DRAWN, Variant
from barchan.comparison.words import without_folders
from barchan.ensembles.axes import Axis
from barchan.ensembles.pictures import label_of
from barchan.ensembles.plan import make_plan
from barchan.figures.ensembles import Panel, small_multiples
from barchan.simulation import Simulation
from tests.tiny import COLUMNS, DATA, ROWS, tiny

pytestmark = pytest.mark.extended

HILL = f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner 0\nyllcorner 0\ncellsize 1\n"


def terrain(path, height):
    """A level terrain in a file, as large as the tiny field."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(HILL + f"{' '.join([str(height)] * COLUMNS)}\n" * ROWS)
    return str(path)


def wind(path):
    path.write_text("time,speed,direction\n2023-01-01 00:00,8,270\n2023-01-01 01:00,8,260\n")
    return str(path)


def report(folder, *changes):
    """The words of the report on runs with these changes, and the scenarios that it holds."""
    paths = []
    for name, changed in zip("ab", changes, strict=True):
        paths.append(members_home(folder) / name)
        run(Simulation(tiny(**{"run__steps": 10, **changed})), paths[-1])
    page = compare_runs(paths, folder / "comparison.html").read_text("utf-8")
    held = re.findall(r"data:application/json;base64,([^\"]+)", page)
    return re.sub(r"base64,[^\"]+", "", page), [base64.b64decode(one).decode() for one in held]


def test_copies_of_one_file_are_no_difference_and_no_folder_is_told(tmp_path):
    """Twice the hop length moves twice the sand in a step, so that it lasts twice as long by the clock."""
    common = {
        "ground": {"kind": "file", "path": terrain(tmp_path / "hill.asc", 2)},
        "wind": {"kind": "record", "path": wind(tmp_path / "wind.csv")},
        "clock": {"reference_speed": 8.0},
    }
    page, scenarios = report(
        tmp_path, {**common, "model__hop_length": 5}, {**common, "model__hop_length": 10}
    )
    assert "<h1>Tiny: hop length 5 and hop length 10</h1>" in page
    assert str(tmp_path) not in page
    assert not any(str(tmp_path) in scenario for scenario in scenarios)
    assert [json.loads(scenario)["ground"]["path"] for scenario in scenarios] == ["hill.asc"] * 2
    assert "with the same ground, wind and random numbers." in page
    seconds = tiny(**common, model__hop_length=5).step_seconds
    lasting = f"“hop length 5” lasts {clock_time(seconds)}, one of “hop length 10” {clock_time(2 * seconds)}."
    warning = f"Both runs are compared at equal steps, not at equal times: a step of {lasting}"
    assert page.index(warning) < page.index("<nav>")


@pytest.mark.filterwarnings("error:.*layout not applied")
def test_files_that_differ_are_named_by_their_names_and_long_names_are_drawn(tmp_path):
    """Two terrains of one name, 2 m and 3 m high, told apart by digests; two of long names need none."""
    long = "-".join(["terrain-of-a-place-with-a-long-name"] * 3)
    first, second = (terrain(tmp_path / f"{name}-{long}.asc", 2 + len(name)) for name in ("a", "bb"))
    page, _ = report(
        tmp_path,
        {"ground": {"kind": "file", "path": first}, "model__hop_length": 5},
        {"ground": {"kind": "file", "path": second}, "model__hop_length": 10},
    )
    title = re.search("<h1>(.*?)</h1>", page)[1]
    assert title.startswith("Tiny: ground a-terrain-of")
    assert "hop length 5 and ground bb-terrain-of" in title
    assert "with the same wind and random numbers." in page
    assert "not at equal times" not in page
    assert str(tmp_path) not in page


def test_files_of_one_name_and_unlike_contents_are_told_apart(tmp_path):
    """The SHA-256 digest of "abc" begins with ba7816bf, that of nothing with e3b0c442."""
    paths = [tmp_path / place / "x.txt" for place in "abc"]
    for path, content in zip(paths, ("abc", "", "abc"), strict=True):
        path.parent.mkdir()
        path.write_text(content)
    first, second, third = map(str, paths)
    assert file_names([first, third]) == {first: "x.txt", third: "x.txt"}
    assert file_names([first, second]) == {first: "x.txt (ba7816bf)", second: "x.txt (e3b0c442)"}


def test_members_of_varied_files_are_named_without_folders(tmp_path):
    low, high = terrain(tmp_path / "a" / "low.asc", 1), terrain(tmp_path / "b" / "high.asc", 4)
    data = {**DATA, "ground": {"kind": "file", "path": low}}
    plan = make_plan(data, [Axis("ground.path", (low, high)), Axis("model.hop_length", (5,))])
    labels = [label_of(plan, member) for member in plan.members]
    assert labels == ["ground low.asc, hop_length 5", "ground high.asc, hop_length 5"]


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("barchan compare '/home/My Files/a.json' --out=/tmp/o", "barchan compare 'a.json' --out=o"),
        ("compare /x/y.json z/q.json", "compare y.json z/q.json"),
        ("wind.path: /a/b/wind.csv: 5 m/s and 5 / 3 kg/m²", "wind.path: wind.csv: 5 m/s and 5 / 3 kg/m²"),
        ("https://example.org/a/b", "https://example.org/a/b"),
        (r"C:\Users\me\x.csv", "x.csv"),
    ],
)
def test_folders_are_left_out_of_words(words, told):
    assert without_folders(words) == told


@pytest.mark.parametrize(
    ("seconds", "told"),
    [(961_560.0, "11 d 03:06"), (90.0, "90 s"), (150.0, "2 min 30 s"), (7260.0, "02:01 h")],
)
def test_durations_are_told_as_the_studio_does(seconds, told):
    """11 days, 3 hours and 6 minutes are 950400 + 10800 + 360 s."""
    assert clock_time(seconds) == told


def test_a_long_label_is_cut_in_figures_and_in_names_of_files(tmp_path):
    variant = Variant("x" * 300, 1, tmp_path)
    assert variant.drawn.startswith("2: xxx")
    assert len(variant.drawn) <= MOST_DRAWN
    assert variant.name == f"2-{'x' * 60}"


@pytest.mark.parametrize(("rows", "columns"), [(8, 80), (16, 24), (80, 8)], ids=["wide", "usual", "narrow"])
@pytest.mark.filterwarnings("error:.*layout not applied")
def test_long_titles_of_small_maps_do_not_meet(rows, columns):
    """Two titles of 80 letters side by side: the first ends before the second begins."""
    scenario = tiny(lattice__rows=rows, lattice__columns=columns, run__steps=5)
    frame = simulate(scenario).isel(step=-1)
    panels = [Panel(f"{number} {'a long name ' * 6}"[:80], frame, scenario) for number in (1, 2)]
    figure = small_multiples(panels, 2, "")
    figure.draw_without_rendering()
    maps = figure.axes[:2]
    left, right = (axes.findobj(_is_title)[0].get_window_extent() for axes in maps)
    assert left.x1 < right.x0


def _is_title(part):
    return isinstance(part, Text) and "long name" in part.get_text()
