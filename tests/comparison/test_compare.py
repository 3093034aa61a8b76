"""The report of a comparison, and the data beside it."""

import re
from concurrent.futures import Executor, Future
from html.parser import HTMLParser

import pandas as pd
import pytest

from barchan.comparison import comparing, page
from barchan.comparison.comparing import axis_of_models, compare
from barchan.comparison.variants import Variant, unlike_defaults
from barchan.ensembles.axes import parse_axes
from barchan.ensembles.pictures import label_of
from barchan.ensembles.plan import make_plan
from barchan.ensembles.workers import Workers, given
from barchan.errors import BarchanError
from barchan.models import models
from barchan.scenario import load_scenario
from tests.tiny import DATA


class Here(Executor):
    """Works at once, in this process."""

    def submit(self, function, *arguments):
        future = Future()
        future.set_result(function(*arguments))
        return future


@pytest.fixture(scope="module")
def compared(tmp_path_factory):
    """The folder of a comparison of two models and two seeds."""
    folder = tmp_path_factory.mktemp("compared")
    plan = make_plan(DATA, [axis_of_models(["werner", "momiji"])], seeds=2)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(comparing, "processes", lambda: Workers(Here, 1, "here"))
        done = compare(plan, folder, workers=given(Here(), 1), steps=[10], command="barchan compare <x>")
    assert done.report == folder / "report.html"
    return folder


class Parts(HTMLParser):
    """What a page loads, where its links lead, what they can lead to, and which tags stay open."""

    def __init__(self):
        super().__init__()
        self.sources, self.links, self.names, self.open = [], [], [], []

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.sources += [found["src"]] if "src" in found else []
        self.links += [found["href"]] if "href" in found else []
        self.names += [found["id"]] if "id" in found else []
        if tag not in ("img", "meta", "link", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def test_the_report_needs_no_other_file_and_its_links_lead_somewhere(compared):
    parts = Parts()
    parts.feed((compared / "report.html").read_text("utf-8"))
    assert not parts.open
    assert len(parts.sources) == 3 + 1 + 2 * 4
    assert all(source.startswith("data:image/png;base64,") for source in parts.sources)
    for link in parts.links:
        assert link[1:] in parts.names if link.startswith("#") else (compared / link).is_file()


def test_the_report_names_what_ran_and_escapes_it(compared):
    text = (compared / "report.html").read_text("utf-8")
    assert "barchan compare &lt;x&gt;" in text
    assert "Tiny: werner and momiji" in text
    assert len(re.findall(r"<td>all steps done</td>", text)) == 4
    assert not re.search(r"\bnan\b", re.sub(r'src="[^"]*"', "", text))


def test_each_variant_has_its_complete_scenario_as_a_file(compared):
    files = sorted((compared / "scenarios").iterdir())
    assert [load_scenario(file).model.name for file in files] == ["werner", "momiji"]


def test_models_start_from_the_same_bed_for_the_same_seed(compared):
    series = pd.read_csv(compared / "series.csv")
    first = series[series["step"] == 0].groupby("seed")
    assert (first["highest"].nunique() == 1).all()
    assert (first["volume"].nunique() == 1).all()


def test_slopes_and_differences_are_written_as_tables(compared):
    slopes = pd.read_csv(compared / "slopes.csv")
    assert list(slopes["variant"]) == ["werner"] * 2 + ["momiji"] * 2
    assert slopes.drop(columns=["variant", "seed"]).sum(axis=1).between(0.9, 1.0 + 1e-9).all()
    differences = pd.read_csv(compared / "differences.csv")
    assert set(differences["variant"]) == {"momiji"}
    assert "highest_stack" not in set(differences["measure"])


def test_models_given_as_groups_have_their_own_defaults_and_are_named_in_words():
    data = {**DATA, "model": {"name": "werner", "lee_erosion": True}}
    groups = parse_axes(['model={"name": "werner"},{"name": "momiji", "hop_length": 3}'])
    plan = make_plan(data, groups)
    assert [label_of(plan, member) for member in plan.members] == ["werner", "momiji hop_length 3"]
    own = models()["momiji"].Parameters()
    assert plan.members[1].scenario["model"]["lee_erosion"] == own.lee_erosion


def test_the_report_names_values_that_are_not_the_defaults_of_a_model():
    plan = make_plan({**DATA, "model": {"name": "werner", "hop_length": 3}})
    variant = Variant("werner", 0, None, list(plan.members), {7: None})
    assert unlike_defaults(variant) == {"hop_length": (3, 5)}


def test_models_that_do_not_exist_are_named_before_anything_runs():
    with pytest.raises(BarchanError, match="momiji"):
        axis_of_models(["werner", "momji"])
    with pytest.raises(BarchanError, match="twice"):
        axis_of_models(["werner", "werner"])


def test_values_that_a_model_does_not_have_are_named_before_anything_runs():
    axes = [axis_of_models(["werner", "momiji"]), *parse_axes(["model.linear_coefficient=0.2,-9"])]
    with pytest.raises(BarchanError) as error:
        make_plan(DATA, axes)
    assert "model.linear_coefficient" in str(error.value)


def test_a_page_escapes_what_it_is_given():
    assert page.text("<b>") == "&lt;b&gt;"
    assert page.text(page.Markup("<b>")) == "<b>"
