"""The store of frames grows by whole frames, and can be cut back to a step."""

import numpy as np
import pytest
import zarr

from barchan.archive.frames import Frames, field_attributes
from barchan.fields import GROUND, SAND, FieldInfo
from barchan.simulation import Simulation
from tests.tiny import tiny


@pytest.fixture
def store(tmp_path):
    """An empty store and the frames of a run."""
    simulation = Simulation(tiny())
    frames = Frames.create(tmp_path / "frames.zarr", simulation.scenario, "{}", simulation.bed.declared)
    return frames, list(simulation)


def test_a_new_store_is_empty(store):
    frames, _ = store
    assert frames.count == 0
    assert sorted(frames.fields) == ["ground", "sand"]


def test_frames_are_counted_when_they_are_complete(store):
    frames, made = store
    for number, frame in enumerate(made, start=1):
        frames.append(frame)
        assert frames.count == number
    assert frames.steps.tolist() == [0, 5, 10, 15, 20]


def test_a_frame_that_was_not_committed_is_not_seen(monkeypatch, store):
    frames, made = store
    frames.append(made[0])

    def killed():
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(frames, "commit", killed)
        with pytest.raises(KeyboardInterrupt):
            frames.append(made[1])
    assert frames.steps.tolist() == [0]
    again = Frames(frames.path)
    again.append(made[2])
    assert again.steps.tolist() == [0, 10]
    np.testing.assert_array_equal(again.group["sand"][1], made[2].fields["sand"])


@pytest.mark.parametrize("count", range(6))
def test_frames_after_a_number_can_be_dropped_and_written_again(store, count):
    frames, made = store
    for frame in made:
        frames.append(frame)
    frames.keep(count)
    assert frames.steps.tolist() == [0, 5, 10, 15, 20][:count]
    for frame in made[count:]:
        frames.append(frame)
    for number, frame in enumerate(made):
        np.testing.assert_array_equal(frames.group["sand"][number], frame.fields["sand"])
        assert int(frames.group["moved"][number]) == frame.tally.moved


def test_each_frame_is_one_chunk(store):
    frames, _ = store
    assert frames.group["sand"].chunks == (1, 16, 24)


def test_a_frame_without_any_sand_is_a_frame(tmp_path):
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}))
    frames = Frames.create(tmp_path / "frames.zarr", simulation.scenario, "{}", simulation.bed.declared)
    frames.append(simulation.frame())
    assert frames.count == 1
    assert not np.asarray(zarr.open_group(tmp_path / "frames.zarr", mode="r")["sand"]).any()


def test_a_store_holds_the_fields_that_are_declared_for_frames(tmp_path):
    scratch = FieldInfo("scratch", "int8", "-", "work space", in_frames=False)
    declared = {field.name: field for field in (GROUND, SAND, scratch)}
    frames = Frames.create(tmp_path / "frames.zarr", tiny(), "{}", declared)
    assert "scratch" not in frames.fields


def test_counts_of_slabs_are_pure_numbers_to_others_and_slabs_to_us():
    assert field_attributes(SAND) == {"units": "1", "long_name": SAND.meaning, "unit": "slabs"}
    assert field_attributes(GROUND)["units"] == field_attributes(GROUND)["unit"] == "m"


def test_a_reader_never_sees_a_frame_whose_sand_is_already_dropped(monkeypatch, store):
    frames, made = store
    for frame in made:
        frames.append(frame)

    def killed():
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(frames, "commit", killed)
        with pytest.raises(KeyboardInterrupt):
            frames.keep(2)
    group = zarr.open_group(frames.path, mode="r")
    totals = {int(group["sand"][number].sum()) for number in range(group["step"].shape[0])}
    assert totals == {int(made[0].fields["sand"].sum())}
