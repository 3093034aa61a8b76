"""How long a scenario is expected to take, estimated before it runs."""

import math
from typing import TYPE_CHECKING

from barchan.wind.segment import Segment

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario

SAMPLES = 100
"""Steps of the forcing that stand for all, where the wind changes."""

_SECOND, _MINUTE, _HOUR, _DAY = 1, 60, 3600, 86400

_UNITS = ((_DAY, "days"), (_HOUR, "hours"), (_MINUTE, "minutes"), (_SECOND, "seconds"))


def expected_work(scenario: "Scenario") -> float:
    """Work of the whole run, in the model's ``work_unit``.

    Each of up to 100 steps stands for an equal part of the run; where in its part it lies differs, so that
    winds that come and go periodically are not met at one phase only.
    """
    model, steps = scenario.new_model(), scenario.run.steps
    work = sum(map(model.expected_work, sampled_segments(scenario)))
    return work * max(steps / SAMPLES, 1.0)


def sampled_segments(scenario: "Scenario") -> list[Segment]:
    """The winds of up to 100 steps, one of each equal part of the run; of one seed where it states none."""
    forcing, steps = scenario.seeded(0).forcing(), scenario.run.steps
    _, unchanged, _ = next(forcing.constant_intervals(0, steps), (0, 0, []))
    if unchanged == steps:
        first = [segment for segments in forcing.segments(0, 1) for segment in segments]
        return first * min(steps, SAMPLES)
    chosen = range(steps) if steps <= SAMPLES else _spread(steps, SAMPLES)
    return [s for step in chosen for segments in forcing.segments(step, 1) for s in segments]


def _spread(steps: int, samples: int) -> list[int]:
    """One step of each of ``samples`` equal parts of a run, at places that go on by the golden ratio."""
    golden = (math.sqrt(5.0) - 1.0) / 2.0
    return [int((number + number * golden % 1.0) * steps / samples) for number in range(samples)]


def expected_seconds(scenario: "Scenario") -> float:
    """Time (s) that the run takes on one core of a common computer, within a factor of about three.

    Work at the model's measured rate; compiling, saving frames and settling at the start are left out, and
    so is what the shape of the bed does to the rate.
    """
    return expected_work(scenario) / scenario.new_model().work_per_second


def spoken_estimate(seconds: float) -> str:
    """An expected time in one figure, ``about 3 minutes``, as rough as the estimate is."""
    if seconds < 0.95:
        return "under a second"
    size, name = next(unit for unit in _UNITS if seconds >= 0.95 * unit[0])
    figures = f"{float(f'{seconds / size:.1g}'):.0f}"
    return f"about {figures} {name.removesuffix('s') if figures == '1' else name}"


COMPILED = "10 to 60 seconds where its rules are compiled first"


def spoken_time(scenario: "Scenario", settling: float = 0.0) -> str:
    """The expected time of a scenario for people to read, and those of compilation and of settling (s)."""
    estimate = spoken_estimate(expected_seconds(scenario))
    slides = (
        f"; before it {spoken_estimate(settling)} until all slopes are at rest" if settling >= 1.0 else ""
    )
    return f"{estimate}, and {COMPILED}{slides}"
