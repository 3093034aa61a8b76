"""A scenario is complete, validated data that survives being written and read."""

import json

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from barchan.errors import ScenarioError
from barchan.parameters import NOTE, Parameters, variants
from barchan.scenario import Scenario, load_scenario
from barchan.simulation import Simulation
from tests.scenario.strategies import group, scenarios
from tests.tiny import data, tiny

wide = settings(suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture])


def buildable():
    """Valid scenarios small enough to build at once, with slabs, hills and angles as there are."""
    return st.builds(
        lambda drawn, lattice, sand, ground: {**drawn, "lattice": lattice, "sand": sand, "ground": ground},
        scenarios().map(_without_notes).filter(_needs_no_file),
        group(type(tiny().lattice)).map(_small),
        st.fixed_dictionaries(
            {"kind": st.sampled_from(["flat", "random", "dropped"]), "mean": st.integers(0, 20)}
        ),
        st.fixed_dictionaries({"kind": st.just("flat")})
        | st.fixed_dictionaries(
            {"kind": st.just("bump"), "radius": st.floats(0.5, 20), "height": st.floats(-9, 9)}
        ),
    )


def _small(lattice):
    size = {"rows": 1 + lattice.get("rows", 1) % 12, "columns": 8 + lattice.get("columns", 8) % 12}
    shape = {**lattice, **size, "cell_size": 1.0, "slab_height": None, "slab_aspect": 0.25, "kind": "square"}
    return _without_notes(shape)


def _without_notes(data):
    if isinstance(data, dict):
        return {key: _without_notes(value) for key, value in data.items() if key != NOTE}
    return data


def _needs_no_file(data):
    return data.get("model", {}).get("vegetation", {}).get("kind") != "file"


@wide
@given(scenarios())
def test_a_scenario_survives_its_own_text(drawn):
    scenario = load_scenario(drawn)
    assert load_scenario(json.loads(scenario.text())) == scenario


@wide
@given(drawn=scenarios())
def test_a_scenario_survives_a_file(tmp_path, drawn):
    scenario = load_scenario(drawn)
    path = tmp_path / "scenario.json"
    path.write_text(scenario.text(), "utf-8")
    again = load_scenario(path)
    assert again == scenario
    assert again.text() == scenario.text()


@wide
@given(scenarios())
def test_values_that_are_given_are_the_values_that_hold(drawn):
    scenario = load_scenario(drawn).data()
    assert _within(drawn, scenario)


def _within(part, whole):
    """Whether everything in ``part`` stands in ``whole`` too; empty notes are dropped."""
    if isinstance(part, dict):
        return all(_within(v, whole.get(k)) for k, v in part.items())
    if isinstance(part, list):
        return len(part) == len(whole) and all(map(_within, part, whole))
    return part == whole


def test_the_text_of_a_scenario_leaves_nothing_to_defaults():
    text = json.loads(tiny().text())
    model = type(tiny().model)
    assert set(text) == set(Scenario.model_fields) - {NOTE}
    assert set(text["model"]) == set(model.model_fields) - {NOTE}
    assert set(text["run"]) == {"steps", "seed", "save_every", "threads", "until"}


REASONS = (
    "so thicker slabs",
    "no grain can be lifted",
    "model.time_step: is",
    "model.footprint: is",
    "and the snow on it come to",
)
"""What is only known of a bed once it is made."""


@settings(max_examples=30, suppress_health_check=[HealthCheck.too_slow])
@given(buildable())
def test_every_small_scenario_builds_a_bed_at_rest_or_is_refused_for_what_its_parts_come_to(drawn):
    try:
        simulation = Simulation(load_scenario(drawn))
    except ScenarioError as error:
        assume(not any(reason in str(error) for reason in REASONS))
        raise
    bed = simulation.bed
    assert bed.stack.shape == (drawn["lattice"]["rows"], drawn["lattice"]["columns"])
    assert bed.stack.min() >= 0
    assert bed.units == simulation.ledger.initial
    assert np.isfinite(bed.elevation).all()
    assert simulation.model.relax(bed) == 0


HILL = {"ground": {"kind": "bump", "height": 5.0, "radius": 1e-3}}
EXTREMES = {
    "thin": {"lattice__slab_aspect": 1e-4, "lattice__cell_size": 1e-4},
    "thick": {"lattice__cell_size": 1e5, "lattice__slab_height": 1e6},
    "upright": {"model__repose_angle": 89},
    "thin and upright": {
        "lattice__slab_aspect": 1e-4,
        "lattice__cell_size": 1e-4,
        "model__repose_angle": 89,
        "model__shadow_angle": 89.99999999999999,
    },
}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("direction", [270.0, 220.0])
@pytest.mark.parametrize("ground", [{}, HILL], ids=["flat", "hill"])
@pytest.mark.parametrize("extreme", EXTREMES.values(), ids=list(EXTREMES))
def test_extremes_that_are_allowed_can_be_run(extreme, ground, direction):
    simulation = Simulation(tiny(**extreme, **ground, wind__direction=direction))
    assert simulation.advance(1).steps == 1
    assert simulation.bed.units == simulation.ledger.initial


@pytest.mark.parametrize(
    ("beyond", "said"),
    [
        ({"lattice__slab_height": 1e-300}, "allowed: 0.0001 to 10"),
        ({"lattice__cell_size": 1e-3, "lattice__slab_height": 1e6}, "allowed: 0.0001 to 10"),
        ({"lattice__slab_aspect": 1e-300}, "allowed: number ≥ 0.0001"),
        ({"model__repose_angle": 89.99999999999999}, "allowed: number ≥ 1 and ≤ 89"),
    ],
)
def test_extremes_whose_limits_no_stack_could_count_are_refused(beyond, said):
    with pytest.raises(ScenarioError, match=said):
        tiny(**beyond)


@pytest.mark.parametrize("key", ["lattice__note", "model__note"])
def test_a_note_of_several_lines_hinders_no_run(key):
    simulation = Simulation(tiny(**{key: ["one", "two"]}))
    assert simulation.advance(1).steps == 1


def groups_within(parameters):
    """A group of parameters and all groups in it."""
    yield parameters
    for field in parameters.model_fields.values():
        for inner in variants(field.annotation):
            yield from groups_within(inner)


def declared():
    return [
        pytest.param(field, id=f"{owner.__name__}.{name}")
        for owner in dict.fromkeys(groups_within(Scenario))
        for name, field in owner.model_fields.items()
        if name != NOTE and (isinstance(field.json_schema_extra, dict) or not variants(field.annotation))
    ]


@pytest.mark.parametrize("field", declared())
def test_every_parameter_has_a_unit_and_a_meaning(field):
    assert field.json_schema_extra["unit"]
    assert field.description[0].isupper()
    assert field.description.endswith((".", ")"))


@pytest.mark.parametrize("group_", list(dict.fromkeys(groups_within(Scenario))), ids=lambda g: g.__name__)
def test_every_group_of_parameters_is_closed_and_says_what_it_is(group_):
    assert issubclass(group_, Parameters)
    assert group_.__doc__
    assert group_.model_config["extra"] == "forbid"


def test_a_seed_is_kept_where_there_is_one_and_drawn_where_there_is_none():
    assert tiny(run__seed=3).seeded().seed == 3
    seeds = {tiny(run__seed=None).seeded().seed for _ in range(5)}
    assert len(seeds) == 5


def test_a_scenario_without_a_seed_says_so_when_asked_for_it():
    with pytest.raises(ValueError, match="no seed yet"):
        _ = tiny(run__seed=None).seed


def test_the_largest_seed_survives_programs_whose_numbers_are_all_floating():
    seed = 2**53 - 1
    assert int(float(tiny(run__seed=seed).seed)) == seed


def test_notes_are_kept_where_they_stand_and_left_out_where_there_are_none():
    given_ = data()
    given_["note"] = "top"
    given_["model"]["note"] = ["one", "two"]
    kept = load_scenario(given_).data()
    assert kept["note"] == "top"
    assert kept["model"]["note"] == ["one", "two"]
    assert "note" not in kept["run"]


def test_a_long_hop_is_remarked_on():
    assert tiny().remarks() == []
    (remark,) = tiny(model__hop_length=13).remarks()
    assert remark.startswith("hop length 13 cells is longer than half the field")
