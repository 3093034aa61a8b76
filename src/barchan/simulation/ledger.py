"""The ledger: every slab that was, came, went and is, in whole numbers."""

from dataclasses import dataclass

from barchan.errors import ConservationError


@dataclass
class Ledger:
    """Whole slabs; it closes exactly, always."""

    initial: int
    """On the bed at the start."""
    entered: int = 0
    """Brought in: supply, snowfall, brushes."""
    left: int = 0
    """Gone through open edges or taken by brushes."""
    airborne: int = 0

    def check(self, on_bed: int) -> None:
        """Raise ConservationError unless what is there is what was, came and did not go."""
        expected = self.initial + self.entered - self.left
        if on_bed + self.airborne != expected:
            raise ConservationError(
                f"the ledger does not close: {on_bed} slabs on the bed and {self.airborne} in the air, "
                f"but {self.initial} at the start + {self.entered} entered - {self.left} left = {expected}"
            )
