"""The report on two runs that exist already: one file with everything in it, measures as of any run."""

import base64
import json
import re

import pytest

from barchan.analysis.time_series import last_measures
from barchan.archive import open_run, run
from barchan.comparison.of_runs import compare_runs, members_home
from barchan.comparison.words import number
from barchan.simulation import Simulation
from tests.tiny import tiny

pytestmark = pytest.mark.extended


class BrokenOffError(Exception):
    pass


def save_both(folder, **second):
    """Two runs of ten steps, saved where the report looks for them."""
    scenarios = [tiny(run__steps=10), tiny(run__steps=10, **second)]
    paths = [members_home(folder) / name for name in "ab"]
    for path, scenario in zip(paths, scenarios, strict=True):
        run(Simulation(scenario), path)
    return paths, scenarios


@pytest.fixture(scope="module")
def reported(tmp_path_factory):
    """The report of two hop lengths, what it is about, and how far it said to be."""
    folder = tmp_path_factory.mktemp("report")
    paths, scenarios = save_both(folder, model__hop_length=3, look_for="Horns.")
    counted = []
    target = compare_runs(paths, folder / "comparison.html", lambda *far: counted.append(far), "the <studio>")
    return target.read_text("utf-8"), scenarios, paths, counted


def test_runs_of_one_model_are_called_by_what_differs(reported):
    page, scenarios, _, _ = reported
    default = scenarios[0].model.hop_length
    assert "Horns" not in page
    assert f"<h1>Tiny: hop length {default:g} and hop length 3</h1>" in page
    assert "by:</p><pre><code>the &lt;studio&gt;</code></pre>" in page


def test_the_page_needs_no_other_file(reported):
    page, scenarios, _, _ = reported
    assert all(source.startswith("data:image/png") for source in re.findall(r'src="([^"]{0,20})', page))
    assert all(link.startswith(("#", "data:")) for link in re.findall(r'href="([^"]{0,20})', page))
    contents = re.findall(r"data:application/json;base64,([^\"]+)", page)
    assert [json.loads(base64.b64decode(one))["model"]["hop_length"] for one in contents] == [
        scenarios[0].model.hop_length,
        3,
    ]


def test_its_measures_are_those_of_the_last_frames(reported):
    page, scenarios, paths, _ = reported
    for path, scenario in zip(paths, scenarios, strict=True):
        with open_run(path) as dataset:
            assert f"<td>{number(last_measures(dataset, scenario)['highest_stack'])}</td>" in page


def test_one_seed_has_plain_differences_and_nothing_of_tests(reported):
    """Of the flux: the value of each last frame, their difference, and that in per cent of the first."""
    page, scenarios, paths, _ = reported
    found = []
    for path, scenario in zip(paths, scenarios, strict=True):
        with open_run(path) as dataset:
            found.append(last_measures(dataset, scenario)["flux"])
    base, own = found
    assert own != base
    cells = [number(one) for one in (base, own, own - base, 100 * (own - base) / base)]
    assert "".join(f"<td>{cell}</td>" for cell in cells) in page
    assert "chance is not told" in page
    words = re.sub(r"base64,[^\"]+", "", page)
    assert not any(word in words for word in ("Holm", "t-test", "±"))


def test_it_says_how_far_it_is(reported):
    """Frames at steps 0, 5 and 10 of both runs, what shows both, and the pictures of each."""
    *_, counted = reported
    assert counted == [(done, 9) for done in range(1, 10)]


def test_it_is_broken_off_where_it_counts(tmp_path):
    paths, _ = save_both(tmp_path)

    def count(done, _):
        if done == 2:
            raise BrokenOffError

    with pytest.raises(BrokenOffError):
        compare_runs(paths, tmp_path / "comparison.html", count)
    assert not (tmp_path / "comparison.html").exists()
