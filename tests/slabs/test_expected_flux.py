"""The flux field of slab models over beds where it follows from the rules by hand."""

import numpy as np
import pytest

import barchan
from barchan.analysis.fields import field_of
from barchan.bed import Bed
from barchan.simulation import Simulation
from barchan.slabs.expected_flux import expected_flux
from tests.tiny import tiny

HOP, P_S, P_NS = 3.0, 0.6, 0.4


def over(stacks, direction=270.0, lattice=(), **model):
    """The flux in slabs times cells per step over stacks of slabs on a level floor."""
    rows, columns = stacks.shape
    keys = {"name": "werner", "hop_length": HOP, "p_s": P_S, "p_ns": P_NS, **model}
    scenario = tiny(
        lattice__rows=rows,
        lattice__columns=columns,
        wind={"kind": "steady", "direction": direction},
        model=keys,
        **dict(lattice),
    )
    wind = scenario.forcing().wind_of(0)
    bed = Bed(scenario.lattice, np.zeros(stacks.shape), stacks.astype(np.int32))
    unit = scenario.lattice.thickness * scenario.lattice.cell_size
    return expected_flux(scenario.new_model(), bed, wind) / unit


@pytest.mark.parametrize("direction", [0.0, 37.0, 90.0, 225.0, 270.0])
@pytest.mark.parametrize("kind", ["square", "hex"])
def test_over_level_sand_it_is_a_hop_over_the_chance_to_settle(direction, kind):
    """A slab hops 1 / p_s times on the average, and each cell is polled once a step."""
    flux = over(np.full((16, 24), 9), direction, {"lattice__kind": kind})
    np.testing.assert_allclose(flux.mean(), HOP / P_S, rtol=1e-3)


def test_a_slab_alone_on_bare_ground_hops_on_with_the_chance_not_to_settle():
    stacks = np.zeros((4, 30))
    stacks[2, 5] = 1
    flux = over(stacks, lattice={"lattice__boundary_x": "open"})
    expected = np.zeros((4, 30))
    lit = [8, 11, 14, 17, 20, 23, 26, 29]  # each a hop on; the first lies beyond the shadow of one slab
    expected[2, 5] = HOP
    expected[2, lit] = HOP * (1 - P_NS) ** np.arange(1, 9)
    np.testing.assert_allclose(flux, expected, atol=1e-3)


def test_slabs_that_land_in_shadow_stay_and_sand_there_gives_none():
    """A wall of 9 slabs, 3 cells high, shadows more than 11 cells at 15 degrees: 3 / tan 15° = 11.2."""
    stacks = np.full((3, 40), 1)
    stacks[:, 10] = 10
    flux = over(stacks, lee_erosion=False)
    assert (flux[:, 11:21] == 0.0).all()
    assert (flux[:, 10] > 0.0).all()
    assert (flux[:, 30] > 0.0).all()


def test_it_turns_with_bed_and_wind():
    """A quarter turn anticlockwise, seen from above: a wind from the west becomes one from the south."""
    stacks = np.full((12, 12), 1)
    stacks[3, 4], stacks[8, 2] = 6, 9
    west = over(stacks, 270.0)
    south = over(np.rot90(stacks, 1, axes=(1, 0)).copy(), 180.0)
    np.testing.assert_allclose(np.rot90(south, -1, axes=(1, 0)), west, atol=1e-12)


def test_forced_erosion_gives_a_slab_a_poll():
    """Half the rows are bare: polls that meet them look on, so that sand is taken up twice as often."""
    stacks = np.zeros((10, 20))
    stacks[::2] = 9
    plain, forced = over(stacks), over(stacks, forced_erosion=True)
    np.testing.assert_allclose(forced, 2.0 * plain, rtol=1e-12)


@pytest.mark.extended
def test_its_mean_is_the_flux_of_the_next_step():
    """Over dunes, against the way that slabs really went: the mean of 8 seeds has an error of about 1 %."""
    expected, found = [], []
    for seed in range(8):
        scenario = tiny(lattice__rows=48, lattice__columns=64, run__seed=seed, run__steps=100)
        simulation = Simulation(scenario)
        simulation.advance(60)
        flux = expected_flux(simulation.model, simulation.bed, scenario.forcing().wind_of(60))
        expected.append(flux.mean())
        lattice = scenario.lattice
        travel = simulation.advance(1).travel_x
        found.append(travel / lattice.cells * lattice.thickness * lattice.cell_size)
    assert np.mean(expected) == pytest.approx(np.mean(found), rel=0.05)


def test_it_is_a_field_of_every_frame_in_map_and_file():
    run = barchan.simulate(tiny())
    scenario = tiny()
    flux = field_of(run.isel(step=-1), scenario, "flux")
    assert flux.attrs["unit"] == "m²/step"
    assert flux.attrs["along_wind"] == 1
    assert float(flux.mean()) > 0.0
