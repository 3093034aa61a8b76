"""What a worker can be told to do, one method an order."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from barchan.errors import BarchanError
from barchan.scenario import validate
from barchan.simulation import AnyStroke, BrushStroke, SetParameter, SetWind, event_from
from barchan.studio.worker.run import StudioRun, started

if TYPE_CHECKING:
    from barchan.studio.worker.loop import Worker

Order = dict[str, Any]

BEFOREHAND = frozenset(("create", "open", "attach", "confirm", "view", "paths"))
"""Orders that need no run yet."""


class Orders:
    """Carries orders out on the worker's run."""

    def __init__(self, worker: "Worker") -> None:
        """No run yet."""
        self.worker = worker
        self.run: StudioRun | None = None

    def obey(self, order: Order) -> dict[str, Any] | None:
        """Carry one order out; what is to be answered."""
        method: Callable[[Order], dict[str, Any] | None] | None = getattr(self, f"do_{order['do']}", None)
        if method is None:
            raise BarchanError(f"unknown order '{order['do']}'")
        if self.run is None and order["do"] not in BEFOREHAND:
            raise BarchanError("there is no run yet")
        result = method(order)
        if order["do"] != "confirm":
            self.worker.stale = True
            self.worker.fields.at_once()
        return result

    @property
    def going(self) -> StudioRun:
        """The run."""
        assert self.run is not None
        return self.run

    def do_attach(self, _: Order) -> None:
        """A browser came."""
        self.worker.attach()

    def do_confirm(self, _: Order) -> None:
        """The browser has drawn a frame."""
        self.worker.credit += 1

    def do_view(self, order: Order) -> None:
        """Send these fields beside the surface from now on."""
        self.worker.wanted = [str(name) for name in order["fields"]]

    def do_paths(self, order: Order) -> None:
        """Send the paths of so many grains from now on, where the model follows any."""
        self.worker.flights.ask(int(order["count"]))

    def do_create(self, order: Order) -> None:
        """Begin a scenario."""
        self._take(started(validate(order["scenario"], "scenario")), order)

    def do_restart(self, order: Order) -> None:
        """Begin again with the same scenario and seed."""
        running = self.going.running
        self._take(started(self.going.live.scenario), {"running": running, **order})

    def do_open(self, order: Order) -> None:
        """Take up the run in an archive, paused where it ended."""
        from barchan.studio.worker.loop import folder_of
        from barchan.studio.worker.saved_runs import reopened

        self._take(reopened(folder_of(order)), order)

    def _take(self, run: StudioRun, order: Order) -> None:
        limit = self.run.pace.limit if self.run else None
        self.run = run
        run.pace.limit = limit
        self._anew()
        if order.get("running"):
            run.run()

    def _anew(self) -> None:
        """What the browser knew of the run's past holds no more."""
        self.worker.ground_sent = None
        self.worker.flights.again()
        self.worker.history_sent = []
        self.going.gauges.again()
        self.worker.describe()

    def do_run(self, order: Order) -> None:
        """Run on, or ``steps`` steps, or up to step ``until``."""
        target = order.get("until")
        if "steps" in order:
            target = self.going.live.steps_done + max(1, int(order["steps"]))
        self.going.run(target, bool(order.get("brief")))
        if target is not None and not self.going.busy:
            self.worker.tell("arrived", step=self.going.live.steps_done)

    def do_pause(self, _: Order) -> None:
        """Pause."""
        self.going.pause()

    def do_limit(self, order: Order) -> None:
        """Do so many steps a second at most; null for no limit."""
        limit = order["rate"]
        self.going.pace.limit = None if limit is None else min(max(float(limit), 0.1), 1e6)
        self.going.pace.restart()

    def do_set(self, order: Order) -> None:
        """A parameter of the model takes a new value."""
        self.going.look_now()
        self.going.live.apply(SetParameter(key=str(order["key"]), value=order["value"]))
        self.worker.describe()

    def do_wind(self, order: Order) -> None:
        """Another wind from now on."""
        self.going.look_now()
        self.going.live.apply(SetWind(wind=order["wind"]))
        self.worker.describe()

    def do_rose(self, _: Order) -> dict[str, Any]:
        """Tell the roses of the wind, where it is a record."""
        from barchan.studio.worker.rose import rose_of

        return {"rose": rose_of(self.going.live)}

    def do_stroke(self, order: Order) -> None:
        """Paint: ``begin`` and ``end`` tell where a gesture begins and ends."""
        run = self.going
        run.look_now()
        if order.get("begin"):
            run.painting.begin(run.live)
        elif not run.painting.done:
            raise BarchanError("a stroke without a beginning")
        if "stroke" in order:
            run.painting.stroke(run.live, _stroke(order["stroke"]))
        if order.get("end"):
            run.painting.end(run.live)

    def do_undo(self, _: Order) -> None:
        """Undo the last gesture."""
        self.going.change(self.going.painting.undo(self.going.live))

    def do_redo(self, _: Order) -> None:
        """Do again what was undone."""
        self.going.change(self.going.painting.redo(self.going.live))

    def do_look(self, order: Order) -> None:
        """Look back; without a step at the run as it is now."""
        if order.get("step") is None:
            self.going.look_now()
        else:
            self.going.look(int(order["step"]))

    def do_branch(self, _: Order) -> None:
        """Go on from what is looked at."""
        self.going.branch()
        self._anew()

    def do_switch(self, order: Order) -> None:
        """Go back to another branch."""
        self.going.switch(int(order["branch"]))
        self._anew()

    def do_space_time(self, order: Order) -> dict[str, Any]:
        """Tell the section along a line over the whole run."""
        from barchan.studio.worker.spacetime import space_time

        return space_time(self.going, [float(place) for place in order["line"]])

    def do_save(self, order: Order) -> dict[str, Any]:
        """Save the run as an archive."""
        from barchan.studio.worker.loop import folder_of
        from barchan.studio.worker.saved_runs import shelve

        frames = shelve(self.going, folder_of(order))
        return {"frames": frames, "step": self.going.live.steps_done}


def _stroke(data: Any) -> AnyStroke:
    """A stroke of any brush from what the browser says of it."""
    event = event_from({"kind": "stroke", **data})
    if not isinstance(event, BrushStroke):
        raise BarchanError(f"'{event.kind}' is no stroke")
    return event
