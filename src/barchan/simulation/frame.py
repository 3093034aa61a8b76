"""A frame: the bed at one moment, with the counts of all that had happened until then."""

from dataclasses import dataclass

from numpy.typing import NDArray

from barchan.model import Tally
from barchan.simulation.ledger import Ledger


@dataclass(frozen=True)
class Frame:
    """The bed at one moment, with the counts up to then."""

    step: int
    direction: float
    """Where the wind comes from (degrees)."""
    fields: dict[str, NDArray]
    ledger: Ledger
    tally: Tally

    def __repr__(self) -> str:
        rows, columns = next(iter(self.fields.values())).shape
        return (
            f"<Frame at step {self.step}: {', '.join(self.fields)} on {rows} × {columns} cells, "
            f"wind from {self.direction:g}°>"
        )
