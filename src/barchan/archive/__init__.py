"""A run on disk: scenario, frames, newest checkpoint, events and log in one folder.

Everything is written so that a process killed at any moment leaves a run that can be read and resumed.
"""

from barchan.archive.branching import Branch, branch
from barchan.archive.dataset import dataset_of
from barchan.archive.folder import Archive, check_room
from barchan.archive.parent import Parent
from barchan.archive.reading import RunInfo, open_run, run_info, source_at
from barchan.archive.running import Outcome, Reopened, reopen, resume, run

__all__ = [
    "Archive",
    "Branch",
    "Outcome",
    "Parent",
    "Reopened",
    "RunInfo",
    "branch",
    "check_room",
    "dataset_of",
    "open_run",
    "reopen",
    "resume",
    "run",
    "run_info",
    "source_at",
]
