"""Bookmarks of a run: moments with a name, where one looked from, and what coloured the surface."""

import hashlib
import json
import math
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass, replace
from dataclasses import field as dataclass_field
from typing import Any

from barchan.errors import BarchanError
from barchan.simulation import Simulation

MOST = 100
"""Bookmarks that a run may have."""

LONGEST_NAME = 120
"""Characters of a bookmark's name."""

MOST_NUMBERS = 16
"""Numbers that may say where one looked from."""

WORDS = ("barchan", "title", "citation", "note", "look_for", "question")
"""Keys of a scenario that change nothing of its bits."""


@dataclass(frozen=True)
class Bookmark:
    """A moment of a run."""

    id: str
    name: str
    step: int
    branch: int = 1
    """The branch on which it was set."""
    events: int = 0
    """Changes of the run before it; without any, its scenario alone gives its bits again."""
    colour_by: str = ""
    """The field that coloured the surface."""
    camera: dict[str, Any] = dataclass_field(default_factory=dict)
    """Where one looked from: a word for the kind of view, and numbers that only the page reads."""


def bookmark_from(data: Any) -> Bookmark:
    """A bookmark from data of a request or a file; raises BarchanError where they are none."""
    try:
        return Bookmark(
            id=_text(data["id"]),
            name=_text(data["name"]),
            step=max(0, int(data.get("step", 0))),
            branch=max(1, int(data.get("branch", 1))),
            events=max(0, int(data.get("events", 0))),
            colour_by=_text(data.get("colour_by", "")),
            camera={str(key): _camera_value(value) for key, value in dict(data.get("camera") or {}).items()},
        )
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        raise BarchanError(f"no bookmark: {error}; it needs id, name and step") from None


def _text(value: Any) -> str:
    return str(value).strip()[:LONGEST_NAME]


def _camera_value(value: Any) -> Any:
    if isinstance(value, str):
        return _text(value)
    numbers = [float(number) for number in (value if isinstance(value, list) else [value])]
    if len(numbers) > MOST_NUMBERS or not all(map(math.isfinite, numbers)):
        raise ValueError(f"a camera has at most {MOST_NUMBERS} finite numbers")
    return numbers if isinstance(value, list) else numbers[0]


class Bookmarks:
    """All bookmarks of a run, in the order in which they were set."""

    def __init__(self, known: Iterable[Bookmark] = ()) -> None:
        """Begin with some that are known."""
        self._by_id = {bookmark.id: bookmark for bookmark in known}

    def __iter__(self) -> Iterator[Bookmark]:
        return iter(self._by_id.values())

    def set(self, bookmark: Bookmark) -> None:
        """Set a bookmark, or give one that is known another name; raises BarchanError beyond the most."""
        known = self._by_id.get(bookmark.id)
        if known is None and len(self._by_id) >= MOST:
            raise BarchanError(f"the run has {MOST} bookmarks; allowed: no more. Remove one first")
        self._by_id[bookmark.id] = bookmark if known is None else replace(known, name=bookmark.name)

    def remove(self, bookmark_id: str) -> None:
        """Remove a bookmark, if it is there."""
        self._by_id.pop(bookmark_id, None)

    def __contains__(self, bookmark_id: object) -> bool:
        return bookmark_id in self._by_id

    def __getitem__(self, bookmark_id: str) -> Bookmark:
        """The bookmark of that id; raises BarchanError where there is none."""
        if bookmark_id not in self._by_id:
            raise BarchanError("this bookmark is not there any more")
        return self._by_id[bookmark_id]

    def data(self) -> list[dict[str, Any]]:
        """All as data, by step."""
        return [asdict(bookmark) for bookmark in sorted(self, key=lambda one: (one.step, one.name))]


def marks_of(bookmarks: Iterable[Bookmark]) -> dict[str, int]:
    """The steps of bookmarks by their ids, as a history takes them."""
    return {bookmark.id: bookmark.step for bookmark in bookmarks}


def identity(simulation: Simulation) -> str:
    """A short text: the same for all runs of one scenario and seed, whatever its words and length."""
    data = {key: value for key, value in simulation.scenario.data().items() if key not in WORDS}
    data["run"] = data["run"]["seed"]
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()[:16]
