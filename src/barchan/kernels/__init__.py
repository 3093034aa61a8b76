"""Compiled functions of arrays and numbers: what the wind, the slabs and the grains do to a bed.

Nothing here knows of scenarios, models, files or screens.
"""

import hashlib
import os
import sys
from pathlib import Path

__all__: list[str] = []


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
    digest = hashlib.sha256()
    for source in sorted(folder.glob("*.py")):
        digest.update(source.read_bytes())
    os.environ["NUMBA_CACHE_DIR"] = str(checkout / ".numba_cache" / digest.hexdigest()[:16])


_cache_by_source(Path(__file__).resolve().parent)
