"""Growth curves, and where plants stand at first."""

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.lattice import Lattice
from barchan.models.nield_baas import NieldBaas
from barchan.plants.layouts import Blowouts, Islands, MappedPlants, UniformPlants
from barchan.plants.species import Shrub
from barchan.simulation import Simulation
from barchan.streams import Stream
from tests.tiny import COLUMNS, ROWS, tiny

LATTICE = Lattice(rows=100, columns=100)
STREAM = Stream(3, "vegetation")


@pytest.mark.parametrize(
    ("balance", "change"),
    [(-9.0, -1.0), (-1.4, -1.0), (0.1, 0.0), (0.275, 0.2), (0.45, 0.4), (0.85, 0.0), (9.0, -1.0)],
)
def test_grass_grows_as_its_curve_says(balance, change):
    grass = NieldBaas.Parameters().grass
    assert grass.growth(np.array([balance]))[0] == pytest.approx(change)


def test_effectiveness_stays_within_its_range():
    shrub = NieldBaas.Parameters().shrub
    cover = np.array([1.5, -0.5, 0.0])
    np.testing.assert_allclose(shrub.grown(cover, np.array([0.0, -9.0, 0.0])), [1.5, -0.5, 0.1])


def curve(*balances):
    return {"lowest": 0.0, "highest": 1.0, "curve": [{"balance": b, "change": 0.0} for b in balances]}


@pytest.mark.parametrize(
    ("species", "said"),
    [
        (curve(0.0, 0.0), {"curve[1].balance": "is 0.0 after 0.0; allowed: balances that increase"}),
        (
            {**curve(0.0, 1.0, 0.5, 2.0, 2.0), "lowest": 2.0},
            {
                "curve[2].balance": "is 0.5 after 1.0; allowed: balances that increase",
                "curve[4].balance": "is 2.0 after 2.0; allowed: balances that increase",
                "lowest": "is 2.0, above highest 1.0",
            },
        ),
        ({"lowest": 4.0}, {"lowest": "is 4.0, above highest 1.0"}),
        (curve(0.0), {"curve": 'is [{"balance": 0.0, "change": 0.0}]; allowed: list of group { … }'}),
    ],
)
def test_every_mistake_of_a_species_is_reported_on_its_own_key(species, said):
    with pytest.raises(ScenarioError) as caught:
        tiny(model={"name": "nield_baas", "grass": species})
    found = {problem.key: problem.message for problem in caught.value.problems}
    assert set(found) == {f"model.grass.{key}" for key in said}
    for key, message in said.items():
        assert found[f"model.grass.{key}"].startswith(message)


def test_keys_of_one_species_change_singly():
    shrub = tiny(model={"name": "nield_baas"}, model__shrub__highest=0.5).model.shrub
    assert shrub == Shrub(highest=0.5)
    assert (shrub.lowest, shrub.curve) == (-0.5, Shrub().curve)


def test_blowouts_are_bare_patches_of_their_size():
    cover = Blowouts(kind="blowouts", grass=0.2, shrub=0.9).cover(LATTICE, STREAM)
    bare = cover["shrub"] == 0
    assert bare.sum() == 3 * 5 * 6
    assert (cover["grass"][~bare] == 0.2).all()
    rows, cols = np.nonzero(bare)
    assert np.ptp(cols) + 1 == 6
    assert len(np.unique(rows)) == 15


def test_islands_are_the_only_plants():
    cover = Islands(kind="islands", mesquite=0.4).cover(LATTICE, STREAM)
    assert 0 < (cover["mesquite"] == 0.4).mean() < 0.5
    assert (cover["grass"] == 0).all()


def test_randomised_plants_have_a_random_share_that_the_seed_decides():
    plants = UniformPlants(kind="uniform", shrub=0.8, randomised=True)
    first, again = (plants.cover(LATTICE, STREAM)["shrub"] for _ in range(2))
    np.testing.assert_array_equal(first, again)
    assert first.min() >= 0
    assert first.max() <= 0.8
    assert first.mean() == pytest.approx(0.4, abs=0.02)
    assert (plants.cover(LATTICE, Stream(4, "vegetation"))["shrub"] != first).any()


def test_plants_are_mapped_from_an_array(tmp_path):
    share = np.zeros((ROWS, COLUMNS))
    share[2, 5] = 0.5
    np.save(tmp_path / "plants.npy", share)
    plants = {"kind": "file", "path": str(tmp_path / "plants.npy"), "grass": 0.8}
    simulation = Simulation(tiny(model={"name": "nield_baas", "vegetation": plants}))
    np.testing.assert_array_equal(simulation.bed.arrays["grass"], 0.8 * share)


@pytest.mark.parametrize(
    ("array", "said"),
    [
        (np.zeros((3, 4)), r"has \(3, 4\) rows and columns; allowed: the lattice's \(100, 100\)"),
        (np.full((100, 100), np.nan), "10000 cells without a value"),
    ],
)
def test_a_map_that_does_not_fit_is_refused(tmp_path, array, said):
    np.save(tmp_path / "plants.npy", array)
    with pytest.raises(ScenarioError, match=said):
        MappedPlants(kind="file", path=str(tmp_path / "plants.npy")).cover(LATTICE, STREAM)


def test_a_map_that_is_not_there_is_refused():
    with pytest.raises(ScenarioError, match=r"model\.vegetation\.path"):
        MappedPlants(kind="file", path="nowhere.npy").cover(LATTICE, STREAM)
