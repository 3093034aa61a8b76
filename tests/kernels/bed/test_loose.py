"""Loose parcels by age against a list of the ages of all parcels of a cell."""

import numpy as np
import pytest

from barchan.kernels.bed.loose import change_loose, follow, join, part_loose, slide_loose
from barchan.kernels.bed.state import AGES


class Pile:
    """Cells as lists of the age of each parcel; ``AGES`` for those that have bonded."""

    def __init__(self, ages):
        self.cells = [sorted(one) for one in ages]

    def change(self, cell, parcels):
        if parcels > 0:
            self.cells[cell] = [0] * parcels + self.cells[cell]
        else:
            del self.cells[cell][:-parcels]

    def slide(self, cell, other, parcels):
        self.change(cell, -parcels)
        self.change(other, parcels)

    def loose(self):
        return [[cell.count(age) for age in range(AGES)] for cell in self.cells]

    def free(self, cell):
        return sum(age < AGES for age in self.cells[cell])


@pytest.fixture
def pile():
    random = np.random.default_rng(5)
    return Pile([random.integers(0, AGES + 1, random.integers(0, 12)).tolist() for _ in range(30)])


def arrays(pile):
    return np.array(pile.loose(), np.int32), np.array([len(cell) for cell in pile.cells], np.int32)


def test_the_youngest_leave_first_and_what_comes_is_young(pile):
    loose, _ = arrays(pile)
    random = np.random.default_rng(6)
    for _ in range(400):
        cell, other = random.choice(30, 2, replace=False)
        parcels = int(random.integers(0, len(pile.cells[cell]) + 1))
        if random.random() < 0.4:
            parcels = min(parcels, pile.free(cell))
            pile.slide(cell, other, parcels)
            slide_loose(loose, cell, other, parcels)
        elif random.random() < 0.5:
            pile.change(cell, -parcels)
            change_loose(loose, cell, -parcels)
        else:
            pile.change(cell, 3)
            change_loose(loose, cell, 3)
        assert loose.tolist() == pile.loose()


def test_bonded_parcels_stay_where_the_loose_ones_slide(pile):
    loose, sand = arrays(pile)
    whole = sand.copy()
    free = part_loose(loose, sand)
    assert free.tolist() == [pile.free(cell) for cell in range(30)]
    assert np.array_equal(sand + free, whole)
    join(loose, free, sand)
    assert np.array_equal(sand, whole)


def test_sand_is_all_free_and_stays_in_one_array():
    sand = np.array([3, 0, 2], np.int32)
    assert part_loose(None, sand) is sand or np.shares_memory(part_loose(None, sand), sand)


def test_a_brush_lays_young_snow_and_takes_young_snow_first(pile):
    loose, sand = arrays(pile)
    bonded = (sand - loose.sum(axis=1)).astype(np.int32)
    random = np.random.default_rng(7)
    change = np.maximum(random.integers(-6, 7, 30), -sand)
    for cell in range(30):
        pile.change(cell, int(change[cell]))
    follow(loose, bonded, (sand + change).astype(np.int32))
    assert loose.tolist() == pile.loose()
