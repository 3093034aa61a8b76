"""Positions on sawtooth ridges, whose parts are known by their heights."""

import numpy as np
import pytest

from barchan.measures.positions import Position, mean_by_position, positions
from tests.measures.waves import ridges, sine, wind_along

WAVE = (2, 0)


def shares(found):
    return [float((found == position).mean()) for position in Position]


@pytest.mark.parametrize("wave", [WAVE, (0, 2), (2, 1)])
def test_ridges_have_the_parts_that_their_heights_tell(wave):
    """Rising over 3/4 of a period and falling over 1/4: a tenth is floor, a fifth crest, the rest 3 to 1."""
    found = positions(ridges(*wave), 1.0, wind_along(*wave), 20, width=0.0)
    assert shares(found) == pytest.approx([0.1, 0.7 * 0.75, 0.2, 0.7 * 0.25], abs=0.06)


def test_a_wind_from_the_other_side_changes_windward_and_lee():
    ahead = shares(positions(ridges(*WAVE), 1.0, 270.0, 20, width=0.0))
    behind = shares(positions(ridges(*WAVE), 1.0, 90.0, 20, width=0.0))
    assert ahead[::2] == behind[::2]
    assert ahead[1::2] == behind[:0:-2]


def test_a_plain_is_floor_and_a_void_is_nowhere():
    plain = np.zeros((16, 24))
    assert (positions(plain, 1.0, 270.0, 4) == Position.FLOOR).all()
    plain[:4] = np.nan
    assert (positions(plain, 1.0, 270.0, 4, (False, False))[:4] == -1).all()


def test_plants_on_lee_sides_only_are_found_there():
    found = positions(sine(*WAVE), 1.0, 270.0, 20)
    cover = np.where(found == Position.LEE, 0.6, 0.0)
    means = mean_by_position(cover, found)
    assert means[Position.LEE] == pytest.approx(0.6)
    assert means[Position.WINDWARD] == means[Position.CREST] == means[Position.FLOOR] == 0.0
    assert np.isnan(mean_by_position(cover, np.zeros_like(found))[Position.CREST])
