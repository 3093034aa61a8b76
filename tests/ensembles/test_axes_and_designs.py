"""Axes and designs: which values an ensemble has."""

import numpy as np
import pytest

from barchan.ensembles.axes import Axis, parse_axes
from barchan.ensembles.design import points_of
from barchan.errors import BarchanError, ScenarioError


@pytest.mark.parametrize(
    ("text", "key", "values"),
    [
        ("model.hop_length=1,3,5", "model.hop_length", (1, 3, 5)),
        ("model=werner,momiji", "model.name", ("werner", "momiji")),
        ("steps=10,20", "run.steps", (10, 20)),
        ("sand.mean=lin(0,1,6)", "sand.mean", (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)),
        ("sand.mean=lin(2,6,3)", "sand.mean", (2, 4, 6)),
        ("model.hop_length=log(0.1,10,3)", "model.hop_length", (0.1, 1.0, 10.0)),
        (
            'wind={"kind": "steady", "direction": 90},{"kind": "steady"}',
            "wind",
            ({"kind": "steady", "direction": 90}, {"kind": "steady"}),
        ),
    ],
)
def test_an_axis_is_a_key_and_its_values(text, key, values):
    (axis,) = parse_axes([text])
    assert (axis.key, axis.values) == (key, values)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("model.hop_length", "is no axis"),
        ("hop_length=3", "is no key of a scenario; did you mean model.hop_length"),
        ("model.hop_length=1,,3", "empty value"),
        ("model.hop_length=1,1", "same value twice"),
        ("run.seed=1,2", "--seeds"),
        ("threads=1,2", "number of threads"),
        ("sand.mean=lin(1,1,5)", "unlike each other"),
        ("sand.mean=log(0,1,5)", "above 0"),
        ("sand.mean=lin(1,2,1)", "from 2 to"),
        ("sand.mean=lin(1,x,3)", "allowed: lin(FROM,TO,NUMBER)"),
    ],
)
def test_an_axis_that_is_none_is_named_with_what_is_allowed(text, said):
    with pytest.raises(ScenarioError, match=r"--vary") as error:
        parse_axes([text])
    assert said in str(error.value)


def test_every_wrong_axis_is_named_at_once():
    with pytest.raises(ScenarioError) as error:
        parse_axes(["foo=1", "sand.mean=1,1", "model.hop_length=2"])
    assert [problem.key for problem in error.value.problems] == ["foo", "sand.mean"]


A, B = Axis("a", (1, 2, 3)), Axis("b", (10, 20, 30))


def test_a_grid_has_every_combination_and_zip_the_pairs():
    assert points_of([A, B], "grid") == [(a, b) for a in (1, 2, 3) for b in (10, 20, 30)]
    assert points_of([A, B], "zip") == [(1, 10), (2, 20), (3, 30)]
    assert points_of([], "grid") == [()]


@pytest.mark.parametrize("design", ["latin", "sobol"])
def test_eight_points_of_a_space_filling_design_lie_one_in_each_eighth_of_every_axis(design):
    points = points_of([Axis("a", (0.0, 8.0), "lin"), Axis("b", (1.0, 256.0), "log")], design, 8, seed=3)
    first, second = np.array(points).T
    assert sorted(first.astype(int)) == list(range(8))
    assert sorted(np.log2(second).astype(int)) == list(range(8))
    assert points == points_of(
        [Axis("a", (0.0, 8.0), "lin"), Axis("b", (1.0, 256.0), "log")], design, 8, seed=3
    )


def test_designs_say_what_they_need():
    for axes, design, count in (
        ([A, Axis("b", (1, 2))], "zip", None),
        ([A], "latin", 4),
        ([Axis("a", (0, 1), "lin")], "sobol", None),
        ([A], "grid", 4),
    ):
        with pytest.raises(BarchanError):
            points_of(axes, design, count)
