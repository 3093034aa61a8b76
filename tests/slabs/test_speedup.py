"""Hops that grow with height, as Momiji's and Bishop's papers have them."""

import numpy as np
import pytest

import barchan
from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.measures import streamwise_slopes
from barchan.models.bishop import Bishop
from barchan.models.momiji import Momiji
from barchan.streams import Stream
from barchan.wind.segment import Segment

FREE = {"shadow_angle": 89.0, "repose_angle": 89.0}
"""Neither shelter nor avalanches."""


def on(model, sand, **parameters):
    lattice = Lattice(rows=sand.shape[0], columns=sand.shape[1])
    return model(model.Parameters(**parameters), lattice), Bed(lattice, np.zeros(sand.shape), sand)


def test_momijis_hops_are_those_of_the_paper():
    sand = np.array([[0, 10, 20, 50, 20, 20, 20, 20]])
    model, bed = on(Momiji, sand)
    assert model.reference_height(bed) == 20.0
    expected = [5 - 8, 5 - 4, 5, 5 + 12 + 0.002 * 900, 5, 5, 5, 5]
    np.testing.assert_allclose(model.hops(bed, 5.0)[0], expected)


def test_bishops_reference_follows_the_relief():
    sand = np.array([[0, 40, 0, 40, 0, 40, 0, 40]])
    model, bed = on(Bishop, sand)
    assert model.reference_height(bed) == 20.0 - 0.5 * 20.0


def test_hops_are_zero_twelve_and_a_half_slabs_below_the_reference():
    model, bed = on(Momiji, np.array([[0, 25] * 4]))
    np.testing.assert_allclose(model.hops(bed, 5.0)[0], [0.0, 10.0 + 0.002 * 12.5**2] * 4)


def flown(sand, **parameters):
    """Mean travel of slabs for one step of polls, and how many moved."""
    model, bed = on(Momiji, sand, p_s=1.0, p_ns=1.0, lee_erosion=True, **FREE, **parameters)
    segment = Segment(0, 1, 0, bed.sand.size, 270.0)
    tally = model.advance(bed, segment, Stream(1, "transport"))
    return tally.travel_x / max(tally.moved, 1), tally.moved


@pytest.mark.parametrize(("hop", "rounded"), [(4.4, 4.0), (4.5, 5.0), (4.6, 5.0)])
def test_hops_are_rounded_to_whole_cells_halves_up(hop, rounded):
    flat = np.full((20, 100), 50)
    still = {"speedup_linear": 0.0, "speedup_quadratic": 0.0}
    assert flown(flat, hop_length=hop, **still)[0] == rounded
    exact, _ = flown(flat, hop_length=hop, hop_rounding="none", **still)
    assert exact == pytest.approx(hop, abs=1e-4)


def test_a_cell_whose_hop_rounds_to_zero_gives_no_slab():
    short = {"hop_length": 0.4, "speedup_linear": 0.0, "speedup_quadratic": 0.0}
    assert flown(np.full((20, 100), 50), **short)[1] == 0
    assert flown(np.full((20, 100), 50), **short, hop_rounding="none")[1] == 2000


def test_deep_troughs_send_sand_against_the_wind():
    sand = np.full((4, 64), 100)
    sand[:, 32] = 40
    model, bed = on(Momiji, sand, p_s=1.0, p_ns=1.0, lee_erosion=True, repose_angle=89.0, shadow_angle=89.0)
    assert (model.hops(bed, 5.0)[:, 32] < 0).all()
    before = bed.sand.copy()
    model.advance(bed, Segment(0, 20, 0, bed.sand.size, 270.0), Stream(3, "transport"))
    assert bed.units == before.sum()


def test_no_hop_is_longer_than_the_field():
    sand = np.zeros((2, 16), int)
    sand[:, 8] = 5000
    assert abs(flown(sand)[0]) <= 16


def test_windward_slopes_are_gentler_than_werners():
    lattice = {"lattice__rows": 32, "lattice__columns": 256, "run__steps": 400}
    common = {"repose_angle": 33.7, "repose_test": "after", "lee_erosion": False}
    slopes = {}
    for name in ("werner", "momiji"):
        scenario = barchan.load("transverse", model={"name": name, **common}, run__seed=1, **lattice)
        slopes[name] = streamwise_slopes(
            barchan.simulate(scenario)["elevation"].values[-1], 1.0, 270.0
        ).windward
    assert slopes["momiji"] < slopes["werner"]


def test_slabs_land_where_their_tallied_travel_ends_also_after_a_whole_first_hop():
    """Slabs that start with a hop of whole cells may go on with hops that are not."""
    moved, tallied = 0.0, 0.0
    for seed in range(8):
        sand = np.zeros((32, 256), int)
        sand[:, 8:40] = 8
        lattice = Lattice(rows=32, columns=256, boundary_x="open")
        parameters = Momiji.Parameters(
            hop_length=5.9,
            speedup_linear=0.3,
            speedup_quadratic=0.0,
            hop_rounding="none",
            p_s=0.0,
            p_ns=0.0,
            max_hops=4,
            lee_erosion=True,
            polling="non_repeated",
            **FREE,
        )
        bed = Bed(lattice, np.zeros(sand.shape), sand)
        tally = Momiji(parameters, lattice).advance(
            bed, Segment(0, 1, 0, bed.sand.size, 270.0), Stream(seed, "transport")
        )
        moved += ((bed.sand - sand).sum(axis=0) * np.arange(256)).sum()
        tallied += tally.travel_x
    assert moved == pytest.approx(tallied, rel=0.003)
