"""A parameter is declared once, with default, unit, bounds, meaning and source, and holds its user to it."""

from typing import Annotated, ClassVar, Literal

import pytest
from pydantic import Field, ValidationError

from barchan.models import models
from barchan.parameters import (
    GIVEN,
    NOT_GIVEN,
    Declaration,
    Parameters,
    allowed,
    declarations,
    idle_keys,
    parameter,
    redeclared,
    variants,
)
from barchan.wind import Clock, Regime


class Inner(Parameters):
    """A group within a group."""

    window: int = parameter(5, unit="steps", ge=1, meaning="A window.")


class Example(Parameters):
    """One parameter of every kind."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["example"] = parameter("example", unit="-", meaning="The kind.")
    needed: float = parameter(unit="m", gt=0, le=2.5, meaning="A length.", source="a paper")
    count: int = parameter(3, unit="slabs", ge=0, live=True, group="sand", scale="log", meaning="A number.")
    maybe: int | None = parameter(None, unit="-", ge=1, meaning="A number or nothing.")
    choice: Literal["a", "b"] | Annotated[int, Field(ge=1, le=9)] = parameter(
        "a", unit="-", meaning="Either."
    )
    on: bool = parameter(True, unit="-", meaning="A switch.")
    name: str = parameter("", unit="-", meaning="A text.")
    several: list[float] = parameter(list, unit="-", meaning="Numbers.")
    inner: Inner = Field(default_factory=Inner, description="A group.")


ALLOWED = {
    "kind": "'example'",
    "needed": "number > 0 and ≤ 2.5",
    "count": "whole number ≥ 0",
    "maybe": "whole number ≥ 1 | null",
    "choice": "'a' | 'b' | whole number ≥ 1 and ≤ 9",
    "on": "true or false",
    "name": "text",
    "several": "list of number",
}


def test_what_a_parameter_may_be_is_said_in_words():
    assert {name: allowed(Example.model_fields[name]) for name in ALLOWED} == ALLOWED


def test_a_declaration_holds_all_that_was_declared():
    assert {d.key: d for d in declarations(Example)}["count"] == Declaration(
        key="count",
        type="whole number",
        default=3,
        unit="slabs",
        bounds="whole number ≥ 0",
        meaning="A number.",
        source="",
        live=True,
        group="sand",
        scale="log",
        required=False,
    )


def test_declarations_come_in_order_with_dotted_keys_and_without_notes():
    keys = [d.key for d in declarations(Example, "group.")]
    assert keys == [*(f"group.{name}" for name in ALLOWED), "group.inner.window"]


def test_a_required_parameter_has_no_default():
    defaults = {d.key: d.default for d in declarations(Example)}
    assert [d.key for d in declarations(Example) if d.required] == ["needed"]
    assert defaults["needed"] is None
    assert defaults["several"] == []


@pytest.mark.parametrize(
    "wrong",
    [
        {},
        {"needed": 0.0},
        {"needed": 2.6},
        {"needed": float("nan")},
        {"needed": float("inf")},
        {"needed": "1"},
        {"needed": True},
        {"needed": 1.0, "count": 3.0},
        {"needed": 1.0, "count": True},
        {"needed": 1.0, "count": None},
        {"needed": 1.0, "on": 1},
        {"needed": 1.0, "name": 1},
        {"needed": 1.0, "choice": "c"},
        {"needed": 1.0, "choice": 10},
        {"needed": 1.0, "unknown": 1},
        {"needed": 1.0, "inner": {"unknown": 1}},
    ],
)
def test_nothing_but_the_declared_is_accepted(wrong):
    with pytest.raises(ValidationError):
        Example.model_validate(wrong)


def test_a_whole_number_may_stand_for_a_number():
    assert Example(needed=1).needed == 1.0


def test_parameters_never_change_once_made():
    example = Example(needed=1.0)
    with pytest.raises(ValidationError, match="frozen"):
        example.count = 4


def test_a_default_out_of_bounds_is_found_out():
    class Broken(Parameters):
        count: int = parameter(-1, unit="-", ge=0, meaning="A number.")

    with pytest.raises(ValidationError, match="greater than or equal to 0"):
        Broken()


def test_a_redeclared_parameter_differs_in_default_and_source_only():
    class Child(Example):
        count: int = redeclared(Example, "count", 8, "another paper")

    before = {d.key: d for d in declarations(Example)}["count"]
    after = {d.key: d for d in declarations(Child)}["count"]
    assert (after.default, after.source) == (8, "another paper")
    assert vars(after) == {**vars(before), "default": 8, "source": "another paper"}
    with pytest.raises(ValidationError):
        Child(needed=1.0, count=-1)


@pytest.mark.parametrize("note", ["why", ["two", "lines"], None])
def test_every_group_may_carry_a_note(note):
    assert Example(needed=1.0, note=note).note == note


def test_every_variant_of_a_group_is_declared():
    keys = [d.key for d in declarations(Regime) if d.key.startswith("speed_ramp")]
    assert keys == [
        "speed_ramp.kind",
        "speed_ramp.kind",
        "speed_ramp.time_1",
        "speed_ramp.value_1",
        "speed_ramp.time_2",
        "speed_ramp.value_2",
        "speed_ramp.kind",
        "speed_ramp.points",
        "speed_ramp.points[].time",
        "speed_ramp.points[].value",
    ]


class Corner(Parameters):
    """Keys of which some act with a choice of another one only."""

    sides: Literal["faces", "corners"] = parameter("faces", unit="-", meaning="Neighbours.")
    limit: int = parameter(2, unit="slabs", meaning="To corners.", acts_with={"sides": "corners"})
    length: float | None = parameter(None, unit="m", meaning="A length.")
    parts: int = parameter(3, unit="-", meaning="Of the length.", acts_with={"length": GIVEN})
    law: str = parameter("a", unit="-", meaning="Of the length.", acts_with={"length": NOT_GIVEN})


class Corners(Parameters):
    """A group with several such groups."""

    several: list[Corner] = parameter(list, unit="-", meaning="Groups.")


@pytest.mark.parametrize(
    ("values", "idle"),
    [
        ({}, []),
        ({"limit": 3}, [("limit", 3, "where sides is 'corners'")]),
        ({"limit": 3, "sides": "corners"}, []),
        ({"limit": 2}, []),
        ({"parts": 4}, [("parts", 4, "where length is given")]),
        ({"parts": 4, "length": 1.0}, []),
        ({"law": "b"}, []),
        ({"law": "b", "length": 1.0}, [("law", "b", "where length is not given")]),
    ],
)
def test_keys_that_the_choice_of_another_leaves_without_effect_are_found(values, idle):
    assert list(idle_keys(Corner(**values))) == idle
    nested = [(f"several[1].{key}", value, where) for key, value, where in idle]
    assert list(idle_keys(Corners(several=[Corner(), Corner(**values)]))) == nested


def test_the_meaning_of_a_key_says_where_it_acts():
    meanings = {declared.key: declared.meaning for declared in declarations(Corner)}
    assert meanings["limit"] == "To corners. It acts where sides is 'corners'."
    assert meanings["parts"] == "Of the length. It acts where length is given."


@pytest.mark.parametrize("group", [model.Parameters for model in models().values()] + [Clock])
def test_every_key_that_a_parameter_acts_with_is_one_of_its_group(group):
    def check(group):
        for field in group.model_fields.values():
            extra = field.json_schema_extra or {}
            assert set(extra.get("acts_with", {})) <= set(group.model_fields)
            for inner in variants(field.annotation):
                check(inner)

    check(group)
