"""The layers along a section, as the browser gets them."""

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.studio.worker.strata import layers_along
from tests.snow.scenes import snow

OLDER = [{"mass": 4.0, "density": 250.0, "age": 24.0}, {"mass": 2.0, "density": 400.0, "age": 288.0}]
LINE = [0.0, 1.65, 4.8, 1.65]


@pytest.fixture(scope="module")
def simulation():
    return snow(mean=3, beneath=OLDER, start_density=100.0, start_age=0.0)


@pytest.mark.parametrize(
    ("by", "values"),
    [("density", [250.0, 400.0, 100.0]), ("age", [24.0, 288.0, 0.0]), ("state", [1.0, 1.0, 0.0])],
)
def test_layers_lie_from_the_ground_up_with_their_values(simulation, by, values):
    """4, 2 and 3 kg/m² of 250, 400 and 100 kg/m³ are 16, 5 and 30 mm thick; bonded from 3 h on."""
    found = layers_along(simulation, LINE, by)
    np.testing.assert_allclose(np.array(found["thickness"])[:, 7], [0.016, 0.005, 0.03])
    assert [row[7] for row in found["values"]] == values
    np.testing.assert_allclose(found["place"], np.arange(49) * 0.1, atol=1e-9)


def test_a_section_across_cells_ends_where_the_line_ends(simulation):
    found = layers_along(simulation, [0.3, 0.2, 3.9, 2.9], "age")
    assert found["place"][0] == 0.0
    assert found["place"][-1] == pytest.approx(4.5)
    assert len(found["ground"]) == len(found["place"]) - 1


def test_what_no_section_shows_is_refused(simulation):
    with pytest.raises(BarchanError, match="no layers by 'hardness'; allowed: age, density, state"):
        layers_along(simulation, LINE, "hardness")
    with pytest.raises(BarchanError, match="two places"):
        layers_along(simulation, [0.0, 1.0], "age")
