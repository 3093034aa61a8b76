"""The fields that models derive from a bed: the wind rises to the crest and is gone in the lee."""

import numpy as np
import pytest

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.models import models
from barchan.wind.segment import Segment

LATTICE = Lattice(rows=16, columns=96)
CREST, HEIGHT = 48, 12
"""A ridge across the wind, one slab up every two cells, two down every cell; its shadow is 14 cells long."""

WESTERLY = Segment(0, 1, 0, LATTICE.cells, 270.0)


def ridge():
    x = np.arange(LATTICE.columns)
    height = np.minimum(HEIGHT - (CREST - x) // 2, HEIGHT - 2 * (x - CREST)).clip(0)
    return Bed(LATTICE, np.zeros(LATTICE.shape), np.tile(height + 2, (LATTICE.rows, 1)))


def derived(name, field, bed, **parameters):
    kind = models()[name]
    (found,) = (known for known in kind.derived if known.name == field)
    return found.compute(kind(kind.Parameters(**parameters), LATTICE), bed, WESTERLY)


@pytest.mark.parametrize(
    ("name", "field"), [("momiji", "hop"), ("momiji", "speedup"), ("bishop", "hop"), ("pelletier", "stress")]
)
def test_the_wind_rises_to_the_crest_and_is_gone_in_the_lee(name, field):
    along = derived(name, field, ridge())[8]
    assert (np.diff(along[CREST - 20 : CREST - 1]) > -1e-9).all()
    assert along[CREST - 1] > 1.2 * along[2]
    assert (along[CREST + 1 : CREST + 14] == 0).all()


def test_hops_follow_the_published_law_where_the_wind_blows():
    bed = ridge()
    hop = derived("momiji", "hop", bed, hop_length=5.0, speedup_linear=0.4, speedup_quadratic=0.002)
    rise = bed.sand - bed.sand.mean()
    expected = 5.0 + 0.4 * rise + 0.002 * np.where(rise > 0, rise, 0) ** 2
    lit = ~derived("momiji", "shadow", bed)
    assert 0.2 < lit.mean() < 1.0
    np.testing.assert_allclose(hop, np.where(lit, expected, 0.0))


def test_the_speedup_is_the_hop_over_that_on_a_flat_bed():
    bed = ridge()
    hop, speedup = (derived("bishop", field, bed, hop_length=4.0) for field in ("hop", "speedup"))
    np.testing.assert_allclose(speedup, hop / 4.0)


@pytest.mark.parametrize(("name", "field"), [("momiji", "hop"), ("pelletier", "stress")])
def test_where_shadowed_cells_may_erode_the_wind_is_not_gone(name, field):
    bed = ridge()
    shadow = derived(name, "shadow", bed)
    assert (derived(name, field, bed)[shadow] == 0).all()
    assert (derived(name, field, bed, lee_erosion=True)[shadow] != 0).any()
