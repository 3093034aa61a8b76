"""Compiled functions of arrays and numbers: what the wind, the slabs and the grains do to a bed.

Nothing here knows of scenarios, models, files or screens.
"""

import hashlib
import os
import sys
from pathlib import Path

__all__: list[str] = []


def digest_of(folder: Path) -> str:
    """A digest of all sources in a folder and its subfolders: any edit, move or new file changes it."""
    digest = hashlib.sha256()
    for source in sorted(folder.rglob("*.py")):
        digest.update(f"{source.relative_to(folder).as_posix()}\0".encode() + source.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


def _cache_by_source(folder: Path) -> None:
    """Give every state of the kernels' sources a compilation cache of its own.

    Numba looks only at the file a kernel stands in, so an edit in a kernel that it calls from
    another file would go unnoticed. An installed package never changes file by file; a checkout does.
    """
    checkout = folder.parents[2]
    if "NUMBA_CACHE_DIR" in os.environ or not (checkout / "pyproject.toml").is_file():
        return
    if "numba" in sys.modules:
        return
    os.environ["NUMBA_CACHE_DIR"] = str(checkout / ".numba_cache" / digest_of(folder))


_cache_by_source(Path(__file__).resolve().parent)
