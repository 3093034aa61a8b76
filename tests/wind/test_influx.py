"""What enters across open edges, and where a scenario may ask for it."""

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.simulation import Simulation
from barchan.wind.influx import CountedInflux, SaturatedInflux
from tests.tiny import tiny


def test_a_profile_is_a_straight_line_between_its_factors_from_the_south_end_on():
    influx = SaturatedInflux(share=0.5, profile=[0.0, 1.0])
    np.testing.assert_allclose(influx.along_edge(4), [0.125, 0.375, 0.625, 0.875])
    np.testing.assert_allclose(SaturatedInflux().along_edge(3), 1.0)
    np.testing.assert_allclose(SaturatedInflux(profile=[2.5]).along_edge(3), 2.5)


def test_saturated_influx_is_a_share_of_the_flux_and_counted_influx_is_not():
    assert SaturatedInflux(share=0.25).slabs_per_row(lambda: 8.0, 0.5) == 2.0
    assert CountedInflux(slabs_per_step=0.5).slabs_per_row(lambda: 8.0, 0.5) == 0.25


def test_influx_needs_an_open_edge_across_which_a_wind_blows_in():
    with pytest.raises(ScenarioError, match="no wind blows in across an open edge"):
        tiny(influx={"kind": "saturation"}, lattice__boundary_y="open")


def test_an_open_edge_from_upwind_without_influx_is_remarked():
    remarks = tiny(lattice__boundary_x="open").remarks()
    assert any("the west edge is open and nothing enters there" in remark for remark in remarks)
    both = tiny(lattice__boundary_x="open", lattice__boundary_y="open", wind__direction=45.0).remarks()
    assert any("the east and north edges are open" in remark for remark in both)
    fed = tiny(lattice__boundary_x="open", influx={"kind": "saturation", "share": 0.5}).remarks()
    assert not any("nothing enters" in remark for remark in [*fed, *tiny().remarks()])


def test_a_counted_influx_asks_for_no_saturated_flux_which_slabs_that_never_settle_do_not_have():
    simulation = Simulation(
        tiny(
            influx={"kind": "slabs", "slabs_per_step": 2.0},
            lattice__boundary_x="open",
            model__p_s=0.0,
            model__max_hops=20,
        )
    )
    simulation.advance(2)
    assert simulation.ledger.entered == 2 * 2 * simulation.lattice.rows


@pytest.mark.parametrize(
    ("influx", "words"),
    [
        (
            {"kind": "slabs", "slabs_per_step": 2.0, "profile": [1.0, -3.0]},
            "profile has a factor of -3; allowed: 0 and more",
        ),
        (
            {"kind": "slabs", "slabs_per_step": 500.0, "profile": [1.0, 2.5]},
            "slabs_per_step 500 times the greatest factor of profile, 2.5, is 1250; allowed: up to 1000",
        ),
        (
            {"kind": "saturation", "share": 8.0, "profile": [1.5]},
            "share 8 times the greatest factor of profile, 1.5, is 12; allowed: up to 10",
        ),
    ],
)
def test_a_profile_takes_nothing_out_and_keeps_within_the_bounds_of_what_it_multiplies(influx, words):
    with pytest.raises(ScenarioError, match=words):
        tiny(influx=influx, lattice__boundary_x="open")
