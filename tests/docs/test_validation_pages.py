"""The pages on validation are made from the results of the studies."""

import importlib
import pkgutil

import pytest
import validation
from validation import pages
from validation.__main__ import STUDIES
from validation.pages import DOCS, RESULTS, THEMES, Result


def test_every_study_has_one_theme_and_a_result():
    modules = {module.name for module in pkgutil.iter_modules(validation.__path__)}
    listed = [name for theme in THEMES for name in theme.studies]
    tools = {"__main__", "figures", "pages", "quantities", "study", "isotropy_bench", "snow_scenes"}
    assert sorted(listed) == sorted(modules - tools)
    assert all((RESULTS / f"{name}.md").exists() for name in listed)


def test_pages_are_those_of_the_results():
    for name, text in pages.pages().items():
        assert (DOCS / name).read_text("utf-8") == text, f"{name}: run python -m validation --pages"


@pytest.mark.parametrize("name", STUDIES)
def test_a_result_has_the_words_of_its_study(name):
    study = importlib.import_module(f"validation.{name}")
    result = " ".join((RESULTS / f"{name}.md").read_text("utf-8").split())
    for text in (study.TITLE, study.__doc__, study.READING):
        assert " ".join(text.split()) in result


def test_verdicts():
    def judged(published, verdict):
        return Result("", published, "", verdict).judged

    assert judged("-", "3 of 3 seeds") == ""
    assert judged("26 slabs (one run)", "agrees") == "agrees"
    assert judged("26 slabs (one run)", "differs by -10%") == "differs"
    assert judged("no difference", "1.5 standard errors apart") == "agrees"
    assert judged("no difference", "2.5 standard errors apart") == "differs"
    assert judged("more", "3 of 3 seeds downwind") == "agrees"
    assert judged("more", "2 of 3 seeds") == "open"
    assert judged("more", "1 of 3 seeds") == "differs"
    assert judged("grows", "") == "open"
