"""Runs that were saved together: a folder of runs, and a file that names them."""

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from hashlib import file_digest
from pathlib import Path
from typing import Any

from barchan.errors import BarchanError
from barchan.replacing import replacing
from barchan.studio.server.security import is_plain_name

NAME = "together.json"
"""The file that names the runs."""

FORMAT = 1


@dataclass(frozen=True)
class Member:
    """One of the runs."""

    folder: str
    """Its folder, beside the file."""
    title: str
    model: str
    step: int
    steps: int
    """How far it had come, and how far its scenario goes."""


@dataclass(frozen=True)
class Together:
    """The runs of a folder."""

    folder: Path
    members: tuple[Member, ...]
    saved: str
    """When, as an ISO date and time."""
    digests: dict[str, str]
    """SHA-256 of files, where no program but the studio writes to them."""

    @property
    def folders(self) -> list[Path]:
        """The folders of the runs."""
        return [self.folder / member.folder for member in self.members]


def name_together(folder: Path, members: Sequence[Member], sealed: bool = False) -> None:
    """Name the runs of a folder in a file; ``sealed`` with the digests of all that their folders hold."""
    files = [path for one in members for path in sorted((folder / one.folder).rglob("*")) if path.is_file()]
    data = {
        "barchan_together": FORMAT,
        "saved": datetime.now(UTC).isoformat(timespec="seconds"),
        "runs": [asdict(one) for one in members],
        "digests": {path.relative_to(folder).as_posix(): _digest(path) for path in files} if sealed else {},
    }
    with replacing(folder / NAME) as partial:
        partial.write_text(f"{json.dumps(data, indent=1)}\n", "utf-8")


def is_together(folder: Path) -> bool:
    """Whether a folder holds runs that were saved together."""
    return (folder / NAME).is_file()


def read_together(folder: Path) -> Together:
    """The runs of a folder.

    Raises BarchanError where the file that names them is damaged, or a sealed one.
    """
    try:
        data = json.loads((folder / NAME).read_text("utf-8"))
        members = tuple(_member(one) for one in data["runs"])
        found = Together(folder, members, str(data["saved"]), dict(data["digests"]))
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise BarchanError(f"{folder / NAME}: damaged ({type(error).__name__}: {error})") from None
    if not 1 <= len(members) <= 2 or data.get("barchan_together") != FORMAT:
        raise BarchanError(f"{folder / NAME}: no runs that this version knows")
    for name, digest in found.digests.items():
        if not (folder / name).is_file() or _digest(folder / name) != digest:
            raise BarchanError(f"{folder / name}: damaged, or not there")
    return found


def moment(saved: str) -> str:
    """An ISO date and time in words of this computer's time zone, such as ``28 Nov 2026, 05:10``."""
    return datetime.fromisoformat(saved).astimezone().strftime("%d %b %Y, %H:%M")


def _member(data: dict[str, Any]) -> Member:
    if not is_plain_name(data["folder"]):
        raise ValueError(f"'{data['folder']}' is no folder's name")
    words = {key: str(data[key]) for key in ("folder", "title", "model")}
    return Member(**words, step=int(data["step"]), steps=int(data["steps"]))


def _digest(path: Path) -> str:
    with path.open("rb") as file:
        return file_digest(file, "sha256").hexdigest()
