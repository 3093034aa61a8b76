"""Dunes followed from frame to frame: how they move and grow, merge, split and calve."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.measures.dunes import Dune
from barchan.measures.filters import Field, Periodic

OVERLAP = 0.3
"""Share of the smaller outline that two dunes of one kind have in common, after the common motion; ours."""

CALF = 0.25
"""Area over that of its parent below which a part that leaves is a calf; ours."""

Kind = Literal["appears", "vanishes", "merges", "splits", "calves"]


@dataclass(frozen=True)
class Encounter:
    """Dunes that become fewer or more from one frame to the next."""

    kind: Kind
    frame: int
    """Number of the frame after it."""
    tracks: tuple[int, ...]
    """Numbers of the tracks: the one that goes on first."""


@dataclass
class Track:
    """One dune through the frames."""

    frames: list[int] = field(default_factory=list)
    """Numbers of the frames that it is seen in, one after the other."""
    rows: list[float] = field(default_factory=list)
    columns: list[float] = field(default_factory=list)
    """Its centre of volume (cells), as if the field continued over joined edges."""
    cells: list[int] = field(default_factory=list)
    heights: list[float] = field(default_factory=list)
    """Greatest depth of its sand (m)."""
    volumes: list[float] = field(default_factory=list)
    """Depth of its sand, summed over its cells (m times cells)."""

    def velocity(self, times: NDArray) -> tuple[float, float]:
        """Its velocity (cells eastwards and northwards per unit of the frames' ``times``), by least squares.

        NaN where it is seen once.
        """
        t = np.asarray(times, float)[self.frames]
        about = t - t.mean()
        power = float((about**2).sum())
        if not power:
            return float("nan"), float("nan")
        east, north = (float((about * np.array(at)).sum()) / power for at in (self.columns, self.rows))
        return east, north


@dataclass(frozen=True)
class Tracks:
    """All dunes of several frames."""

    tracks: list[Track]
    encounters: list[Encounter]

    def count(self, kind: Kind) -> int:
        """How often something happened."""
        return sum(one.kind == kind for one in self.encounters)


def track_dunes(
    frames: Sequence[Sequence[Dune]],
    shape: tuple[int, int],
    periodic: Periodic = (True, True),
    shifts: Sequence[Field] | None = None,
) -> Tracks:
    """Follow dunes through frames, by the overlap of their outlines.

    ``shifts`` are the common displacements (rows, columns) from each frame to the next, of ``moved`` for
    instance; without them dunes must move by less than their length. Two outlines belong together where they
    share 30 % of the smaller one. Where several become one they merge, and the largest goes on; where one
    becomes several it splits, and the largest part goes on; a part of less than a quarter of its area is a
    calf. Raises ValueError where there is not one shift for each step from frame to frame.
    """
    if shifts is None:
        shifts = [np.zeros(2)] * (len(frames) - 1)
    if len(shifts) != max(len(frames) - 1, 0):
        raise ValueError(f"{len(shifts)} shifts for {len(frames)} frames; allowed: one less than frames")
    follower = _Follower(shape, periodic)
    for number, dunes in enumerate(frames):
        follower.take(number, dunes, shifts[number - 1] if number else np.zeros(2))
    return Tracks(follower.tracks, follower.encounters)


class _Follower:
    """The tracks so far, and which dune of the last frame each belongs to."""

    def __init__(self, shape: tuple[int, int], periodic: Periodic) -> None:
        self.shape, self.periodic = shape, periodic
        self.tracks: list[Track] = []
        self.encounters: list[Encounter] = []
        self.last: list[tuple[Dune, int]] = []

    def take(self, frame: int, dunes: Sequence[Dune], shift: Field) -> None:
        """Go on with the dunes of the next frame."""
        links = self._links(dunes, np.rint(shift).astype(np.int64))
        owner: dict[int, int] = {}
        for old, (_, track) in enumerate(self.last):
            heirs = [new for new in links if old in links[new]]
            mine = [new for new in heirs if self._largest(links[new]) == old]
            if mine:
                owner[max(mine, key=lambda new: dunes[new].cells)] = track
            elif not heirs and frame:
                self.encounters.append(Encounter("vanishes", frame, (track,)))
        numbers = [owner.get(new, -1) for new in range(len(dunes))]
        for new, dune in enumerate(dunes):
            if numbers[new] < 0:
                numbers[new] = len(self.tracks)
                self.tracks.append(Track())
            self._add(numbers[new], frame, dune)
        if frame:
            self._note(frame, dunes, links, numbers)
        self.last = list(zip(dunes, numbers, strict=True))

    def _links(self, dunes: Sequence[Dune], shift: NDArray[np.int64]) -> dict[int, list[int]]:
        """For each new dune the dunes before that it overlaps."""
        label = np.full(self.shape, -1)
        for new, dune in enumerate(dunes):
            label[dune.rows % self.shape[0], dune.columns % self.shape[1]] = new
        links: dict[int, list[int]] = {new: [] for new in range(len(dunes))}
        for old, (dune, _) in enumerate(self.last):
            rows, columns = dune.rows + shift[0], dune.columns + shift[1]
            inside = np.ones(len(rows), bool)
            for at, size, joined in zip((rows, columns), self.shape, self.periodic, strict=True):
                inside &= joined or ((at >= 0) & (at < size))
            under = label[rows[inside] % self.shape[0], columns[inside] % self.shape[1]]
            for new, shared in zip(*np.unique(under[under >= 0], return_counts=True), strict=True):
                if shared >= OVERLAP * min(dune.cells, dunes[int(new)].cells):
                    links[int(new)].append(old)
        return links

    def _largest(self, old: list[int]) -> int:
        return max(old, key=lambda number: self.last[number][0].cells)

    def _add(self, number: int, frame: int, dune: Dune) -> None:
        """Put a dune at the end of a track, its centre next to where the track was."""
        track, sand = self.tracks[number], dune.depth + dune.level
        for places, at, size in zip(
            (track.rows, track.columns), (dune.rows, dune.columns), self.shape, strict=True
        ):
            centre = float(np.average(at, weights=sand))
            if places:
                centre -= round((centre - places[-1]) / size) * size
            places.append(centre)
        track.frames.append(frame)
        track.cells.append(dune.cells)
        track.heights.append(float(sand.max()))
        track.volumes.append(float(sand.sum()))

    def _note(
        self, frame: int, dunes: Sequence[Dune], links: dict[int, list[int]], numbers: list[int]
    ) -> None:
        """Record merging, splitting, calving and appearing."""
        for new, before in links.items():
            if not before:
                self.encounters.append(Encounter("appears", frame, (numbers[new],)))
            if len(before) > 1:
                olds = sorted((self.last[old][1] for old in before), key=lambda track: track != numbers[new])
                self.encounters.append(Encounter("merges", frame, tuple(olds)))
        for old in range(len(self.last)):
            parts = [new for new in links if old in links[new]]
            if len(parts) > 1:
                parts.sort(key=lambda new: -dunes[new].cells)
                small = all(dunes[new].cells < CALF * dunes[parts[0]].cells for new in parts[1:])
                tracks = tuple(numbers[new] for new in parts)
                self.encounters.append(Encounter("calves" if small else "splits", frame, tracks))
