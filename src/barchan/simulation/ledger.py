"""The ledger: every unit of every layer that was, entered, left and is, in whole numbers."""

from dataclasses import dataclass

from barchan.bed import Bed
from barchan.errors import ConservationError


@dataclass
class Ledger:
    """Whole units of the bed's layers; it closes exactly, always."""

    initial: int
    """On the bed at the start."""
    entered: int = 0
    """Brought in: supply, snowfall, brushes."""
    left: int = 0
    """Gone through open edges or taken by brushes."""
    airborne: int = 0

    def check(self, bed: Bed) -> None:
        """Raise ConservationError unless the units on a bed are all accounted for.

        The classes of a divided layer must add up to the layer on every cell.
        """
        divided = bed.undivided()
        if divided:
            raise ConservationError(f"classes do not add up to their layer: {', '.join(divided)}")
        self.close(bed.units)

    def close(self, on_bed: int) -> None:
        """Raise ConservationError unless all units that were, entered and did not leave are there."""
        expected = self.initial + self.entered - self.left
        if on_bed + self.airborne != expected:
            raise ConservationError(
                f"the ledger does not close: {on_bed} units on the bed and {self.airborne} in the air, "
                f"but {self.initial} at the start + {self.entered} entered - {self.left} left = {expected}"
            )
