"""The measures of a run's frames, one after the other: a table of declared measures."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from barchan.analysis.declared_measures import Measure, Value, measures_of
from barchan.analysis.fields import as_modelled, bed_in, scenario_at
from barchan.analysis.frame_measurer import MOST_KEPT, FrameMeasurer
from barchan.analysis.measured_frame import MeasuredFrame, WindChoice
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr


def measured_frames(
    dataset: "xr.Dataset", scenario: Scenario, first: int = 0, wind: WindChoice = "resultant"
) -> Iterator[MeasuredFrame]:
    """The frames of a run from number ``first`` on, compared with those before.

    Downwind, windward and lee refer to the ``wind``: the resultant of a whole cycle, or the last step's.
    """
    measurer = FrameMeasurer(scenario, wind)
    steps = dataset["step"].values
    travelled = np.stack([dataset["travel_x"].values, dataset["travel_y"].values], axis=1)
    winds = dataset["wind_direction"].values
    for at in range(max(0, first - MOST_KEPT), len(steps)):
        frame = dataset.isel(step=at)
        forcing = scenario_at(frame, scenario).forcing()
        bed = bed_in(frame, scenario)
        if at < first:
            measurer.keep(int(steps[at]), bed, forcing, travelled[at])
            continue
        yield measurer.measured(
            int(steps[at]),
            bed,
            forcing,
            float(winds[at]),
            travelled[at],
            partial(as_modelled, frame, scenario),
        )


def measure_series(
    dataset: "xr.Dataset",
    scenario: Scenario,
    wind: WindChoice = "resultant",
    told: Callable[[], None] = lambda: None,
) -> "xr.Dataset":
    """Every measure over the steps of a run; see ``measured_frames``. ``told`` is called after each frame.

    The attribute ``doubtful`` of a measure lists the steps at which it should not be quoted.
    """
    import xarray as xr

    measures = measures_of(scenario)
    frames = measured_frames(dataset, scenario, wind=wind)
    columns = zip(*(_values_of(measures, frame, told) for frame in frames), strict=True)
    steps = dataset["step"].values
    return xr.Dataset(
        {
            measure.name: (
                "step",
                np.array([value.value for value in values]),
                {
                    "long_name": measure.title,
                    "unit": measure.unit,
                    "doubtful": [int(step) for step, value in zip(steps, values, strict=True) if value.doubt],
                },
            )
            for measure, values in zip(measures, columns, strict=True)
        },
        {name: dataset[name] for name in ("step", "time") if name in dataset.coords},
    )


def _values_of(
    measures: Sequence[Measure[MeasuredFrame]], frame: MeasuredFrame, told: Callable[[], None]
) -> list[Value]:
    values = [measure.of(frame) for measure in measures]
    told()
    return values


def last_values(dataset: "xr.Dataset", scenario: Scenario, wind: WindChoice = "resultant") -> list[Value]:
    """The measures of a run's last frame, with their doubts; see ``measured_frames``."""
    last = next(iter(measured_frames(dataset, scenario, dataset.sizes["step"] - 1, wind)))
    return [measure.of(last) for measure in measures_of(scenario)]


def last_measures(dataset: "xr.Dataset", scenario: Scenario) -> dict[str, float]:
    """The measures of a run's last frame, by name."""
    return {value.measure.name: value.value for value in last_values(dataset, scenario)}
