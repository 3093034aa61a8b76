"""The light of the studio's scene: where the sun stands, the colour of shadows, the look of plants."""

import json

import numpy as np
import pytest

from barchan.scenario import load_scenario
from barchan.studio.pictures import rendered

pytestmark = pytest.mark.extended

RUN = "window.barchan.app.runs[0]"
TUFTS = f"window.barchan.stage.terrain({RUN}).plants.mesh.visible"


def begin(studio, preset, *changes):
    scenario = load_scenario(preset, list(changes)).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    studio.until(f"{RUN}.ready && {RUN}.description.scenario.title === {json.dumps(scenario['title'])}")
    studio.picture()


def seen_from(studio, viewpoint):
    """The middle of the scene, as it is drawn where a graphics card has time for all of the light."""
    studio.ask(f"window.barchan.stage.look('{viewpoint}')")
    picture = np.asarray(rendered(studio.page, 240, 160).convert("RGB")).astype(float)
    return picture[30:-30, 60:-60].reshape(-1, 3)


@pytest.mark.parametrize("wind", [270, 0, 225])
def test_the_sun_stands_across_the_crests_that_the_wind_makes(studio, wind):
    begin(
        studio, "barchans", ("lattice.rows", "32"), ("lattice.columns", "32"), ("wind.direction", str(wind))
    )
    azimuth = studio.ask("window.barchan.stage.sun().azimuth")
    # crests lie across the wind, so that light along it falls across them
    assert abs(np.cos(np.radians(azimuth - wind))) > np.cos(np.radians(45))


def test_shadows_are_lit_by_the_sky(studio):
    begin(studio, "three-rocks", ("sand.mean", "0"))
    studio.ask("window.barchan.app.view.set({ sunHeight: 20, bare: false })")
    pixels = seen_from(studio, "top")
    bright = pixels.sum(axis=1)
    middle = np.median(bright)
    # the darkest are walls that face away from the sun
    lit, shadow = (
        np.median(pixels[some], axis=0)
        for some in (bright > 0.9 * middle, (bright > 0.4 * middle) & (bright < 0.7 * middle))
    )
    assert shadow.min() > 30
    # in light itself, which grows about as the 2.2th power of the numbers of a picture
    assert (shadow[2] / shadow[0]) ** 2.2 > 1.2 * (lit[2] / lit[0]) ** 2.2


def test_tufts_stand_in_natural_colours_only(studio):
    scenario = load_scenario(
        "nebkhas", [("lattice.rows", "32"), ("lattice.columns", "48"), ("run.seed", "3")]
    )
    studio.ask(f"window.barchan.app.create({json.dumps(scenario.data())}, true)")
    share = f"{RUN}.fields.get('effectiveness')"
    grown = f"{share}?.filter((one) => one > 0.5).length > 0.2 * {share}?.length"
    studio.until(f"{RUN}.description.scenario.title.startsWith('Nebkhas') && {grown}")
    studio.pause()
    show(studio, "natural", "effectiveness")
    planted = seen_from(studio, "oblique")
    assert studio.ask(TUFTS)
    show(studio, "slope", "effectiveness")
    assert not studio.ask(TUFTS)
    show(studio, "natural")
    bare = seen_from(studio, "oblique")
    changed = np.abs(planted - bare).max(axis=1) > 20
    assert np.mean(changed) > 0.02
    green, sand = ((some[:, 1] / some[:, 0])[changed].mean() for some in (planted, bare))
    assert green > sand


def show(studio, field, *overlays):
    look = {"field": field, "map": "grey", "overlays": overlays}
    studio.ask(f"window.barchan.app.view.set({json.dumps(look)})")
    studio.picture()


def test_the_sun_that_was_there_comes_back_with_the_run_that_is_alone_again(studio):
    begin(studio, "barchans", ("lattice.rows", "32"), ("lattice.columns", "32"), ("run.save_every", "5"))
    studio.ask("window.barchan.app.send({ command: 'run', until: 10 })")
    studio.until(f"{RUN}.status.step === 10 && !window.barchan.app.running")
    studio.ask("window.barchan.app.ask({ command: 'wind', wind: { kind: 'steady', direction: 0 } })")
    studio.until(f"{RUN}.status.wind === 0")
    studio.ask("window.barchan.app.send({ command: 'run', until: 20 })")
    studio.until(f"{RUN}.status.step === 20 && !window.barchan.app.running")
    studio.picture()
    before = studio.ask("window.barchan.stage.sun()")
    studio.ask("window.barchan.app.ask({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].ready")
    studio.picture()
    studio.ask("window.barchan.app.ask({ command: 'alone' })")
    studio.until(f"window.barchan.app.runs.length === 1 && {RUN}.status.step === 20")
    studio.picture()
    assert studio.ask("window.barchan.stage.sun()") == before
