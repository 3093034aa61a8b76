"""Rounds of polls of snow, shared among threads where the wind blows along an axis of the lattice."""

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from barchan.kernels.slabs.state import SlabRules, Work, prepared_polls
from barchan.kernels.snow.state import Pack, SnowRules
from barchan.slabs.rounds import SharedRounds


@dataclass(kw_only=True)
class SnowRounds(SharedRounds):
    """The pack and the rules of some rounds."""

    pack: Pack
    rules: SnowRules

    @property
    def lattice_rules(self) -> SlabRules:
        """The rules that snow shares with slabs of sand."""
        return self.rules.slabs

    @property
    def alone(self) -> bool:
        """An oblique wind carries snow over many rows, to where it lands at once."""
        return self.rules.slabs.ray is not None

    def changed(self) -> list[NDArray[Any]]:
        """The pack, of its buried layers those that any cell has: beyond them nothing is read."""
        deepest = int(self.pack.buried_count.max())
        return [*self.pack._replace(buried=self.pack.buried[:, :deepest])]

    def bed_and_rules(self) -> tuple[Pack, SnowRules]:
        """The pack and the rules, which polls only read."""
        import barchan.kernels.snow.bed  # noqa: F401  # how kernels treat a bed of snow

        return self.pack, self.rules

    def new_work(self) -> Work:
        """Work space of a thread."""
        grid = self.rules.slabs.grid
        return Work(prepared_polls(grid.rows, grid.cols, self.schedule), None)
