"""The session: one or two simulations, and the browser that looks at them."""

import asyncio
import json
from pathlib import Path
from typing import Any

from barchan.errors import BarchanError, ScenarioError
from barchan.models import models
from barchan.scenario import Scenario, validate
from barchan.studio.protocol import PROTOCOL, is_frame, message
from barchan.studio.server.lockstep import Pair
from barchan.studio.server.queries import ANSWERS
from barchan.studio.server.worker_handle import Link
from barchan.studio.server.workspace import Store

Order = dict[str, Any]

FIRST, SECOND = "a", "b"

TO_WORKERS = frozenset(("confirm", "view", "paths", "rose", "set", "wind", "stroke", "undo", "redo")) | {
    *("run", "pause", "limit", "restart", "look", "branch", "switch", "space_time")
}
"""Orders that workers carry out as they come from the browser."""


class Session:
    """Workers, the browser that is there, and what passes between them."""

    def __init__(self, store: Store, scenario: Scenario | None = None, archive: Path | None = None) -> None:
        """Prepare a session that begins with a scenario or an archive."""
        self.store = store
        self.links: dict[str, Link] = {}
        self.scenarios: dict[str, dict[str, Any]] = {}
        """What each worker runs, as its changes during the run have left it."""
        self.pair: Pair | None = None
        self.outbox: asyncio.Queue[bytes] | None = None
        if archive is not None:
            self.first: Order = {"do": "open", "folder": str(archive)}
        else:
            data = (scenario or Scenario()).seeded().data()
            store.trust(data)
            self.first = {"do": "create", "scenario": data, "running": True}

    def start(self) -> None:
        """Start the first worker."""
        self._link(FIRST).send(**self.first)

    def close(self) -> None:
        """End all workers."""
        for link in self.links.values():
            link.close()
        self.links.clear()

    def attach(self) -> asyncio.Queue[bytes]:
        """A browser came; what it is to be told comes through the queue. An earlier one is dismissed."""
        if self.outbox is not None:
            self.outbox.put_nowait(b"")
        self.outbox = asyncio.Queue()
        running = self.pair is not None and self.pair.running
        self._tell("hello", protocol=PROTOCOL, runs=list(self.links), running=running)
        for link in self.links.values():
            link.send(do="attach")
            if not link.process.is_alive():
                self._tell("lost", run=link.name, code=link.process.exitcode)
        return self.outbox

    def detach(self, outbox: asyncio.Queue[bytes]) -> None:
        """A browser went."""
        if self.outbox is outbox:
            self.outbox = None

    def hear(self, text: str) -> None:
        """The browser said something; what cannot be done is answered."""
        order: Order = {}
        try:
            heard = json.loads(text)
            if not isinstance(heard, dict) or not isinstance(heard.get("do"), str):
                raise BarchanError("a message must be an object that says what to do")
            order = heard
            self._obey(order)
        except ScenarioError as error:
            self._refuse(order, str(error), [vars(problem) for problem in error.problems])
        except (BarchanError, LookupError, TypeError, ValueError) as error:
            self._refuse(order, str(error) or type(error).__name__, [])

    def _tell(self, what: str, **content: Any) -> None:
        if self.outbox is not None:
            self.outbox.put_nowait(message(tell=what, **content))

    def _refuse(self, order: Order, text: str, problems: list[dict[str, Any]]) -> None:
        self._tell("refused", re=order.get("re"), order=order.get("do"), text=text, problems=problems)

    def _obey(self, order: Order) -> None:
        do = order["do"]
        if do in TO_WORKERS:
            self._pass_on(order)
        elif do in ANSWERS:
            self._tell("done", re=order.get("re"), **ANSWERS[do](self.store, order))
        elif do in _ORDERS:
            _ORDERS[do](self, order)
        else:
            raise BarchanError(f"unknown order '{do}'")

    def _pass_on(self, order: Order) -> None:
        """Let the worker that is meant, or where none is named all of them, carry an order out."""
        if self.pair is not None and order["do"] == "run":
            self.pair.run(order.get("steps"))
        elif self.pair is not None and order["do"] == "pause":
            self.pair.pause()
        else:
            self.store.check(order)
            named = order.get("run")
            for name in [named] if named is not None else list(self.links):
                self.links[name].send(**{**order, "run": None})

    def _link(self, name: str) -> Link:
        """The worker of that name, a new one where there is none or it was lost."""
        link = self.links.get(name)
        if link is None or not link.process.is_alive():
            link = self.links[name] = Link(name, self._heard, self._lost)
            if self.outbox is not None:
                link.send(do="attach")
        return link

    def _heard(self, link: Link, data: bytes) -> None:
        """A worker said something: the browser hears it, and what concerns all workers is noted."""
        if self.links.get(link.name) is not link:
            return
        if not is_frame(data):
            told = json.loads(data)
            if told["tell"] == "scenario":
                self.scenarios[link.name] = told["scenario"]
            elif told["tell"] == "arrived" and self.pair is not None:
                self.pair.arrived(link.name)
        if self.outbox is not None:
            self.outbox.put_nowait(data)

    def _lost(self, link: Link) -> None:
        """A worker ended without being asked to."""
        if self.links.get(link.name) is link:
            link.process.join()
            if self.pair is not None:
                self.pair.pause()
            self._tell("lost", run=link.name, code=link.process.exitcode)

    def _create(self, order: Order) -> None:
        """Begin a scenario; where there are two workers the other one's, too, with its own model."""
        self.store.check(order["scenario"])
        data = validate(order["scenario"]).seeded().data()
        name = SECOND if self.pair is not None and order.get("run") == SECOND else FIRST
        begun = {name: data}
        if self.pair is not None:
            other = FIRST if name == SECOND else SECOND
            begun[other] = {**data, "model": self.scenarios[other]["model"]}
        self._begin(begun, bool(order.get("running", True)))

    def _begin(self, scenarios: dict[str, dict[str, Any]], running: bool) -> None:
        """Begin these scenarios, together where there are two."""
        alone = len(scenarios) == 1
        self.scenarios = scenarios
        for name, data in scenarios.items():
            self._link(name).send(do="create", scenario=data, running=running and alone)
        self.pair = None if alone else Pair(self.links, lambda runs: self._tell("pair", running=runs))
        if self.pair is not None and running:
            self.pair.run()

    def _compare(self, order: Order) -> None:
        """Run another model beside, on the same ground, under the same wind, from the same seed."""
        first = self.scenarios[FIRST]
        if order["model"] not in models():
            raise BarchanError(f"no model '{order['model']}'; allowed: {', '.join(models())}")
        second = validate({**first, "model": {"name": order["model"]}}).data()
        self._begin({FIRST: first, SECOND: second}, running=True)
        self._tell("runs", runs=list(self.links))

    def _alone(self, _: Order) -> None:
        """End the second simulation."""
        self.pair = None
        link = self.links.pop(SECOND, None)
        if link is not None:
            link.close()
        self.scenarios.pop(SECOND, None)
        self._tell("runs", runs=list(self.links))

    def _revive(self, _: Order) -> None:
        """Start lost workers again, from the beginning of what they ran."""
        if self.scenarios:
            self._begin(dict(self.scenarios), running=True)
        else:
            self.start()

    def _save(self, order: Order) -> None:
        """Save a run as an archive in the session's folder."""
        folder = self.store.run(str(order["name"]))
        self.links[order.get("run") or FIRST].send(do="save", folder=str(folder), re=order.get("re"))

    def _open(self, order: Order) -> None:
        """Take up an archive of the session's folder."""
        folder = self.store.run(str(order["name"]))
        if folder.name not in self.store.runs():
            raise BarchanError(f"no run '{folder.name}' in {self.store.folder}")
        self._alone(order)
        self._link(FIRST).send(do="open", folder=str(folder), re=order.get("re"))


_ORDERS = {
    "create": Session._create,
    "compare": Session._compare,
    "alone": Session._alone,
    "revive": Session._revive,
    "save": Session._save,
    "open": Session._open,
}
"""What the session does itself."""
