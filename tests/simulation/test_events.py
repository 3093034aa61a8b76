"""Changes during a run are journaled: scenario plus events gives the same bits again."""

import pytest

from barchan.errors import ScenarioError
from barchan.parameters import declarations
from barchan.simulation import Record, SetParameter, SetWind, Simulation, Stroke, event_from
from barchan.wind import Steady
from tests.tiny import tiny

PARAMETERS = {d.key: d for d in declarations(type(tiny().model))}
LIVE = [key for key, declaration in PARAMETERS.items() if declaration.live]
FIXED = [key for key, declaration in PARAMETERS.items() if not declaration.live]

JOURNAL = [
    (2, SetParameter(key="model.p_s", value=0.9)),
    (2, Stroke(x=20.0, y=9.0, radius=5.0, amount=-4, falloff="linear")),
    (5, SetWind(wind=Steady(direction=310.0, speed=2.5))),
    (9, SetParameter(key="model.neighbourhood", value="moore")),
    (9, SetParameter(key="model.corner_limit", value=1)),
    (14, Stroke(x=1.0, y=1.0, radius=6.0, amount=9)),
]


def run_with(events, steps=20):
    """A run in which events happen at their steps."""
    simulation = Simulation(tiny())
    for step, event in events:
        simulation.advance(step - simulation.steps_done)
        simulation.apply(event)
    simulation.advance(steps - simulation.steps_done)
    return simulation


def test_the_journal_holds_every_event_with_its_step():
    assert run_with(JOURNAL).events == [Record(step, event) for step, event in JOURNAL]


def test_replaying_the_journal_gives_the_same_bits(same):
    first = run_with(JOURNAL)
    again = run_with([(record.step, record.event) for record in first.events])
    same(first, again)


def test_a_record_survives_being_plain_data():
    for step, event in JOURNAL:
        record = Record(step, event)
        assert Record.from_data(record.data()) == record


def test_reading_a_record_leaves_its_data_alone():
    data = Record(*JOURNAL[0]).data()
    before = dict(data)
    Record.from_data(data)
    assert data == before


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("hop_length", 2.0),
        ("p_s", 0.9),
        ("shadow_angle", 30.0),
        ("lee_erosion", False),
        ("forced_erosion", True),
    ],
)
def test_a_parameter_set_before_the_first_step_is_as_good_as_one_in_the_scenario(same, key, value):
    changed = Simulation(tiny())
    changed.apply(SetParameter(key=f"model.{key}", value=value))
    stated = Simulation(tiny(**{f"model__{key}": value}))
    changed.advance(10)
    stated.advance(10)
    stated.events = changed.events
    same(changed, stated)


def test_a_wind_set_before_the_first_step_is_as_good_as_one_in_the_scenario(same):
    wind = Steady(direction=33.0, speed=2.0)
    changed = Simulation(tiny())
    changed.apply(SetWind(wind=wind))
    stated = Simulation(tiny(wind=wind.model_dump(mode="json")))
    changed.advance(10)
    stated.advance(10)
    stated.events = changed.events
    same(changed, stated)


@pytest.mark.parametrize(("direction", "travel"), [(0, (0, -1)), (90, (-1, 0)), (180, (0, 1)), (270, (1, 0))])
def test_sand_travels_downwind_of_the_wind_that_was_set(direction, travel):
    simulation = Simulation(tiny())
    simulation.apply(SetWind(wind=Steady(direction=direction)))
    tally = simulation.advance(5)
    signs = [(value > 0) - (value < 0) for value in (tally.travel_x, tally.travel_y)]
    assert tuple(signs) == travel


@pytest.mark.parametrize("key", LIVE)
def test_a_live_parameter_may_be_set_to_what_it_is(same, key):
    untouched, touched = Simulation(tiny()), Simulation(tiny())
    touched.apply(SetParameter(key=f"model.{key}", value=getattr(tiny().model, key)))
    untouched.advance(3)
    touched.advance(3)
    untouched.events = touched.events
    same(untouched, touched)


@pytest.mark.parametrize(
    "key", [*(f"model.{key}" for key in FIXED), "lattice.rows", "run.seed", "hop_length"]
)
def test_what_is_not_live_cannot_change_during_a_run(key):
    simulation = Simulation(tiny())
    with pytest.raises(ScenarioError, match="cannot change during a run") as caught:
        simulation.apply(SetParameter(key=key, value=1))
    assert "what can: model.hop_length" in str(caught.value)
    assert simulation.events == []


def test_a_mistyped_parameter_is_reported_with_the_nearest_name():
    with pytest.raises(ScenarioError, match=r"did you mean 'model\.hop_length'"):
        Simulation(tiny()).apply(SetParameter(key="model.hop_lenght", value=1))


@pytest.mark.parametrize(
    ("key", "value"), [("p_s", 1.5), ("p_s", "much"), ("polling", "never"), ("p_s", None)]
)
def test_a_value_out_of_bounds_is_refused_and_changes_nothing(same, key, value):
    simulation, untouched = Simulation(tiny()), Simulation(tiny())
    with pytest.raises(ScenarioError, match=f"model.{key}: is"):
        simulation.apply(SetParameter(key=f"model.{key}", value=value))
    simulation.advance(3)
    untouched.advance(3)
    same(simulation, untouched)


def test_a_lower_angle_of_repose_lets_the_bed_settle_at_once():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 9}))
    simulation.advance(30)
    steepest = abs(simulation.bed.sand[:, 1:] - simulation.bed.sand[:, :-1]).max()
    assert steepest == 2
    simulation.apply(SetParameter(key="model.repose_test", value="after"))
    sand = simulation.bed.sand
    assert abs(sand - sand.take(range(1, 25), axis=1, mode="wrap")).max() <= 1
    assert abs(sand - sand.take(range(1, 17), axis=0, mode="wrap")).max() <= 1


def test_a_run_that_had_ended_goes_on_after_an_event():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}, run__until={"idle_steps": 3}))
    simulation.advance(10)
    assert simulation.finished
    simulation.apply(Stroke(x=12.0, y=8.0, radius=5.0, amount=5))
    assert simulation.finished is None
    assert simulation.advance(4).moved > 0


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"kind": "stroke", "x": 1.0, "y": 1.0, "radius": -1.0, "amount": 3}, "radius"),
        ({"kind": "paint"}, "kind"),
        ({"kind": "set", "key": "model.p_s"}, "value"),
        ({"kind": "wind", "wind": {"direction": 400}}, "direction"),
    ],
)
def test_data_that_is_no_event_is_refused_with_the_key_at_fault(data, said):
    with pytest.raises(ScenarioError, match=said):
        event_from(data)


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Stroke(x=1.0, y=2.0, radius=-3.0, amount=1), "radius: is -3.0; allowed: number > 0"),
        (lambda: Stroke(x=1.0, y=2.0, radius=3.0, amount=1, fallof="none"), "did you mean 'falloff'"),
        (lambda: Stroke(x=object(), y=2.0, radius=3.0, amount=1), "x: is "),
        (lambda: SetWind(wind={"kind": "steady", "direction": "N"}), "wind.direction: is 'N'"),
        (lambda: event_from({"kind": "strok"}), "did you mean 'stroke'"),
    ],
)
def test_an_event_that_is_given_wrongly_says_what_is_allowed(make, said):
    with pytest.raises(ScenarioError) as caught:
        make()
    assert said in str(caught.value)


def test_a_record_that_cannot_be_read_is_refused_and_the_wind_stays(tmp_path):
    broken = tmp_path / "broken.csv"
    broken.write_text("speed\n1\n")
    simulation = Simulation(tiny(clock={"grain_diameter": 0.00025, "reference_speed": 8.0}))
    with pytest.raises(ScenarioError, match="no column for the time"):
        simulation.apply(SetWind(wind={"kind": "record", "path": str(broken)}))
    assert simulation.wind.kind == "steady"
    assert simulation.events == []
    simulation.advance(2)


def test_a_wind_that_was_changed_in_an_archive_of_format_1_has_the_keys_of_today():
    regime = {"direction": 270.0, "steps": 3, "speed": 1.0, "final_speed": 2.0}
    bend = {"kind": "bezier", "time_1": 0.1, "value_1": 0.0, "time_2": 0.2, "value_2": 1.0}
    wind = {"kind": "regimes", "regimes": [{**regime, "course": bend}]}
    record = Record.from_data({"step": 4, "kind": "wind", "wind": wind})
    assert record.event.wind.regimes[0].speed_ramp.time_1 == 0.1


def by_the_clock(hop_length):
    """A run under the clock's reference wind, whose steps poll as many cells as the field has."""
    wind = {"kind": "steady", "direction": 270.0, "speed": 8.0, "unit": "m/s"}
    clock = {"reference_speed": 8.0, "grain_diameter": 0.00025}
    return Simulation(tiny(wind=wind, clock=clock, model__hop_length=hop_length))


def test_steps_of_a_clock_keep_their_duration_and_polls_follow_what_a_slab_does(same):
    simulation = by_the_clock(5.0)
    lasts, cells = simulation.scenario.step_seconds, simulation.lattice.cells
    assert simulation.advance(1).polls == cells
    simulation.apply(SetParameter(key="model.hop_length", value=2.5))
    assert simulation.advance(1).polls == 2 * cells  # half as far, twice as many: as much sand in a step
    assert simulation.scenario_as_run.step_seconds == lasts
    assert simulation.scenario_in_force.step_seconds == by_the_clock(2.5).scenario.step_seconds == lasts / 2
    again = Simulation.from_state(simulation.state())
    assert again.advance(1).polls == simulation.advance(1).polls == 2 * cells
    same(again, simulation)
    simulation.apply(SetParameter(key="model.hop_length", value=5.0))
    assert simulation.advance(1).polls == cells
