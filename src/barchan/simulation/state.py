"""The complete state of a simulation: all that it takes to go on with the same bits."""

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from barchan.scenario import FORMAT


@dataclass(frozen=True)
class State:
    """Plain data and arrays, ready to be written anywhere."""

    data: dict[str, Any]
    """Everything but the arrays, as JSON can hold it."""
    arrays: dict[str, NDArray]
    """The bed's fields as ``bed/<name>``, what the model remembers as ``model/<name>`` and so on."""

    def up_to_date(self) -> "State":
        """The same state as this version of the program writes it, whatever format it was written in."""
        return self if self.data["scenario"]["barchan"] == FORMAT else _from_format_1(self)

    def group(self, prefix: str) -> dict[str, NDArray]:
        """The arrays whose names begin with ``prefix``, by the rest of their names."""
        return {k.removeprefix(prefix): v for k, v in self.arrays.items() if k.startswith(prefix)}

    @property
    def step(self) -> int:
        """Steps done."""
        return int(self.data["step"])


def _from_format_1(state: State) -> State:
    """Format 1 counted idle steps in the tally and had stop conditions under another name."""
    data = dict(state.data)
    tally = dict(data["tally"])
    watches = data.pop("watches", {})
    data["stop_conditions"] = {"idle_steps": {"idle": tally.pop("still", 0)}, **watches}
    data["tally"] = tally
    arrays = {_current_name(name): array for name, array in state.arrays.items()}
    return State(data, arrays)


def _current_name(name: str) -> str:
    return f"stop/{name.removeprefix('watch/')}" if name.startswith("watch/") else name
