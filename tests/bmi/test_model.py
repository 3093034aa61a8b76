"""The Basic Model Interface: that of bmipy, and what the bmi-tester of CSDMS asks."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from barchan.bmi import BarchanBmi
from barchan.bmi.variables import AZIMUTH, ELEVATION, SPEED, THICKNESS
from barchan.errors import BarchanError
from barchan.scenario import validate
from barchan.simulation import Simulation
from tests.tiny import DATA


@pytest.fixture
def config(tmp_path):
    path = tmp_path / "tiny.json"
    path.write_text(json.dumps(DATA))
    return str(path)


@pytest.fixture
def model(config):
    started = BarchanBmi()
    started.initialize(config)
    return started


def read(model, name):
    return model.get_value(name, np.empty(model.get_grid_size(model.get_var_grid(name))))


def test_every_method_of_the_interface_is_there():
    from bmipy import Bmi

    wanted = Bmi.__abstractmethods__
    assert wanted
    assert {name for name in wanted if not callable(getattr(BarchanBmi, name, None))} == set()


def test_steps_behind_the_interface_are_those_of_a_simulation(model):
    alone = Simulation(validate(DATA))
    alone.advance(5)
    model.update()
    model.update_until(5.0)
    assert model.get_current_time() == 5.0
    assert np.array_equal(read(model, ELEVATION).reshape(alone.elevation.shape), alone.elevation)


def test_a_pointer_follows_the_surface(model):
    surface = model.get_value_ptr(ELEVATION)
    before = surface.copy()
    model.update()
    assert surface is model.get_value_ptr(ELEVATION)
    assert not np.array_equal(surface, before)
    assert np.array_equal(surface, read(model, ELEVATION))


def test_sand_that_is_set_is_laid_in_whole_slabs_and_counted(model):
    """A cell of one slab and a third more than before: one slab enters, on a bed that stays at rest."""
    simulation = model.simulation
    slab = simulation.lattice.thickness
    cell = int(np.argmin(simulation.bed.top))
    depth = read(model, THICKNESS)
    units = simulation.bed.units
    model.set_value_at_indices(THICKNESS, np.array([cell]), np.array([depth[cell] + 1.3 * slab]))
    assert simulation.bed.units == units + 1 == simulation.ledger.initial + 1
    assert simulation.ledger.entered == 1


def test_a_steady_wind_can_be_turned(model):
    model.set_value(AZIMUTH, np.array([225.0]))
    assert read(model, AZIMUTH)[0] == 225.0
    assert SPEED not in model.get_output_var_names()


@pytest.mark.parametrize(
    ("act", "said"),
    [
        (lambda m: m.update_until(2.5), "update_until\\(2.5\\): allowed: 0 and later, in whole steps"),
        (lambda m: m.set_value(ELEVATION, 0), "cannot be set; what can"),
        (lambda m: m.set_value(THICKNESS, np.ones(3)), "3 values; allowed"),
        (lambda m: m.get_var_units("height"), "no variable 'height'; known"),
        (lambda m: m.get_grid_rank(7), "no grid 7"),
        (lambda m: m.finalize() or m.update(), "not initialized"),
    ],
)
def test_what_makes_no_sense_is_refused(model, act, said):
    with pytest.raises(BarchanError, match=said):
        act(model)


def test_the_tester_of_csdms_finds_no_fault(tmp_path, config):
    tester = shutil.which("bmi-test", path=str(Path(sys.executable).parent))
    assert tester is not None
    command = [tester, "barchan.bmi:BarchanBmi", f"--config-file={config}", f"--root-dir={tmp_path}"]
    environment = {**os.environ, "NO_COLOR": "1"}
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment, check=False)
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
