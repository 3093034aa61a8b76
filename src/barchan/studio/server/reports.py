"""The comparison report of two runs: both are saved by their workers, then the first worker writes it."""

import shutil
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.errors import BarchanError

if TYPE_CHECKING:
    from barchan.studio.server.session import Session

NAME = "comparison.html"

MEMBERS, FIGURES = "members", "figures"
"""Folders beside the report of both saved runs, and of its pictures, which the report holds itself."""

SAVED = 0.3
"""Share of the progress that saving has."""

REPORT, WRITER = "report", "a"
"""The part that writes the report, and the run whose worker does."""


@dataclass
class _Report:
    """A report in the making, or one that was given up and whose workers are still at it."""

    request: Any
    """The id of the browser's request."""
    number: int
    folder: Path
    parts: dict[str, float]
    """How far each part is, by the run that is saved; ``report`` is the last."""
    open: set[str] = field(default_factory=set)
    """Parts that a worker is at."""

    def id(self, part: str) -> str:
        """The id of the request for a part: the session's own, never a browser's."""
        return f"report {self.number} {part}"

    def run(self, name: str) -> Path:
        """Where a run is saved."""
        return self.folder / MEMBERS / name


class Reports:
    """The report that is being made, if one is."""

    def __init__(self, session: "Session") -> None:
        """None yet."""
        self._session = session
        self._now: _Report | None = None
        self._given_up: list[_Report] = []
        self._count = 0

    def begin(self, until: int, request: Any) -> None:
        """Save both runs up to a step, and compare them; raises BarchanError where that cannot be begun."""
        if len(self._session.workers) < 2:
            raise BarchanError("a comparison report needs two runs; allowed: after 'Compare with …'")
        if self._now is not None:
            raise BarchanError("a comparison report is being made already")
        folder = self._session.workspace.new_export(NAME).parent
        folder.mkdir(parents=True)
        self._count += 1
        self._now = _Report(request, self._count, folder, dict.fromkeys(self._session.workers, 0.0))
        for name in self._session.workers:
            self._ask(self._now, name, "save_folder", folder=str(self._now.run(name)), until=until)

    def break_off(self, request: Any) -> None:
        """Break the report off, where it answers this request."""
        if self._now is not None and self._now.request == request:
            self._give_up("broken off")

    def lose(self, name: str) -> None:
        """The worker of a run has ended: no report comes of it."""
        parts = {name, REPORT} if name == WRITER else {name}
        if self._now is not None:
            self._now.open -= parts
            self._give_up(f"the process of run {name} has ended")
        for report in self._given_up:
            report.open -= parts
        self._clear()

    def takes(self, content: dict[str, Any]) -> bool:
        """Take a worker's message that concerns a part of a report; returns whether it does."""
        given = content.get("id")
        if not (isinstance(given, str) and given.startswith("report ")):
            return False
        number, part = given.split(" ")[1:]
        report = self._now
        if report is None or report.number != int(number):
            if content["type"] != "progress":
                for old in self._given_up:
                    old.open -= {part} if old.number == int(number) else set()
                self._clear()
        elif content["type"] == "progress":
            self._count_on(report, part, content["done"] / max(content["of"], 1))
        else:
            report.open.discard(part)
            self._answered(report, part, content)
        return True

    def _answered(self, report: _Report, part: str, content: dict[str, Any]) -> None:
        if content["type"] == "refused":
            self._give_up(content["text"])
        elif part == REPORT:
            self._now = None
            for beside in (MEMBERS, FIGURES):
                shutil.rmtree(report.folder / beside, ignore_errors=True)
            self._session.tell("done", id=report.request, file=content["file"])
        else:
            self._count_on(report, part, 1.0)
            if not report.open:
                runs = [str(report.run(name)) for name in report.parts]
                report.parts[REPORT] = 0.0
                self._ask(report, REPORT, "report_to", target=str(report.folder / NAME), runs=runs)

    def _ask(self, report: _Report, part: str, command: str, **content: Any) -> None:
        report.open.add(part)
        self._worker(part).send(command, **content, id=report.id(part))

    def _worker(self, part: str) -> Any:
        return self._session.workers[WRITER if part == REPORT else part]

    def _count_on(self, report: _Report, part: str, share: float) -> None:
        report.parts[part] = share
        saving = [value for name, value in report.parts.items() if name != REPORT]
        done = SAVED * sum(saving) / len(saving) + (1.0 - SAVED) * report.parts.get(REPORT, 0.0)
        self._session.tell("progress", id=report.request, done=round(100 * done), of=100)

    def _give_up(self, why: str) -> None:
        """Answer the browser that there is no report, and let the workers leave their parts."""
        report, self._now = self._now, None
        assert report is not None
        for part in report.open:
            self._worker(part).send("break_off", of=report.id(part))
        self._given_up.append(report)
        self._session.tell("refused", id=report.request, command="report", text=why, problems=[])
        self._clear()

    def _clear(self) -> None:
        """Remove what is left of reports that were given up, once no worker writes there any more."""
        for report in [one for one in self._given_up if not one.open]:
            shutil.rmtree(report.folder, ignore_errors=True)
            self._given_up.remove(report)
