"""What models lay over the surface: the more of it, the darker."""

import numpy as np
import pytest
from matplotlib.colors import Normalize

from barchan.entry import simulate
from barchan.figures.film import film
from barchan.figures.layers import layer_map, layers_of
from barchan.figures.maps import relief_map, shaded
from tests.tiny import ROWS, tiny

PLANTS = {"model": {"name": "nield_baas"}, "sand": {"kind": "flat", "mean": 3}, "run__steps": 0}
SCALE = {"norm": Normalize(0, 2), "colours": "grey"}


@pytest.fixture
def planted():
    """A level frame whose plants grow thicker from west to east, from less than none to more than all."""
    scenario = tiny(**PLANTS)
    frame = simulate(scenario).isel(step=-1)
    frame["grass"][...] = np.linspace(-0.5, 0.75, scenario.lattice.columns)
    frame["shrub"][...] = np.linspace(-0.5, 0.75, scenario.lattice.columns)
    return frame, scenario


def test_plants_are_green_and_where_there_are_none_nothing_is_drawn(planted):
    bare, green = (shaded(*planted, **SCALE, layers=layers) for layers in (False, True))
    cover = (planted[0]["grass"] + planted[0]["shrub"]).values
    np.testing.assert_allclose(green[cover <= 0], bare[cover <= 0])
    dense = green[cover > 0.2]
    assert (dense[:, 1] > dense[:, [0, 2]].max(axis=1)).all()


def test_the_more_plants_the_darker_until_they_cover_all(planted):
    brightness = shaded(*planted, **{**SCALE, "norm": Normalize(-100, 2)}).mean(axis=-1)[ROWS // 2]
    cover = (planted[0]["grass"] + planted[0]["shrub"]).values[0]
    growing = brightness[(cover > 0.25) & (cover < 1)]
    assert (np.diff(growing) < 0).all()
    assert np.ptp(brightness[cover >= 1]) < 1e-9


@pytest.mark.parametrize(
    ("layers", "bars"), [(True, ["plants", "elevation (m)"]), (False, ["elevation (m)"])]
)
def test_a_map_has_a_colour_bar_for_each_layer_it_shows(planted, layers, bars):
    _, *found = relief_map(*planted, layers=layers).axes
    assert [bar.get_ylabel() for bar in found] == bars


def test_a_model_without_layers_is_drawn_the_same_with_and_without(painted):
    frame, scenario = painted(3)
    assert layers_of(scenario) == ()
    np.testing.assert_array_equal(
        shaded(frame, scenario, **SCALE), shaded(frame, scenario, **SCALE, layers=False)
    )


def test_a_film_shows_plants_unless_told_not_to(tmp_path):
    from PIL import Image

    scenario = tiny(**PLANTS, model__vegetation={"kind": "uniform", "grass": 1.0})
    greenness = {}
    for layers in (True, False):
        film(simulate(scenario), scenario, tmp_path / "film.webp", pixels=48, layers=layers)
        with Image.open(tmp_path / "film.webp") as picture:
            red, green, _ = np.asarray(picture.convert("RGB"), float).mean(axis=(0, 1))
        greenness[layers] = green - red
    assert greenness[True] > 20 > greenness[False]


def test_the_colours_of_a_layer_go_from_light_to_dark():
    (layer,) = layers_of(tiny(**PLANTS))
    brightness = layer_map(layer)(np.linspace(0, 1, 50))[:, :3].mean(axis=1)
    assert (np.diff(brightness) < 0).all()
