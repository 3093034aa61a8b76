"""A checkpoint is the complete state, in one file that is good or refused."""

import gc
import json
import warnings
from contextlib import suppress

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from barchan.archive import resume, run_info
from barchan.archive.checkpoint import read_checkpoint, write_checkpoint
from barchan.errors import ArchiveError, BarchanError
from barchan.simulation import Simulation, State
from tests.tiny import tiny

per_example = settings(suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture
def checkpoint(tmp_path):
    """A file, its bytes and the state it holds."""
    simulation = Simulation(tiny())
    simulation.advance(3)
    path = tmp_path / "checkpoint.npz"
    write_checkpoint(path, simulation.state())
    return path, path.read_bytes(), simulation.state()


def equal(one, other):
    """Whether two states are the same."""
    arrays = one.arrays.keys() == other.arrays.keys() and all(
        np.array_equal(array, other.arrays[name]) for name, array in one.arrays.items()
    )
    return arrays and json.dumps(one.data) == json.dumps(other.data)


def test_a_state_survives_the_disk(checkpoint):
    path, _, state = checkpoint
    assert equal(read_checkpoint(path), state)


def test_a_state_with_numbers_that_are_none_survives_the_disk(tmp_path):
    state = State({"step": 1, "seen": [[float("nan"), 1.0]]}, {"bed/sand": np.zeros((1, 8), np.int32)})
    write_checkpoint(tmp_path / "c.npz", state)
    assert np.isnan(read_checkpoint(tmp_path / "c.npz").data["seen"][0][0])


def test_the_older_checkpoint_stays_whole_until_the_new_one_is(monkeypatch, checkpoint):
    path, before, state = checkpoint

    def fail(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("numpy.savez", fail)
    with pytest.raises(OSError, match="No space left"):
        write_checkpoint(path, state)
    assert path.read_bytes() == before


def test_no_checkpoint_is_a_clear_error(tmp_path):
    with pytest.raises(ArchiveError, match="no checkpoint to resume from"):
        read_checkpoint(tmp_path / "checkpoint.npz")


@per_example
@given(share=st.floats(0.0001, 0.9999))
def test_a_checkpoint_that_was_cut_short_is_refused(checkpoint, share):
    path, whole, _ = checkpoint
    path.write_bytes(whole[: max(1, int(len(whole) * share))])
    with pytest.raises(ArchiveError, match="damaged checkpoint"):
        read_checkpoint(path)


def test_an_empty_checkpoint_is_refused(checkpoint):
    path, _, _ = checkpoint
    path.write_bytes(b"")
    with pytest.raises(ArchiveError, match="damaged checkpoint"):
        read_checkpoint(path)


def test_a_file_of_other_arrays_is_refused(checkpoint):
    path, _, _ = checkpoint
    np.savez(path, other=np.zeros(3))
    with pytest.raises(ArchiveError, match="damaged checkpoint"):
        read_checkpoint(path)


@per_example
@given(st.data())
def test_sand_that_was_damaged_is_found_out(checkpoint, data):
    path, whole, state = checkpoint
    start = whole.index(np.ascontiguousarray(state.arrays["bed/sand"]).tobytes())
    place = data.draw(st.integers(start, start + 16 * 24 * 4 - 1))
    path.write_bytes(whole[:place] + bytes([whole[place] ^ 0x10]) + whole[place + 1 :])
    with pytest.raises(ArchiveError, match="damaged checkpoint"):
        read_checkpoint(path)


def test_a_damaged_checkpoint_is_named_when_a_run_is_resumed(fresh):
    path = fresh / "checkpoint.npz"
    path.write_bytes(path.read_bytes()[:200])
    with pytest.raises(ArchiveError, match=f"{path}: damaged checkpoint"):
        resume(fresh)
    assert not (fresh / "writer.lock").exists()


def test_a_run_with_a_damaged_checkpoint_still_tells_what_it_holds(fresh):
    (fresh / "checkpoint.npz").write_bytes(b"PK nothing")
    assert run_info(fresh).frames == 5


def test_frames_of_a_run_with_a_damaged_checkpoint_can_be_read(fresh, whole, same_frames):
    (fresh / "checkpoint.npz").write_bytes(b"PK nothing")
    same_frames(whole, fresh)


def test_a_single_wrong_byte_is_refused_or_makes_no_difference(checkpoint):
    path, whole, state = checkpoint
    directory = whole.index(b"PK\x01\x02")
    wrong = {}
    for place in [*range(0, directory, 11), *range(directory, len(whole))]:
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 0xFF]) + whole[place + 1 :])
        try:
            if not equal(read_checkpoint(path), state):
                wrong[place] = "read as another state"
        except BarchanError:
            pass
        except Exception as error:
            wrong[place] = repr(error)
    assert wrong == {}


def test_a_damaged_checkpoint_is_not_left_open(checkpoint):
    path, whole, _ = checkpoint
    path.write_bytes(whole[:-10])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        with suppress(ArchiveError):
            read_checkpoint(path)
        gc.collect()
    assert [str(warning.message) for warning in caught] == []
