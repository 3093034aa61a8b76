"""The commands that a worker carries out, one method each."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from barchan.errors import BarchanError
from barchan.scenario import Scenario
from barchan.simulation import SetParameter, SetWind
from barchan.studio.commands import command_of
from barchan.studio.protocol import Request
from barchan.studio.worker import beginnings, bookmark_commands, questions  # noqa: F401 - register what they carry out
from barchan.studio.worker.aside import SetAside, held_aside
from barchan.studio.worker.description import description, named
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.frame_sender import FrameSender
from barchan.studio.worker.handlers import WORKER, Answer
from barchan.studio.worker.painting import strokes_in
from barchan.studio.worker.run import StudioRun
from barchan.studio.worker.state_files import FileNames

UNSEEN = ("confirm", "keep", "keep_in", "keep_aside_in", "break_off")
"""Commands that change nothing that a frame shows."""

SLOWEST, FASTEST = 0.1, 1e6
"""Limits of the speed limit (steps per second)."""


class RunCommands:
    """Carries commands out on the worker's run."""

    def __init__(
        self, frames: FrameSender, send: Callable[..., None], send_bytes: Callable[[bytes], None], desk: Desk
    ) -> None:
        """No run yet; ``send`` sends control messages, ``send_bytes`` the state that the server keeps."""
        self.frames = frames
        self.run: StudioRun | None = None
        self.aside: SetAside | None = None
        """The run that was set aside for two that are compared, or for another scenario."""
        self.origin: Scenario | None = None
        """The scenario that was loaded, whose words name what was changed on the page since."""
        self.number = 0
        """The number of the start that the run goes back to."""
        self.order: Any = None
        """The number of the order to run that was given last, which the message that it is done repeats."""
        self._told_end = 0
        """The step at which the run stops by itself, as the page knows it."""
        self._send = send
        self.send_bytes = send_bytes
        self.desk = desk
        self.kept: tuple[int, int, int] | None = None
        self.files = FileNames()
        """Those of states that the studio keeps on disk."""
        self.files_folder: Path | None = None
        """Where they are, once the studio has kept some."""
        self.break_off: Callable[[object], None] = lambda _: None
        """Breaks the work on the answer to a request off, by its id."""

    def carry_out(self, request: Request) -> Answer:
        """Carry one command out; returns the answer to it."""
        command = command_of(request["command"], has_run=self.run is not None)
        if command.name in beginnings.NAMES:
            answer = self._begin(command.name, request)
        else:
            answer = WORKER[command.name](self, request)
        if command.name not in UNSEEN:
            self.frames.refresh()
        return answer

    def _begin(self, name: str, request: Request) -> Answer:
        """Begin another run, and let the server know whether it has begun or the old one goes on."""
        number, begun = int(request.get("number", 0)), False
        before, self.number = self.number, number
        run, held = self.run, held_aside(self.aside)
        answer = None
        try:
            answer = WORKER[name](self, request)
            begun = True
        finally:
            self.number = number if begun else before
            aside = self.aside
            changed = held_aside(self.aside) != held
            told = None
            if aside is not None:
                displaced = isinstance(answer, dict) and answer.get("ended") is not None
                told = {
                    "new": aside.run is run,
                    "changed": changed,
                    "of_it": aside.of_it,
                    "displaced": displaced,
                }
            origin = None if self.origin is None else self.origin.data()
            self._send("begun", number=number, ok=begun, aside=told, origin=origin)
        return answer

    def way_back(self, ended: str | None = None) -> dict[str, Any]:
        """For an answer: the title of the other run that can be taken back; None where there is none.

        ``ended`` is the title of one that can be taken back no more.
        """
        aside = self.aside
        if aside is None or aside.of_it or not aside.run.would_be_missed:
            return {"aside": None, "ended": ended}
        return {"aside": aside.title, "ended": ended}

    @property
    def title(self) -> str:
        """The title of the run, with what was changed."""
        return named(self.current.live, self.origin or self.current.live.scenario).title

    @property
    def current(self) -> StudioRun:
        """The run."""
        assert self.run is not None
        return self.run

    def set_aside(self, *, of_it: bool) -> str | None:
        """Keep the run, paused, to be taken back; the next one comes ``of_it``, or is another.

        A run that came of the one that is set aside already becomes a branch of that; one that nobody would
        miss leaves what is set aside as it is. Returns the title of the run that was set aside before where
        it has ended.
        """
        run, before = self.current, self.aside
        run.pause()
        if before is not None and before.of_it:
            before.take_in(run)
            self.aside = before._replace(of_it=of_it)
            return None
        if not (of_it or run.would_be_missed or (before is None and run.wanted)):
            return None
        self.aside = SetAside(run, self.origin, self.frames.loaded, of_it)
        return before.title if before is not None and before.run.would_be_missed else None

    def take(
        self, run: StudioRun, running: bool, origin: Scenario | None = None, loaded: int | None = None
    ) -> None:
        """Continue with another run, under the same speed limit, up to its scenario's end.

        Without an origin it is one of its own; ``loaded`` is the start that loaded its scenario, where
        that is an earlier one.
        """
        self.origin = origin or run.live.scenario
        self.frames.loaded = self.number if loaded is None else loaded
        if self.run:
            run.speed.limit = self.run.speed.limit
        self.run = run
        aside = set() if self.aside is None else self.aside.run.branches.series
        self.desk.keep_only(run.branches.series | aside)
        self.announce()
        if running:
            run.run_to_its_end()

    @WORKER.handles("attach")
    def attach(self, _: Request) -> None:
        """A browser came."""
        self.frames.attach()
        if self.run is not None:
            self.current.measures.resend()
            self.describe()

    @WORKER.handles("confirm")
    def confirm(self, _: Request) -> None:
        """The browser has drawn a frame."""
        self.frames.confirm()

    @WORKER.handles("view")
    def view(self, request: Request) -> None:
        """Send these fields beside the surface from now on."""
        self.frames.fields = [str(name) for name in request["fields"]]

    @WORKER.handles("paths")
    def paths(self, request: Request) -> None:
        """Send the paths of ``count`` grains from now on, where the model follows grains."""
        self.frames.paths.request(int(request["count"]))

    @WORKER.handles("run")
    def start_running(self, request: Request) -> None:
        """Run ``steps`` steps, or up to step ``until``, whichever comes first; else to the scenario's end.

        Steps stop at that end, too, unless they are those of an ``order`` to two runs, which are counted by
        who leads them. From that end on it runs on and on.
        """
        targets = [int(request["until"])] if request.get("until") is not None else []
        self.order = request.get("order")
        if request.get("steps") is not None:
            targets.append(self.current.live.steps_done + max(1, int(request["steps"])))
            if self.order is None and not self.current.past_its_end:
                targets.append(self.current.end)
        if targets:
            self.current.run(min(targets), bool(request.get("brief")))
        else:
            self.current.run_to_its_end()
        target = self.current.target
        if target is not None and not self.current.busy:
            self.arrive()

    def arrive(self) -> None:
        """Let the server know that the run has done the steps that it was asked for."""
        self._send("arrived", step=self.current.live.steps_done, order=self.order)

    @WORKER.handles("pause")
    def pause(self, _: Request) -> None:
        """Pause."""
        self.current.pause()

    @WORKER.handles("limit")
    def limit(self, request: Request) -> None:
        """Do at most ``rate`` steps a second; null for no limit."""
        rate, speed = request["rate"], self.current.speed
        speed.limit = None if rate is None else min(max(float(rate), SLOWEST), FASTEST)
        speed.restart()

    @WORKER.handles("set")
    def set_parameter(self, request: Request) -> None:
        """A parameter of the model takes a new value."""
        self.current.look_now()
        self.current.live.apply(SetParameter(key=str(request["key"]), value=request["value"]))
        self.current.carry_on()
        self.describe(changed=True)

    @WORKER.handles("wind")
    def set_wind(self, request: Request) -> None:
        """Replace the wind from now on."""
        self.current.look_now()
        self.current.live.apply(SetWind(wind=request["wind"]))
        self.current.carry_on()
        self.describe(changed=True)

    @WORKER.handles("stroke")
    def stroke(self, request: Request) -> None:
        """Paint at every one of ``places``; ``begin`` and ``end`` mark the limits of a gesture."""
        run = self.current
        run.look_now()
        if request.get("begin"):
            run.painting.begin(run.live)
        elif not run.painting.done:
            raise BarchanError("a stroke without a beginning")
        for stroke in strokes_in(request):
            run.painting.stroke(run.live, stroke)
        if request.get("end"):
            run.painting.end(run.live)
            run.carry_on()
            if run.end != self._told_end:
                self.describe()

    @WORKER.handles("undo")
    def undo(self, _: Request) -> None:
        """Undo the last gesture."""
        self.current.change(self.current.painting.undo(self.current.live))

    @WORKER.handles("redo")
    def redo(self, _: Request) -> None:
        """Repeat the gesture that was undone last."""
        self.current.change(self.current.painting.redo(self.current.live))

    @WORKER.handles("look")
    def look(self, request: Request) -> None:
        """Look back; without a step at the newest state."""
        if request.get("step") is None:
            self.current.look_now()
        else:
            self.current.look(int(request["step"]))

    @WORKER.handles("branch")
    def branch(self, _: Request) -> Answer:
        """Continue from the state that is looked at."""
        self.current.branch()
        self.announce()
        return {"step": self.current.live.steps_done}

    @WORKER.handles("switch")
    def switch(self, request: Request) -> None:
        """Return to another branch."""
        self.current.switch(int(request["branch"]))
        self.announce()

    def warn(self, text: str) -> None:
        """Let the page say what could not be had."""
        self._send("refused", id=None, command="open_folder", text=text, problems=[])

    def announce(self) -> None:
        """Send everything again: the run's past is another one."""
        self.frames.forget()
        self.current.measures.resend()
        self.describe()

    def describe(self, *, changed: bool = False) -> None:
        """Send what the run consists of; ``changed`` where the last of its changes was made just now."""
        run = self.current
        self._told_end = run.end
        branches = run.branches.listing(run.live.steps_done)
        content = description(run.live, self.origin or run.live.scenario)
        overlay = self.frames.overlay
        if overlay is not None and overlay.fits(run.live):
            content["fields"] += overlay.fields()
        self._send(
            "scenario",
            **content,
            step=run.live.steps_done,
            end=self._told_end,
            changed=changed,
            loaded=self.frames.loaded,
            branches=branches,
            branch=run.branches.current,
            bookmarks=run.bookmarks.data(),
        )
