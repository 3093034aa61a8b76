"""The class of the forms of a field of snow, from the measures of a frame."""

from collections.abc import Iterable

from barchan.analysis.declared_measures import Value
from barchan.measures.snow_forms import Form, form_of
from barchan.scenario import Scenario

HOUR = 3600.0


def form(values: Iterable[Value], scenario: Scenario) -> Form | None:
    """The class of a frame by its measures; None for a model that does not measure skewness of slopes."""
    found = {value.measure.name: value.value for value in values}
    seconds, quantum = scenario.step_seconds, scenario.new_model().unit_height
    if "slope_skewness" not in found or seconds is None or quantum is None:
        return None
    return form_of(
        relief=found["relief"],
        spacing=found["spacing"],
        skewness=found["slope_skewness"],
        speed=found["speed"] * HOUR / seconds,
        bonded=found["bonded_share"],
        quantum=quantum,
    )
