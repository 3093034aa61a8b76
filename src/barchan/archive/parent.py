"""Where a run branched off from another one."""

import json
import os
from dataclasses import dataclass
from pathlib import Path

PARENT = "parent.json"


@dataclass(frozen=True)
class Parent:
    """The run that a branch came from, and the step at which it left it."""

    run: Path
    step: int

    def text(self, folder: Path) -> str:
        """What a branch in ``folder`` notes: the way to the run from there, and the step."""
        way = os.path.relpath(self.run.resolve(), folder.resolve())
        return json.dumps({"run": way, "step": self.step}) + "\n"


def parent_of(folder: Path) -> Parent | None:
    """Where the run in a folder branched off, if it is a branch."""
    if not (folder / PARENT).is_file():
        return None
    known = json.loads((folder / PARENT).read_text("utf-8"))
    return Parent(Path(os.path.normpath(folder / known["run"])), known["step"])
