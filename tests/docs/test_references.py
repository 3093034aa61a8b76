"""Every source is a publication of the bibliography, our own choice, or one of a few plain reasons."""

import json
import re
import sys
from importlib import resources
from pathlib import Path

import pytest

import barchan
from barchan.aeolian.saltation import Saltation
from barchan.models import models
from barchan.parameters import declarations
from barchan.scenario import load_scenario, preset_names
from barchan.scenario.listing import all_keys
from barchan.simulation import PlantStroke, RockStroke, SetParameter, SetWind, Stroke

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "_ext"))

from references import cited, linked, linked_page, references  # noqa: E402

PLAIN_REASONS = (
    "a public program by R. Naruse",
    "air at 15 to 20 °C",
    "meteorological stations",
    "quartz",
    "random packing of sand",
    "standard air at sea level",
    "the form that AeoLiS uses",
    "the value used with reanalyses in pydune",
)
"""Sources that are no publications: everyday constants, and programs by their name."""

SEED = re.compile(r"\bseeds?\s+00[034]\b", re.IGNORECASE)
"""The names that the first documents had while Barchan was young."""


def known(source: str) -> bool:
    """Whether a source can be found by a reader, or says that it is ours."""
    return bool(cited(source)) or "ours" in re.split(r"\W+", source) or source.startswith(PLAIN_REASONS)


def sources():
    """Sources of all parameters that a scenario, an event or a command may hold."""
    own = [
        d
        for kind in (SetParameter, SetWind, Stroke, RockStroke, PlantStroke, Saltation)
        for d in declarations(kind)
    ]
    return sorted({d.source for d in (*all_keys(), *own) if d.source})


@pytest.mark.parametrize("source", sources())
def test_source_of_a_parameter_is_known(source):
    assert known(source)


@pytest.mark.parametrize("name", preset_names())
def test_citation_of_a_preset_is_known(name):
    assert known(load_scenario(name).citation)


@pytest.mark.parametrize("name", models())
def test_citation_of_a_model_is_known(name):
    assert cited(models()[name].citation)


def test_labels_are_unique_and_complete():
    entries = references()
    assert len(entries) == (ROOT / "docs" / "references.bib").read_text("utf-8").count("\n@")
    assert len({entry.key for entry in entries.values()}) == len(entries)
    assert all(entry.fields["title"] and entry.place() for entry in entries.values())


def test_labels_count_the_authors():
    assert {"Werner 1995", "Shao & Lu 2000", "Momiji et al. 2000", "Prague thesis"} <= set(references())


def test_every_publication_is_cited_somewhere():
    folders = ("src/barchan", "docs", "validation", "examples")
    paths = [
        p for folder in folders for p in (ROOT / folder).rglob("*") if p.suffix in (".py", ".md", ".json")
    ]
    text = "\n".join(
        p.read_text("utf-8") for p in paths if "_generated" not in p.parts and "_build" not in p.parts
    )
    dated = (part for part in re.split(r"\n\s*\n", text) if re.search(r"\b(?:18|19|20)\d\d", part))
    assert set(references()) - set(cited(re.sub(r"[`$\[#]", "", "\n\n".join(dated)))) == set()


def test_ways_to_cite_become_links():
    assert linked("(Werner 1995)") == "([Werner 1995](#werner-1995))"
    assert linked("Werner (1995) says") == "[Werner (1995)](#werner-1995) says"
    assert linked("Kok &\nRenno 2009, §2") == "[Kok &\nRenno 2009](#kok-renno-2009), §2"
    assert linked("Courrech du Pont et al. (2014, Geology)").endswith(
        "(2014](#courrech-du-pont-2014), Geology)"
    )
    assert cited("After Anderson, R. S. (1987), 34; Anderson, R. S. and Haff, P. K. (1991)") == [
        "Anderson 1987",
        "Anderson & Haff 1991",
    ]


def test_code_formulas_and_links_are_left_alone():
    page = "# Werner 1995\n`Werner 1995` [Werner 1995](#x)\n```python\nx = 'Werner 1995'\n```\nWerner 1995\n"
    assert linked_page(page) == page[: -len("Werner 1995\n")] + "[Werner 1995](#werner-1995)\n"


def texts():
    """Whatever a user can read, by a name for it."""
    for key in all_keys():
        yield key.key, key.meaning
    for file in resources.files("barchan.presets").iterdir():
        if file.name.endswith(".json"):
            yield file.name, json.dumps(json.loads(file.read_text("utf-8")), ensure_ascii=False)
    for path in [*(ROOT / "docs").glob("*.md"), *ROOT.glob("*.md"), *(ROOT / "validation").rglob("*.md")]:
        yield path.name, path.read_text("utf-8")
    package = Path(barchan.__file__).parent
    for path in [
        *package.rglob("*.py"),
        *(ROOT / "examples").glob("*.py"),
        *(ROOT / "validation").glob("*.py"),
    ]:
        yield str(path.relative_to(ROOT)), path.read_text("utf-8")


def test_no_text_speaks_of_numbered_seeds():
    found = {name for name, text in texts() if SEED.search(text)}
    assert sorted(found) == []
