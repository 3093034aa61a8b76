"""Dunes whose ways are prescribed are followed along them."""

import numpy as np
import pytest

from barchan.measures.dune_tracks import track_dunes
from barchan.measures.dunes import find_dunes

SHAPE = (64, 96)


def heaps(*places, shape=SHAPE):
    """Round heaps (row, column, radius) on a field with joined edges."""
    surface = np.zeros(shape)
    for row, column, radius in places:
        north, east = (
            (np.arange(n) - at + n / 2) % n - n / 2 for n, at in zip(shape, (row, column), strict=True)
        )
        away = np.hypot(north[:, None], east[None, :])
        surface = np.maximum(surface, np.clip(radius - away, 0.0, None) / 2)
    return find_dunes(surface, 0.5, level=0.1, width=0.0)


def test_dunes_keep_their_tracks_and_speeds_over_a_joined_edge():
    frames = [heaps((20, 70 + 8 * n, 10), (45, 30 + 2 * n, 14)) for n in range(6)]
    found = track_dunes(frames, SHAPE)
    assert not found.encounters
    speeds = sorted(track.velocity(np.arange(6) * 2.0) for track in found.tracks)
    assert np.array(speeds) == pytest.approx(np.array([[1.0, 0.0], [4.0, 0.0]]), abs=1e-6)
    assert [len(track.frames) for track in found.tracks] == [6, 6]
    small, large = sorted(found.tracks, key=lambda track: track.cells[0])
    assert small.volumes[0] == pytest.approx(np.pi / 3 * 10**2 * 5.0, rel=0.03)
    assert large.heights[-1] == pytest.approx(7.0)


def test_a_common_shift_leads_dunes_that_move_by_more_than_their_length():
    frames = [heaps((20, 10 + 25 * n, 8), (45, 40 + 25 * n, 8)) for n in range(3)]
    assert len(track_dunes(frames, SHAPE).tracks) == 6
    led = track_dunes(frames, SHAPE, shifts=[np.array([0.0, 24.0])] * 2)
    assert len(led.tracks) == 2
    assert not led.encounters


def test_a_small_dune_that_runs_into_a_large_one_merges_with_it():
    found = track_dunes([heaps((30, 40, 14), (30, 62, 7)), heaps((30, 40, 14), (30, 56, 7))], SHAPE)
    (merged,) = found.encounters
    assert (merged.kind, merged.frame) == ("merges", 1)
    going_on, gone = (found.tracks[number] for number in merged.tracks)
    assert going_on.frames == [0, 1]
    assert gone.frames == [0]
    assert going_on.cells[0] > gone.cells[0]


@pytest.mark.parametrize(("radius", "kind"), [(12, "splits"), (5, "calves")])
def test_a_dune_that_comes_apart_splits_or_calves(radius, kind):
    together = heaps((30, 40, 14), (30, 40 + 13 + radius / 2, radius))
    assert len(together) == 1
    found = track_dunes([together, heaps((30, 40, 14), (30, 40 + 15 + radius, radius))], SHAPE)
    (parted,) = found.encounters
    assert parted.kind == kind
    assert found.count(kind) == 1
    assert [len(found.tracks[number].frames) for number in parted.tracks] == [2, 1]


def test_dunes_appear_and_vanish():
    found = track_dunes([heaps((20, 20, 8)), heaps((45, 70, 8))], SHAPE)
    assert sorted(one.kind for one in found.encounters) == ["appears", "vanishes"]
    assert np.isnan(found.tracks[0].velocity(np.arange(2.0))[0])


def test_shifts_that_do_not_fit_the_frames_are_refused():
    with pytest.raises(ValueError, match="one less than frames"):
        track_dunes([[], []], SHAPE, shifts=[])
