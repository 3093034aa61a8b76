"""Those who see the runs: one browser that commands, and any number that only watch."""

import asyncio
from collections import deque
from typing import Any

from barchan.studio.protocol import FRAMES_IN_FLIGHT, Request, message
from barchan.studio.server.newest_frame import NewestFrame

MOST_WATCHERS = 100
"""Browsers that may watch at once."""

DISMISSED = b""
"""Data that close the connection of a browser that another one has replaced."""

FOR_ALL = ("scenario", "compiling")
"""Messages of workers that concern those who watch, too; the others answer the one who commands."""


class Viewer:
    """One browser: what is to be sent to it, and which frames it has."""

    def __init__(self, commands: bool) -> None:
        """A browser that has nothing yet; ``commands`` is false for one that only watches."""
        self.commands = commands
        self.outbox: asyncio.Queue[bytes] = asyncio.Queue()
        self._on_the_way: dict[str, deque[int]] = {}
        self._has: dict[str, int] = {}

    def send(self, data: bytes) -> None:
        """Put data into the row of what is to be sent."""
        self.outbox.put_nowait(data)

    def refuse(self, request: Request, text: str, problems: list[dict[str, Any]]) -> None:
        """Answer a request that is not carried out."""
        named = {"id": request.get("id"), "command": request.get("command")}
        self.send(message("refused", **named, text=text, problems=problems))

    def offer(self, run: str, newest: NewestFrame) -> None:
        """Send a run's newest frame, unless the browser has it, or too many are on the way to it."""
        on_the_way = self._on_the_way.setdefault(run, deque())
        had = self._has.get(run, 0)
        if had < newest.number and len(on_the_way) < FRAMES_IN_FLIGHT:
            self.send(newest.since(had))
            on_the_way.append(newest.number)
            self._has[run] = newest.number

    def confirm(self, run: str) -> int:
        """The browser has drawn the frame that was on the way to it longest; its number, 0 for none."""
        on_the_way = self._on_the_way.get(run)
        return on_the_way.popleft() if on_the_way else 0

    def forget(self, run: str) -> None:
        """The run has ended, or its frames are counted from 1 on again."""
        self._on_the_way.pop(run, None)
        self._has.pop(run, None)


class Audience:
    """The one who commands, those who watch, and what each of them needs to be shown first."""

    def __init__(self) -> None:
        """Nobody yet."""
        self.owner: Viewer | None = None
        self.watchers: list[Viewer] = []
        self._newest: dict[str, NewestFrame] = {}
        self._confirmed: dict[str, int] = {}
        self._scenarios: dict[str, bytes] = {}
        self._look: dict[str, Any] | None = None

    @property
    def viewers(self) -> list[Viewer]:
        """All browsers."""
        return [*([self.owner] if self.owner else []), *self.watchers]

    @property
    def is_full(self) -> bool:
        """Whether no more browsers may watch."""
        return len(self.watchers) >= MOST_WATCHERS

    def join(self, viewer: Viewer) -> bool:
        """A browser came; returns whether it is the only one. One that commands replaces the one before."""
        if viewer.commands:
            if self.owner is not None:
                self.owner.send(DISMISSED)
            self.owner = viewer
        else:
            self.watchers.append(viewer)
        return len(self.viewers) == 1

    def leave(self, viewer: Viewer) -> None:
        """A browser went."""
        if viewer is self.owner:
            self.owner = None
        elif viewer in self.watchers:
            self.watchers.remove(viewer)
            self.count()

    def count(self) -> None:
        """Let the one who commands know how many watch."""
        self.to_owner(message("watchers", count=len(self.watchers)))

    def to_all(self, data: bytes) -> None:
        """Send everybody a message."""
        for viewer in self.viewers:
            viewer.send(data)

    def to_owner(self, data: bytes) -> None:
        """Send the one who commands a message."""
        if self.owner is not None:
            self.owner.send(data)

    def show(self, viewer: Viewer) -> None:
        """Send a browser that came later what the others have."""
        for data in self._scenarios.values():
            viewer.send(data)
        if self._look is not None and not viewer.commands:
            viewer.send(message("look", look=self._look))
        for run, newest in self._newest.items():
            viewer.offer(run, newest)

    def look(self, look: dict[str, Any]) -> None:
        """Let those who watch see the surface as the one who commands sees it."""
        self._look = look
        for viewer in self.watchers:
            viewer.send(message("look", look=look))

    def on_frame(self, run: str, data: bytes) -> None:
        """A worker has sent a frame: everybody gets it who has drawn the ones before."""
        newest = self._newest.setdefault(run, NewestFrame())
        newest.take(data)
        for viewer in self.viewers:
            viewer.offer(run, newest)

    def on_message(self, run: str, kind: str, data: bytes) -> None:
        """A worker has sent a message."""
        if kind == "scenario":
            self._scenarios[run] = data
        if kind in FOR_ALL:
            self.to_all(data)
        else:
            self.to_owner(data)

    def confirm(self, viewer: Viewer, run: str) -> int:
        """A browser has drawn a frame; how many frames are drawn by it that nobody had drawn before."""
        drawn = viewer.confirm(run)
        newest = self._newest.get(run)
        if newest is not None:
            viewer.offer(run, newest)
        new = max(0, drawn - self._confirmed.get(run, 0))
        self._confirmed[run] = self._confirmed.get(run, 0) + new
        return new

    def forget(self, run: str) -> None:
        """A run has ended, or its worker will send everything again."""
        self._newest.pop(run, None)
        self._confirmed.pop(run, None)
        self._scenarios.pop(run, None)
        for viewer in self.viewers:
            viewer.forget(run)
