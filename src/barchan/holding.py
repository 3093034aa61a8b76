"""Files that one process holds at a time: the system lets go of them however the process ends."""

import os
from io import FileIO
from pathlib import Path

_FAR = 1 << 30
"""The byte that is locked where only bytes can be: far behind the text, which stays readable."""


class HeldError(Exception):
    """A file that another process holds."""

    def __init__(self, owner: str) -> None:
        """``owner`` is that process, by its number where it is known."""
        super().__init__(f"held by process {owner}")
        self.owner = owner


def hold(path: Path) -> FileIO:
    """Hold a file, which is made where there is none, until what is returned is closed.

    Raises HeldError where another process holds it, OSError where it cannot be made.
    """
    file = path.open("a+b", buffering=0)
    try:
        if not _locked(file):
            raise HeldError(_owner(file))
        if not _is_at(file, path):  # its last holder took the name away just as we came
            file.close()
            return hold(path)
        file.truncate(0)
        file.write(str(os.getpid()).encode())
    except BaseException:
        file.close()
        raise
    return file


def holder_of(path: Path) -> str | None:
    """The process that holds a file, by its number; None where none does, or there is no such file."""
    try:
        with path.open("rb", buffering=0) as file:
            return None if _locked(file, shared=True) else _owner(file)
    except OSError:
        return None


def _owner(file: FileIO) -> str:
    file.seek(0)
    return file.read().decode().strip() or "another"


def _locked(file: FileIO, shared: bool = False) -> bool:
    """Whether a file could be locked, until it is closed; ``shared`` with others that only ask."""
    try:
        import fcntl
    except ImportError:
        return _locked_by_byte(file)
    try:
        fcntl.flock(file, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
    except OSError:
        return False
    return True


def _locked_by_byte(file: FileIO) -> bool:
    """As ``_locked`` on Windows, which locks bytes, not files."""
    import msvcrt

    file.seek(_FAR)
    try:
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
    except OSError:
        return False
    return True


def _is_at(file: FileIO, path: Path) -> bool:
    try:
        return os.path.samestat(os.fstat(file.fileno()), path.stat())
    except FileNotFoundError:
        return False
