"""The figures of studies show the numbers of their stored results."""

import re
import xml.etree.ElementTree as ET
from dataclasses import replace

import pytest
from validation import figures
from validation.pages import FIGURES, RESULTS, Result, studies
from validation.quantities import Point, numbers_of

STUDIES = {study.name: study for study in studies()}
LARGEST = 25_000
SVG = "{http://www.w3.org/2000/svg}"


@pytest.mark.parametrize("name", sorted(path.stem for path in RESULTS.glob("*.md")))
def test_every_result_has_a_figure_that_follows_it(name):
    study = STUDIES[name]
    drawn = figures.drawn(study)
    if drawn is None:
        assert "_static/" in study.text, f"{name}: its table holds only words; draw another figure"
        return
    path = FIGURES / f"{name}.svg"
    assert path.is_file(), f"{name}: run python -m validation --pages"
    stored = path.read_text("utf-8")
    assert f'data-of="{figures.digest(study)}"' in stored, f"{name}: run python -m validation --pages"
    assert stored == drawn
    assert path.stat().st_size <= LARGEST
    assert f"](_static/validation/{name}.svg)" in study.illustrated


def test_no_figure_is_left_of_a_study_that_is_gone():
    assert {path.stem for path in FIGURES.iterdir()} <= set(STUDIES)


def test_another_number_makes_another_figure():
    study = STUDIES["highest_stacks"]
    other = replace(study, text=study.text.replace("24.2 ± 1.1", "25.2 ± 1.1"))
    assert figures.digest(other) != figures.digest(study)
    assert figures.drawn(other) != figures.drawn(study)


def test_points_lie_where_their_numbers_say():
    """Highest stacks: 24.2 ± 1.1 beside 26, and 27.6 ± 0.89 beside 28 slabs, on one axis."""
    root = ET.fromstring(figures.drawn(STUDIES["highest_stacks"]))
    points = [float(point.get("cx")) for point in root.findall(f".//{SVG}g/{SVG}circle")]
    diamonds = [
        float(re.match(r"M([\d.]+)", path.get("d"))[1])
        for path in root.findall(f".//{SVG}g/{SVG}path[@class='p']")
    ]
    assert len(points) == len(diamonds) == 2
    per_slab = (points[1] - points[0]) / (27.6 - 24.2)
    assert diamonds[0] - points[0] == pytest.approx((26 - 24.2) * per_slab, abs=0.3)
    assert diamonds[1] - points[1] == pytest.approx((28 - 27.6) * per_slab, abs=0.3)


def quantities(found, published="-", verdict=""):
    numbers = numbers_of(Result("row", published, found, verdict))
    return [(one.name, one.unit, [(p.mean, p.deviation) for p in one.points]) for one in numbers.quantities]


def test_numbers_are_read_with_their_names_and_units():
    assert quantities("24.2 ± 1.1 slabs") == [("", "slabs", [(24.2, 1.1)])]
    assert quantities("highest 38 ± 1.6 slabs, spacing 58.4 ± 1.6 cells") == [
        ("highest", "slabs", [(38, 1.6)]),
        ("spacing", "cells", [(58.4, 1.6)]),
    ]
    assert quantities("28 ± 1 summits, stars 0.035 ± 0.02") == [
        ("summits", "", [(28, 1)]),
        ("stars", "", [(0.035, 0.02)]),
    ]


def test_numbers_that_are_compared_stand_on_one_axis():
    assert quantities("26 ± 1.2 against 19.2 ± 0.45 slabs") == [("", "slabs", [(26, 1.2), (19.2, 0.45)])]
    assert quantities("18.2 ± 0.89 with, 18.5 ± 1.6 without") == [("", "", [(18.2, 0.89), (18.5, 1.6)])]
    assert quantities("2.1 ± 0.17, 2.4 ± 0.22 mm") == [("", "mm", [(2.1, 0.17), (2.4, 0.22)])]


def test_single_runs_limits_and_shares_are_numbers_too():
    assert quantities("+1°, +2°, -5°; coherence 0.80") == [("", "°", [(1, None), (2, None), (-5, None)])]
    assert quantities("between 3 and 6 m (never moved: 0%)") == [("", "m", [(4.5, 1.5)])]
    assert quantities("52 of 60 (87%), median -1.2°") == [("share of the runs", "%", [(87, None)])]
    assert numbers_of(Result("row", "-", "7: mixed; 9: flat", "")) is None


def test_a_published_number_stands_beside_what_it_was_judged_by():
    judged = numbers_of(Result("row", "about 0.1", "0.068 ± 0.023", "differs"))
    assert (judged.published, judged.quantities[0].points) == ((0.1, 0.1), (Point(0.068, 0.023),))
    assert numbers_of(Result("row", "3 to 20 m", "6.6 ± 0.9 m", "5 of 5 seeds within")).published == (3, 20)
    assert numbers_of(Result("row", "grows", "31 ± 0.8 cells", "")).published is None
    assert numbers_of(Result("row", "2 to 42", "13 ± 1 slabs", "formed in 0 of 3")).published is None
