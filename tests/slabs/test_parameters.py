"""Whole slabs hold only some angles: limits, and the angles they really are."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.lattice import Lattice
from barchan.slabs.parameters import SlabParameters

THIRD = Lattice(rows=8, columns=8)

angles = st.floats(1, 89)
aspects = st.floats(0.01, 10)


@pytest.mark.parametrize(
    ("angle", "test", "limit", "effective"),
    [
        (30.0, "before", 2, 33.690),
        (30.0, "after", 1, 18.435),
        (33.7, "after", 2, 33.690),
        (math.degrees(math.atan(2 / 3)), "after", 2, 33.690),
        (45.0, "after", 3, 45.0),
        (5.0, "after", 1, 18.435),
    ],
)
def test_slabs_of_a_third_of_a_cell_hold_these_angles(angle, test, limit, effective):
    parameters = SlabParameters(repose_angle=angle, repose_test=test)
    assert parameters.face_limit(THIRD) == limit
    assert parameters.effective_angles(THIRD) == (pytest.approx(effective, abs=1e-3), None)


@pytest.mark.parametrize(
    ("corner_limit", "slabs", "effective"),
    [("face", 2, 25.239), ("geometric", 2, 25.239), (3, 3, 35.264), (1, 1, 13.263)],
)
def test_corners_of_a_moore_neighbourhood_have_a_limit_of_their_own(corner_limit, slabs, effective):
    parameters = SlabParameters(repose_angle=33.7, neighbourhood="moore", corner_limit=corner_limit)
    assert parameters.corner_step_limit(THIRD) == slabs
    assert parameters.effective_angles(THIRD)[1] == pytest.approx(effective, abs=1e-3)


@given(angles, aspects)
def test_the_limit_is_the_steepest_whole_number_of_slabs_within_the_angle_of_repose(angle, aspect):
    limit = SlabParameters(repose_angle=angle).face_limit(Lattice(slab_aspect=aspect))
    steepest = math.tan(math.radians(angle)) + 1e-6 * aspect
    assert limit >= 1
    assert limit == 1 or limit * aspect <= steepest
    assert (limit + 1) * aspect > steepest - 2e-6 * aspect


@given(angles, aspects)
def test_testing_before_the_move_lets_a_slope_stand_one_slab_steeper(angle, aspect):
    lattice = Lattice(slab_aspect=aspect)
    before = SlabParameters(repose_angle=angle, repose_test="before")
    after = SlabParameters(repose_angle=angle, repose_test="after")
    assert before.face_limit(lattice) == after.face_limit(lattice) + 1
    assert before.corner_step_limit(lattice) == after.corner_step_limit(lattice) + 1


@given(angles, aspects)
def test_a_geometric_corner_holds_the_angle_of_repose_over_its_longer_distance(angle, aspect):
    parameters = SlabParameters(repose_angle=angle, corner_limit="geometric")
    limit = parameters.corner_step_limit(Lattice(slab_aspect=aspect))
    assert limit == 1 or limit * aspect / math.sqrt(2) <= math.tan(math.radians(angle)) + 1e-6 * aspect
