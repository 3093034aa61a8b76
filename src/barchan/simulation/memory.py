"""How much memory a scenario needs, estimated before anything is made, and how much is free."""

import os
from contextlib import suppress
from pathlib import Path

import numpy as np

from barchan.errors import Problem, ScenarioError
from barchan.fields import GROUND
from barchan.scenario import Scenario

BED_COPIES = 3
"""How often the bed's fields lie in memory at once: the bed, a frame or a state, and one on the way."""

SURFACES = 6
"""Arrays of 8 bytes a cell that making the first bed, its elevation and pictures of it take at once."""

_LINUX_FREE = Path("/proc/meminfo")
_GROUP_LIMIT = Path("/sys/fs/cgroup/memory.max")
_GROUP_USE = Path("/sys/fs/cgroup/memory.current")


def memory_needed(scenario: Scenario) -> int:
    """Memory (bytes) that a run of a scenario needs at most, beside the program itself: an estimate.

    The bed's fields some times over, the arrays that make the first bed, and what the model's kernels need.
    """
    model = scenario.new_model()
    fields = (GROUND, *model.layers, *model.fields)
    cell = BED_COPIES * sum(np.dtype(field.dtype).itemsize for field in fields) + 8 * SURFACES
    return cell * scenario.lattice.cells + model.work_bytes()


def memory_free() -> int | None:
    """Memory (bytes) that is free for this program; None where the system does not tell."""
    known = [found for found in (_free_in_system(), _free_in_group()) if found is not None]
    return min(known, default=None)


def refuse_too_large(scenario: Scenario) -> None:
    """Raise ScenarioError where a scenario needs more memory than is free."""
    needed, free = memory_needed(scenario), memory_free()
    if free is None or needed <= free:
        return
    rows, columns = scenario.lattice.shape
    problem = Problem(
        "lattice",
        f"has {rows:,} × {columns:,} cells, for which a run needs about {in_words(needed)} of memory; "
        f"{in_words(free)} are free. Allowed: fewer cells",
        scenario.source_map.of(("lattice",)),
    )
    raise ScenarioError([problem], scenario.source_map.name or "scenario")


def in_words(size: int) -> str:
    """A number of bytes in the unit that suits it."""
    for unit, length in (("TB", 1e12), ("GB", 1e9), ("MB", 1e6)):
        if size >= length:
            return f"{size / length:.3g} {unit}"
    return f"{max(size / 1e3, 1.0):.3g} kB"


def _free_in_system() -> int | None:
    """Free memory and what the system would give up (Linux), or all there is (other Unix)."""
    with suppress(OSError, ValueError):
        for line in _LINUX_FREE.read_text("ascii").splitlines():
            name, _, rest = line.partition(":")
            if name == "MemAvailable":
                return int(rest.split()[0]) * 1024
    with suppress(AttributeError, OSError, ValueError):
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    return None


def _free_in_group() -> int | None:
    """Memory left to this program's control group, where it has a limit (containers)."""
    with suppress(OSError, ValueError):
        return max(int(_GROUP_LIMIT.read_text("ascii")) - int(_GROUP_USE.read_text("ascii")), 0)
    return None
