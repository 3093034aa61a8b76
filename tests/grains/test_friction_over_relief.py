"""The friction velocity of the wind along the bed, as a field of the models of grains."""

import math

import numpy as np
import pytest

import barchan
from barchan.analysis.fields import field_of
from barchan.bed import Bed
from barchan.grains.friction_over_relief import friction_velocity
from barchan.lattice import Lattice
from barchan.models import models
from barchan.wind.segment import Segment
from tests.tiny import tiny

LATTICE = Lattice(rows=6, columns=64, cell_size=0.005, slab_height=0.15e-3)
WEST = Segment(0, 1, 0, LATTICE.cells, 270.0)
FLAT = 0.4 * 10.0 / math.log(10.0 / 1e-5)
"""Friction velocity (m/s) of 10 m/s at 10 m over a roughness length of 0.01 mm: u 0.4 / ln(z / z0)."""


def model_of(name="ripples", **rules):
    kind = models()[name]
    return kind(kind.Parameters(wind_speed=10.0, roughness=1e-5, **rules), LATTICE)


def bed_with(ground):
    return Bed(LATTICE, np.asarray(ground, float), np.full(LATTICE.shape, 20))


def test_over_a_wave_it_is_the_root_of_the_stress_that_linear_theory_gives():
    """1 + k h (A cos kx - B sin kx) for a wave h cos kx: A on crests, B where the bed rises downwind."""
    height, number = 2e-4, 2 * math.pi / (LATTICE.columns * LATTICE.cell_size) * 4
    phase = number * (np.arange(LATTICE.columns) + 0.5) * LATTICE.cell_size
    relief = {"streamline_height": None, "stress_in_phase": 4.0, "stress_in_quadrature": 2.0}
    model = model_of(relief_flow=relief, shelter={"angle": None})
    found = friction_velocity(model, bed_with(np.tile(height * np.cos(phase), (6, 1))), WEST)
    stress = 1.0 + number * height * (4.0 * np.cos(phase) - 2.0 * np.sin(phase))
    np.testing.assert_allclose(found, np.tile(FLAT * np.sqrt(stress), (6, 1)), rtol=1e-4)


def test_over_a_level_bed_it_is_that_of_the_law_of_the_wall():
    found = friction_velocity(model_of(), bed_with(np.zeros(LATTICE.shape)), WEST)
    np.testing.assert_allclose(found, FLAT, rtol=1e-6)


def test_behind_a_step_it_is_zero_as_far_as_the_shadow_reaches():
    """20 mm fall at 45° over 4 cells of 5 mm; beyond them the wind blows as before, for it ignores relief."""
    ground = np.zeros(LATTICE.shape)
    ground[:, 10] = 0.02
    model = model_of("wang_hu", shelter={"angle": 45.0})
    found = friction_velocity(model, bed_with(ground), WEST)
    assert not found[:, 11:14].any()
    np.testing.assert_allclose(found[:, [9, 10, 15, 30]], FLAT, rtol=1e-6)


@pytest.mark.parametrize("name", ["wang_hu", "ripples", "snow_grains"])
def test_every_model_of_grains_declares_it_and_a_run_has_it(name):
    lattice = {"rows": 6, "columns": 8, "cell_size": 0.005, "slab_height": 0.15e-3}
    model = {"name": name, "wind_speed": 10.0, "roughness": 1e-5, "time_step": 5e-4}
    run = barchan.simulate(tiny(lattice=lattice, model=model, sand={"kind": "flat", "mean": 4}, run__steps=0))
    field = field_of(run.isel(step=-1), run.barchan.scenario, "friction_velocity")
    assert (field.attrs["unit"], field.attrs["along_wind"]) == ("m/s", 1)
    np.testing.assert_allclose(field, FLAT, rtol=1e-6)
