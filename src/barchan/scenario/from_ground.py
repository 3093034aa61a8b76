"""A lattice whose size and cells are those of the ground's file: ``"lattice": "from ground"``."""

from collections.abc import Set as AbstractSet
from typing import Any

from pydantic import ValidationError

from barchan.errors import Problem
from barchan.ground.fitting import FARTHEST, TOLERANCE
from barchan.ground.raster import UnreadableError
from barchan.ground.surface import FileGround
from barchan.scenario.source_map import Path

FROM_GROUND = "from ground"

MEASURED = ("rows", "columns", "cell_size")
"""Keys of the lattice that the file gives."""


def spelt_out(data: dict[str, Any]) -> None:
    """Write the short form of such a lattice as a group of keys, so that others can stand beside it."""
    if data.get("lattice") == FROM_GROUND:
        data["lattice"] = {"kind": FROM_GROUND}


def measure(data: dict[str, Any], given: AbstractSet[Path]) -> list[Problem]:
    """Take the lattice of a scenario's data from its ground, if it says so; the problems, with their keys.

    A ``cell_size`` may stand beside it, for a ground that is resampled. Where ``given`` (keys of the command
    line) hold the lattice's kind, the sizes that a preset or file states give way.
    """
    lattice = data.get("lattice")
    if not isinstance(lattice, dict) or lattice.get("kind") != FROM_GROUND:
        return []
    if ("lattice", "kind") in given:
        lattice = {k: v for k, v in lattice.items() if k not in MEASURED or ("lattice", k) in given}
    data["lattice"] = {**lattice, "kind": "square"}
    beside = [key for key in ("rows", "columns") if key in lattice]
    if beside:
        return [Problem(f"lattice.{key}", f"is given, but the lattice is '{FROM_GROUND}'") for key in beside]
    ground = data.get("ground")
    if not isinstance(ground, dict) or ground.get("kind") != "file":
        return [Problem("lattice", f"is '{FROM_GROUND}', which needs a ground of kind 'file'")]
    try:
        size = _size(FileGround.model_validate(ground), lattice.get("cell_size"))
    except ValidationError:  # said of the ground itself
        return []
    except UnreadableError as error:
        return [Problem("ground.path", f"'{ground['path']}': {error}")]
    data["lattice"] |= size
    return []


def _size(ground: FileGround, cell_size: Any) -> dict[str, Any]:
    """Rows and columns of the ground's file, and its cell size where it has one and none is given."""
    outline = ground.outline()
    (rows, columns), place = outline.shape, outline.place
    if place is None:
        return {"rows": rows, "columns": columns}
    if not isinstance(cell_size, int | float) or not cell_size > 0:
        return {"rows": rows, "columns": columns, "cell_size": place.cell_size}
    if not ground.resample:
        return {"rows": rows, "columns": columns}
    return {
        "rows": _whole_cells(rows * place.height / cell_size),
        "columns": _whole_cells(columns * place.width / cell_size),
    }


def _whole_cells(covered: float) -> int:
    """Cells that a file covers, of which the last may lack what the tolerance allows."""
    return max(int(covered + min(FARTHEST, TOLERANCE * covered)), 1)
