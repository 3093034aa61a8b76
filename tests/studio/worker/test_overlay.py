"""A terrain from a file beside the surface: on the run's lattice, and the difference from it."""

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.studio.worker.frame_sender import FrameSender
from barchan.studio.worker.overlay import ABOVE, OVERLAY, read_overlay
from barchan.studio.worker.run import started
from tests.studio.conftest import small
from tests.studio.frames import read_frame

FLAT = {"ground": {"kind": "flat"}, "sand": {"kind": "flat", "mean": 3}}


def plane(folder, rows=32, columns=48):
    """A file of heights that rise by 0.1 m a cell to the east and by 1 m a cell to the north."""
    path = folder / "plane.npy"
    np.save(path, np.arange(rows)[:, None] + 0.1 * np.arange(columns)[None, :])
    return str(path)


def sent(run, overlay, *fields):
    frames = []
    sender = FrameSender("a", frames.append)
    sender.attach()
    sender.overlay = overlay
    sender.fields = list(fields)
    sender.send(run)
    return {name: values.reshape(32, 48) for name, values in read_frame(frames[-1])[1].items()}


def test_frames_carry_the_overlay_and_what_the_surface_lies_above_it(tmp_path):
    """Three slabs of a third of a metre lie 1 m high everywhere."""
    run = started(small(**FLAT))
    overlay = read_overlay({"path": plane(tmp_path)}, run.live.lattice)
    fields = sent(run, overlay, OVERLAY, ABOVE)
    rows, columns = np.indices((32, 48))
    assert np.allclose(fields[OVERLAY], rows + 0.1 * columns, atol=1e-3)
    assert np.allclose(fields[ABOVE], 1.0 - rows - 0.1 * columns, atol=1e-3)


def test_a_levelled_overlay_differs_by_its_form_alone(tmp_path):
    """The mean of 0 to 31 is 15.5, that of 0 to 4.7 is 2.35."""
    run = started(small(**FLAT))
    overlay = read_overlay({"path": plane(tmp_path), "level": True}, run.live.lattice)
    rows, columns = np.indices((32, 48))
    assert np.allclose(sent(run, overlay, ABOVE)[ABOVE], 17.85 - rows - 0.1 * columns, atol=1e-3)


def test_an_overlay_without_cells_is_stretched_over_the_field(tmp_path):
    """Its mean stays: 7.5 of rows 0 to 15, and 1.15 of columns 0 to 2.3."""
    run = started(small(**FLAT))
    overlay = read_overlay({"path": plane(tmp_path, 16, 24)}, run.live.lattice)
    assert overlay.heights.shape == (32, 48)
    assert overlay.heights.mean() == pytest.approx(7.5 + 1.15, abs=1e-6)


def test_an_overlay_is_left_out_where_the_run_has_another_lattice(tmp_path):
    overlay = read_overlay({"path": plane(tmp_path)}, started(small(**FLAT)).live.lattice)
    assert overlay.fits(started(small(**FLAT)).live)
    assert not overlay.fits(started(small(**FLAT, lattice={"rows": 24, "columns": 48})).live)


@pytest.mark.parametrize(
    ("request_", "said"),
    [
        ({"path": "none.npy"}, "no such file"),
        ({"path": 5}, "path"),
        ({"path": "x.npy", "lowest": "a"}, "lowest"),
    ],
)
def test_what_cannot_be_read_is_refused_under_its_key(request_, said):
    with pytest.raises(ScenarioError, match=said):
        read_overlay(request_, small().lattice)
