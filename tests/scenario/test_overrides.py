"""Single values set over a preset: short names, other variants, and what they leave behind."""

import pytest

import barchan
from barchan.errors import ScenarioError
from barchan.models import model_names, models
from barchan.parameters import variants
from barchan.scenario import Scenario, load_scenario


@pytest.mark.parametrize("preset", ["barchans", "nebkhas", "bishop-barchans", "ripples", "coupled-map"])
@pytest.mark.parametrize("name", model_names())
def test_any_model_can_be_chosen_for_any_preset(preset, name):
    """Keys of the old model go; those that both have keep the preset's values."""
    before, after = barchan.load(preset), load_scenario(preset, [("model.name", name)])
    assert after.model.name == name
    shared = set(type(before.model).model_fields) & set(models()[name].Parameters.model_fields)
    for key in shared & before.model.model_fields_set & after.model.model_fields_set - {"name"}:
        old, new = getattr(before.model, key), getattr(after.model, key)
        assert old == new or not isinstance(old, int | float | str | bool)


@pytest.mark.parametrize(
    "kind", [k.model_fields["kind"].default for k in variants(Scenario.model_fields["ground"].annotation)]
)
def test_any_ground_can_be_chosen_for_a_preset_unless_it_lacks_a_key(kind):
    try:
        chosen = barchan.load("uneven", ground__kind=kind).ground.kind
    except ScenarioError as error:
        problems = error.problems
    else:
        problems = []
        assert chosen == kind
    assert all("is missing" in problem.message for problem in problems)


def test_what_is_left_out_is_remarked():
    remarks = load_scenario("barchans", [("wind.kind", "record"), ("clock", "{}")]).remarks()
    assert "wind is record instead of steady: left out direction, of no use there" in remarks


def test_a_key_of_the_old_variant_that_was_given_itself_is_refused():
    with pytest.raises(ScenarioError) as failed:
        load_scenario("uneven", [("ground.kind", "flat"), ("ground.height", "3")])
    assert "ground.height: unknown key; known here: kind, level (command line)" in str(failed.value)


def test_a_variant_may_stand_for_its_group():
    scenario = load_scenario("uneven", [("model", "ripples"), ("ground", "flat"), ("sand", "flat")])
    assert (scenario.model.name, scenario.ground.kind, scenario.sand.kind) == ("ripples", "flat", "flat")


def test_keys_of_run_and_lattice_need_no_group():
    given = [("seed", "3"), ("steps", "20"), ("rows", "17"), ("columns", "33"), ("save-every", "4")]
    scenario = load_scenario("barchans", given)
    assert scenario == barchan.load("barchans", seed=3, steps=20, rows=17, columns=33, save_every=4)
    assert (scenario.run.seed, scenario.run.steps, scenario.run.save_every) == (3, 20, 4)
    assert scenario.lattice.shape == (17, 33)


@pytest.mark.parametrize(
    ("key", "hint"),
    [
        ("hop_length", "did you mean model__hop_length?"),
        ("lattice__row", "did you mean 'rows'?"),
        ("seeds", "did you mean 'seed'?"),
    ],
)
def test_python_is_answered_in_python(key, hint):
    with pytest.raises(ScenarioError) as failed:
        barchan.load("barchans", **{key: 3})
    assert hint in str(failed.value)
    assert f"(argument {key})" in str(failed.value)


def test_the_command_line_is_answered_in_its_own_words():
    with pytest.raises(ScenarioError, match=r"did you mean --model\.hop-length\?"):
        load_scenario("barchans", [("hop-length", "3")])


def test_simulate_takes_whatever_load_takes():
    by_name = barchan.simulate("barchans", rows=8, columns=8, steps=3, seed=1)
    by_scenario = barchan.simulate(barchan.load("barchans", rows=8, columns=8, steps=3, seed=1))
    assert by_name.identical(by_scenario)


def test_a_changed_preset_says_so_in_title_and_citation():
    changed = barchan.load("barchans", model__hop_length=7, wind__direction=270.0, seed=3, steps=20)
    plain = barchan.load("barchans")
    assert changed.title == f"{plain.title}, changed: model.hop_length 7"
    assert changed.citation == f"{plain.citation}; changed: model.hop_length 7"


def test_a_longer_run_of_a_preset_keeps_its_title():
    assert barchan.load("barchans", steps=20, seed=4).title == barchan.load("barchans").title


def test_a_scenario_changed_twice_names_both_changes():
    once = barchan.load("barchans", model__hop_length=7)
    twice = barchan.load(once.data(), wind__direction=90)
    assert twice.title == "Barchans, changed: model.hop_length 7, wind.direction 90"


def test_a_value_changed_twice_is_named_once_as_it_is_now():
    once = barchan.load("barchans", model__hop_length=7, wind__direction=90)
    twice = barchan.load(once.data(), model__hop_length=9, model__p_s=0.5)
    assert twice.title == "Barchans, changed: model.hop_length 9, wind.direction 90, model.p_s 0.5"
    assert twice.citation.partition("changed: ")[2] == twice.title.partition("changed: ")[2]


def test_changes_that_another_kind_of_ground_does_not_have_are_named_no_more():
    once = barchan.load("barchans", ground__kind="bump", ground__height=7, lattice__cell_size=2)
    other = barchan.load({**once.data(), "ground": {"kind": "flat"}})
    told = barchan.load(other.data(), lattice__cell_size=3).title
    assert told == "Barchans, changed: ground.kind flat, lattice.cell_size 3"


def test_words_of_ones_own_that_read_like_changes_stay():
    mine = barchan.load("barchans", title="Dunes, changed: slow, steady wind")
    told = barchan.load(mine.data(), model__hop_length=7).title
    assert told == "Dunes, changed: slow, steady wind, model.hop_length 7"


def test_a_title_that_was_given_stays():
    assert barchan.load("barchans", title="Mine", model__hop_length=7).title == "Mine"


def test_many_changes_do_not_make_a_title_too_long():
    scenario = barchan.load("barchans", title="x" * 190)
    assert len(barchan.load(scenario.data(), model__hop_length=7).title) == 200


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"influx": {"share": 0.2}}, "influx.kind: is missing; allowed: saturation, "),
        (
            {"model": {"name": "nield_baas", "vegetation": {"path": "x"}}},
            "is missing; allowed: uniform, blowouts",
        ),
    ],
)
def test_a_group_that_does_not_say_which_it_is_is_told_what_it_may_be(data, said):
    with pytest.raises(ScenarioError) as failed:
        load_scenario({"barchan": 5, **data})
    assert said in str(failed.value)


def test_what_to_look_for_in_a_preset_is_said_to_be_that_without_changes():
    plain = barchan.load("barchans").look_for
    once = barchan.load("barchans", model__hop_length=7)
    assert once.look_for == f"(without these changes) {plain}"
    assert barchan.load(once.data(), wind__direction=90).look_for == once.look_for
    assert barchan.load("barchans", steps=20, seed=4).look_for == plain
    assert barchan.load("barchans", model__hop_length=7, look_for="Mine").look_for == "Mine"


def test_what_to_look_for_in_a_preset_goes_with_its_model():
    assert barchan.load("barchans", model="bishop").look_for == ""
