"""The error that Barchan raises: one for all that is wrong, each problem with its key."""

from dataclasses import dataclass

from barchan.words import counted


class BarchanError(Exception):
    """Base of all errors that a user can cause and mend; the message says how."""


MOST_PROBLEMS = 20
"""Problems of an error that its text lists: a screenful."""

MOST_CHARACTERS, MOST_KEY = 1000, 100
"""Characters of a problem's message, and of its key, that a text shows."""


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else f"{text[:most]}…"


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
        message = _cut(self.message, MOST_CHARACTERS)
        return f"{_cut(self.key, MOST_KEY)}: {message}{where}" if self.key else f"{message}{where}"


class _ListedError(BarchanError):
    """Several problems, reported at once."""

    def __init__(self, problems: list[Problem], title: str = "scenario") -> None:
        self.problems = problems
        super().__init__(problems, title)

    def __str__(self) -> str:
        problems, title = self.args
        lines = [f"  {problem}" for problem in problems[:MOST_PROBLEMS]]
        if len(problems) > MOST_PROBLEMS:
            lines.append(f"  and {len(problems) - MOST_PROBLEMS:,} more")
        return "\n".join([f"{title}: {counted(len(problems), 'problem')}", *lines])


class ScenarioError(_ListedError):
    """A scenario that cannot be used, with every problem found in it."""


class RecordError(_ListedError):
    """A wind record that cannot be used, with the first problem of each kind found in it."""


class ConservationError(BarchanError):
    """The ledger does not close: sand was lost or made. Always a defect of the program."""


class ArchiveError(BarchanError):
    """A run on disk that cannot be written, read or resumed."""


class ExportError(BarchanError):
    """Frames of a run that cannot be written for another program."""


class SurveyError(BarchanError):
    """A surface that cannot be measured, or two that cannot be compared."""


class FieldError(BarchanError, ValueError):
    """An array that is no field of the lattice: of another shape or type, or not of numbers."""
