"""Sections of snow show its layers by the age of their bonds."""

import numpy as np
import pytest
from matplotlib.patches import Rectangle

from barchan.entry import simulate
from barchan.errors import BarchanError
from barchan.figures.sections import profile
from barchan.figures.style import colour_map
from tests.tiny import COLUMNS, tiny

OLDER = [{"mass": 4.0, "density": 250.0, "age": 24.0}, {"mass": 2.0, "density": 400.0, "age": 288.0}]


def test_each_layer_lies_on_the_one_below_at_its_own_thickness():
    """4, 2 and 3 kg/m² of 250, 400 and 100 kg/m³ are 16, 5 and 30 mm thick."""
    model = {"name": "snow", "beneath": OLDER, "start_density": 100.0}
    scenario = tiny(model=model, sand={"kind": "flat", "mean": 3}, run__steps=0)
    axes = profile(simulate(scenario).isel(step=-1), scenario, at=0.5).axes[0]
    bars = [patch for patch in axes.patches if isinstance(patch, Rectangle)]
    places = sorted({(round(bar.get_y(), 6), round(bar.get_height(), 6)) for bar in bars})
    assert places == [(0.0, 0.016), (0.016, 0.005), (0.021, 0.03)]
    assert len({bar.get_facecolor() for bar in bars}) == 3
    assert len(bars) == 3 * COLUMNS


def test_snow_is_nearly_white_where_it_is_highest_and_sand_is_not():
    snow, sand = colour_map("natural", "snow")(1.0)[:3], colour_map("natural", "sand")(1.0)[:3]
    assert min(snow) > 0.95
    assert sand[2] < 0.8
    assert snow != pytest.approx(np.array(sand))


def drawn_layers(strata):
    model = {"name": "snow", "beneath": OLDER, "start_density": 100.0}
    scenario = tiny(model=model, sand={"kind": "flat", "mean": 3}, run__steps=0)
    figure = profile(simulate(scenario).isel(step=-1), scenario, at=0.5, strata=strata)
    bars = [patch for patch in figure.axes[0].patches if isinstance(patch, Rectangle)]
    return figure, {bar.get_facecolor() for bar in bars}


def test_layers_are_told_apart_by_their_state_in_two_colours():
    """Bonds of 24 and 288 h count as bonded, those of 0.1 h as loose: two colours for three layers."""
    figure, colours = drawn_layers("state")
    assert len(colours) == 2
    assert [text.get_text() for text in figure.axes[1].get_yticklabels()] == ["loose", "bonded"]


def test_layers_have_the_colour_of_their_density():
    figure, colours = drawn_layers("density")
    assert len(colours) == 3
    assert figure.axes[1].get_ylabel() == "density (kg/m³)"


def test_strata_that_a_model_has_not_are_refused():
    with pytest.raises(BarchanError, match="no strata 'hardness' with snow; allowed: age, density, state"):
        drawn_layers("hardness")
