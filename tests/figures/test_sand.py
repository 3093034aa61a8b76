"""Thresholds and flux laws, drawn as they are computed."""

import io

import numpy as np

from barchan.aeolian import Saltation
from barchan.aeolian.flux import LAWS
from barchan.figures.sand import flux_laws, thresholds


def test_the_divide_crosses_the_threshold_in_fine_sand():
    figure = thresholds(Saltation(grain_diameter=0.2e-3))
    figure.savefig(io.BytesIO(), dpi=40)
    cohesive, _, settling, point = figure.axes[0].lines
    diameters = cohesive.get_xdata()
    crossing = diameters[np.argmin(np.abs(np.log(cohesive.get_ydata() / settling.get_ydata())))]
    assert 0.05 < crossing < 0.1
    assert point.get_xdata()[0] == 0.2


def test_every_law_is_drawn_and_the_chosen_one_stands_out():
    sand = Saltation(law="owen")
    figure = flux_laws(sand)
    figure.savefig(io.BytesIO(), dpi=40)
    lines = [line for line in figure.axes[0].lines if "(" in line.get_label()]
    assert len(lines) == len(LAWS)
    (thick,) = [line for line in lines if line.get_linewidth() > 2]
    assert "owen" in thick.get_label()
    np.testing.assert_allclose(thick.get_ydata(), sand.mass_flux(thick.get_xdata()))
