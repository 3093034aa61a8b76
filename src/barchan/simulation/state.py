"""The complete state of a simulation: all that it takes to go on with the same bits."""

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from barchan.scenario.migrations import current_field

LOOK_ONLY = "look_only"
"""Key of states that were made of frames: to look at, not to go on from."""


@dataclass(frozen=True)
class State:
    """Plain data and arrays, ready to be written anywhere."""

    data: dict[str, Any]
    """Everything but the arrays, as JSON can hold it."""
    arrays: dict[str, NDArray]
    """The bed's fields as ``bed/<name>``, arrays that the model remembers as ``model/<name>`` and so on."""

    @property
    def whole(self) -> bool:
        """Whether a run can go on from it; what was made of a frame lacks all that frames leave out."""
        return not self.data.get(LOOK_ONLY)

    def up_to_date(self) -> "State":
        """The same state as this version of the program writes it, whatever format it was written in."""
        return _from_format_1(self) if self.data["scenario"]["barchan"] == 1 else self

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


_RENAMED_SINCE_1 = {
    "model/marks": "model/counters",
    "model/kinds": "model/size_class",
    "model/stress": "model/grain_stress",
}
"""Arrays of format 1 that models remember, and their names of today."""


def _current_name(name: str) -> str:
    kind, _, rest = name.partition("/")
    if kind == "watch":
        return f"stop/{rest}"
    return f"bed/{current_field(rest)}" if kind == "bed" else _RENAMED_SINCE_1.get(name, name)
