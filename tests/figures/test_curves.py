"""Curves among parameters, drawn as they are given."""

import io

import pytest

from barchan.figures.curves import curves_of
from barchan.models import Curve, models
from tests.tiny import tiny

SCENARIO = tiny(model={"name": "nield_baas"})


def test_the_growth_of_plants_is_drawn_as_it_is_and_what_is_assumed_is_said():
    curves = models()["nield_baas"].curves(SCENARIO.model)
    (axes,) = curves_of(curves, SCENARIO).axes
    names = [text.get_text() for text in axes.get_legend().get_texts()]
    assert names == ["grass", "mesquite (assumed)", "shrub"]
    drawn = {line.get_label(): line for line in axes.lines}
    for curve, name in zip(curves, names, strict=True):
        assert tuple(drawn[name].get_xdata()) == curve.x
        assert tuple(drawn[name].get_ydata()) == curve.y
        assert drawn[name].get_linestyle() == ("--" if curve.remark else "-")
    assert axes.get_xlabel() == "sediment balance (m/yr)"
    assert axes.get_ylabel() == "change of effectiveness (1/yr)"


@pytest.mark.parametrize("count", [1, 3])
def test_curves_of_other_quantities_have_panels_of_their_own(count):
    curves = [Curve("one", (0.0, 1.0), (1.0, 2.0), "x", f"y{k // 2}") for k in range(2 * count)]
    figure = curves_of(curves, SCENARIO)
    assert [len(axes.get_legend().get_texts()) for axes in figure.axes] == [2] * count
    figure.savefig(io.BytesIO(), dpi=40)
