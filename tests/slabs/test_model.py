"""The facts and remarks of a slab model about a choice of parameters."""

import pytest

from barchan.lattice import Lattice
from barchan.models.werner import Werner, WernerParameters

LATTICE = Lattice(rows=16, columns=24)


def remarks(hop_length, direction, speed=None):
    return Werner(WernerParameters(hop_length=hop_length), LATTICE).remarks(speed, direction)


@pytest.mark.parametrize(("direction", "longest"), [(270.0, 12), (90.0, 12), (0.0, 8), (180.0, 8)])
def test_a_hop_longer_than_half_the_field_along_the_wind_warns(direction, longest):
    assert remarks(longest, direction) == []
    (remark,) = remarks(longest + 0.5, direction)
    assert f"{longest + 0.5:g} cells" in remark
    assert f"({2 * longest} cells)" in remark


def test_a_wind_that_states_its_speed_is_the_one_that_counts():
    assert remarks(20, 270.0, speed=5) == []
    assert len(remarks(5, 270.0, speed=20)) == 1


def test_the_facts_state_the_angles_that_slabs_really_hold():
    facts = Werner(WernerParameters(neighbourhood="moore", corner_limit=3), LATTICE).facts()
    assert facts == {
        "shadow from": "centre (auto: all winds blow along axes)",
        "neighbour order": "wind (auto: all winds blow along axes)",
        "effective repose angle": "33.7° towards faces (2 slabs), 43.3° towards corners (4 slabs)",
    }
