"""Errors that a user can mend name everything at fault."""

import pickle

import pytest

from barchan.errors import Problem, ScenarioError


@pytest.mark.parametrize(
    ("problem", "text"),
    [
        (Problem("run.steps", "is -1", "a.json:3"), "run.steps: is -1 (a.json:3)"),
        (Problem("run.steps", "is -1"), "run.steps: is -1"),
        (Problem("", "not valid JSON", "a.json"), "not valid JSON (a.json)"),
    ],
)
def test_a_problem_is_printed_with_its_key_and_its_place_where_there_are_any(problem, text):
    assert str(problem) == text


@pytest.mark.parametrize(("count", "title"), [(1, "a.json: 1 problem"), (3, "a.json: 3 problems")])
def test_an_error_states_how_many_problems_there_are_and_then_each(count, title):
    error = ScenarioError([Problem(f"k{n}", "is wrong") for n in range(count)], "a.json")
    assert str(error).splitlines() == [title, *(f"  k{n}: is wrong" for n in range(count))]


def test_an_error_says_the_same_after_it_crossed_processes():
    error = ScenarioError([Problem("run.steps", "is -1", "a.json:3")], "a.json")
    copied = pickle.loads(pickle.dumps(error))
    assert str(copied) == str(error) == "a.json: 1 problem\n  run.steps: is -1 (a.json:3)"
    assert copied.problems == error.problems
