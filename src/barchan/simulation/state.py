"""The complete state of a simulation: all that it takes to go on with the same bits."""

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray


@dataclass(frozen=True)
class State:
    """Plain data and arrays, ready to be written anywhere."""

    data: dict[str, Any]
    """Everything but the arrays, as JSON can hold it."""
    arrays: dict[str, NDArray]
    """The bed's fields as ``bed/<name>``, what the model remembers as ``model/<name>`` and so on."""

    def group(self, prefix: str) -> dict[str, NDArray]:
        """The arrays whose names begin with ``prefix``, by the rest of their names."""
        return {k.removeprefix(prefix): v for k, v in self.arrays.items() if k.startswith(prefix)}

    @property
    def step(self) -> int:
        """Steps done."""
        return int(self.data["step"])
