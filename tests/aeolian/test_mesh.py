"""Means over mesh cells, at joined and at open edges."""

import numpy as np
import pytest

from barchan.aeolian.mesh import following, over_mesh

VALUES = np.array([[0.0, 4.0, 8.0], [12.0, 16.0, 20.0]])


@pytest.mark.parametrize(("joined", "last"), [(True, [0.0, 12.0]), (False, [8.0, 20.0])])
def test_what_follows_the_last_value_depends_on_the_edge(joined, last):
    found = following(VALUES, 1, joined)
    np.testing.assert_array_equal(found[:, :2], VALUES[:, 1:])
    np.testing.assert_array_equal(found[:, 2], last)


def test_a_mesh_cell_has_the_mean_of_its_four_stacks():
    np.testing.assert_array_equal(over_mesh(VALUES, (True, True)), [[8.0, 12.0, 10.0], [8.0, 12.0, 10.0]])
    np.testing.assert_array_equal(over_mesh(VALUES, (False, False)), [[8.0, 12.0, 14.0], [14.0, 18.0, 20.0]])
