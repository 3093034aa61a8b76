"""The error that Barchan raises: one for all that is wrong, each problem with its key."""

from dataclasses import dataclass


class BarchanError(Exception):
    """Base of all errors that a user can cause and mend; the message says how."""


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with a scenario or a file."""

    key: str
    """Dotted path of the key, for instance ``model.hop_length``."""
    message: str
    """The fault, with the value found and the values allowed."""
    place: str = ""
    """Where it stands: ``file:line`` or ``command line``."""

    def __str__(self) -> str:
        where = f" ({self.place})" if self.place else ""
        return f"{self.key}: {self.message}{where}" if self.key else f"{self.message}{where}"


class _ListedError(BarchanError):
    """Several problems, reported at once."""

    def __init__(self, problems: list[Problem], title: str = "scenario") -> None:
        self.problems = problems
        super().__init__(problems, title)

    def __str__(self) -> str:
        problems, title = self.args
        count = "1 problem" if len(problems) == 1 else f"{len(problems)} problems"
        return "\n".join([f"{title}: {count}", *(f"  {problem}" for problem in problems)])


class ScenarioError(_ListedError):
    """A scenario that cannot be used, with every problem found in it."""


class RecordError(_ListedError):
    """A wind record that cannot be used, with the first problem of each kind found in it."""


class ConservationError(BarchanError):
    """The ledger does not close: sand was lost or made. Always a defect of the program."""


class ArchiveError(BarchanError):
    """A run on disk that cannot be written, read or resumed."""
