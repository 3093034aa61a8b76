"""The widget: what a notebook shows, and what Python asks of it."""

import time
from functools import cache
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from barchan.errors import BarchanError
from barchan.fields import GROUND
from barchan.notebook.host import Host
from barchan.simulation import Simulation
from barchan.studio.colours import colours
from barchan.studio.protocol import fields_in
from barchan.studio.worker.frame_fields import fields_of
from barchan.studio.worker.run import StudioRun

CLIENT = Path(__file__).parents[1] / "studio" / "client" / "notebook.js"

NOT_BUILT = (
    "the view for notebooks is not built; in a checkout of the sources build it with: "
    "cd web && npm ci && npm run bundle"
)

OF_THE_PAGE = ("natural", "elevation", "depth", "slope")
"""Fields that the page derives from the surface by itself."""

LOOK = 0.02
"""Seconds between two looks at a run that is waited for."""


class View(anywidget.AnyWidget):
    """A view of one run; made by ``barchan.notebook.view``.

    Buttons and methods do the same: both send commands to a thread that the run lives in. Methods raise
    BarchanError where a command is refused and once the view is closed; buttons show why below the scene.
    """

    _esm = traitlets.Unicode().tag(sync=True)
    description = traitlets.Dict().tag(sync=True)
    """What the run consists of, as the studio describes it to its page."""
    ground_frame = traitlets.Bytes().tag(sync=True)
    """The newest frame that holds the ground, in the studio's form (``barchan.studio.protocol``)."""
    frame = traitlets.Bytes().tag(sync=True)
    """The newest frame after it; fields that it lacks are as they were. Empty where there is none."""
    colours = traitlets.Dict().tag(sync=True)
    """Colour maps by name."""
    continues = traitlets.Bool(True).tag(sync=True)
    """Whether the run can go on; frames alone can only be looked at."""
    field = traitlets.Unicode("natural").tag(sync=True)
    """The field that colours the surface."""
    height = traitlets.Int(420, min=80, max=4000).tag(sync=True)
    """Height of the scene (pixels)."""
    error = traitlets.Unicode("")
    """Why the last command of a button was refused; empty where none was."""

    def __init__(self, run: StudioRun, **traits: Any) -> None:
        """Show a run, paused.

        Raises BarchanError where the client is not built and for a field or a height that is not allowed.
        """
        self._fields = (*OF_THE_PAGE, *(field["name"] for field in fields_of(run.live)))
        self._host: Host | None = None
        try:
            super().__init__(_esm=_module(), colours=dict(colours()), continues=run.continues, **traits)
        except traitlets.TraitError as error:
            raise BarchanError(str(error)) from error
        self._host = Host(run, self._on_frame, self._on_message)
        self.on_msg(self._on_custom)
        self._ask("attach")

    @property
    def step(self) -> int:
        """The step that is shown."""
        return self._run.shown.steps_done

    @property
    def steps(self) -> list[int]:
        """The steps that can be looked at."""
        return self._run.history.steps

    @property
    def running(self) -> bool:
        """Whether steps are being done."""
        return self._run.busy

    def run(self, steps: int | None = None, *, until: int | None = None) -> None:
        """Run some ``steps``, up to a step, or on and on; returns at once, see ``wait``."""
        self._refuse_frames()
        asked = {"steps": steps, "until": until}
        self._ask("run", **{name: value for name, value in asked.items() if value is not None})

    def pause(self) -> None:
        """Pause."""
        self._ask("pause")

    def look(self, step: int | None) -> None:
        """Look at the kept state nearest to a step; None for the newest state."""
        self._ask("look", step=step)

    def limit(self, rate: float | None) -> None:
        """Do at most ``rate`` steps a second; None for no limit."""
        self._ask("limit", rate=rate)

    def wait(self, seconds: float = 600.0) -> None:
        """Wait until no steps are being done; raises BarchanError where that takes more than ``seconds``."""
        end = time.monotonic() + seconds
        while self.running:
            if time.monotonic() > end:
                raise BarchanError(f"still running after {seconds:g} s, at step {self.step}")
            time.sleep(LOOK)

    def simulation(self) -> Simulation:
        """The simulation in the state that is shown, as a copy; pauses the run.

        Raises BarchanError for a frame, which lacks what the model remembers.
        """
        self._refuse_frames()
        if self._run.looking is not None and not self._run.can_branch:
            raise BarchanError("a saved frame can be looked at; the newest state is the one to go on from")
        self.pause()
        return Simulation.from_state(self._run.shown.state())

    def close(self) -> None:
        """End the run and let everything go, in the notebook too."""
        if self._host is not None:
            self._host.close()
            self._host = None
        super().close()

    def _refuse_frames(self) -> None:
        if not self.continues:
            raise BarchanError("frames of a run can be looked at; to go on takes its scenario or its folder")

    @property
    def _run(self) -> StudioRun:
        return self._alive.run

    @property
    def _alive(self) -> Host:
        if self._host is None:
            raise BarchanError("the view is closed")
        return self._host

    def _ask(self, command: str, **content: Any) -> None:
        self._alive.ask(command, **content)

    @traitlets.validate("field")
    def _known_field(self, proposal: traitlets.Bunch) -> str:
        name: str = proposal["value"]
        if name not in self._fields:
            raise traitlets.TraitError(f"no field '{name}' to colour by; there are {', '.join(self._fields)}")
        return name

    def _on_frame(self, data: bytes) -> None:
        if GROUND.name in fields_in(data):
            self.frame = b""
            self.ground_frame = data
        else:
            self.frame = data

    def _on_message(self, message: dict[str, Any]) -> None:
        if message["type"] == "scenario":
            self.description = message
            return
        if message["type"] == "refused":
            self.error = message["text"]
        self.send(message)

    def _on_custom(self, _: Any, content: Any, _buffers: Any) -> None:
        """Carry out what a button asks for."""
        self.error = ""
        try:
            self._alive.send(content)
        except (BarchanError, AttributeError, TypeError, ValueError) as error:
            self._on_message({"type": "refused", "id": None, "text": str(error), "problems": []})


@cache
def _module() -> str:
    if not CLIENT.is_file():
        raise BarchanError(NOT_BUILT)
    return CLIENT.read_text("utf-8")
