"""One answer of several workers: each does its part, and all of it counts or nothing."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from barchan.studio.server.session import Session

Answers = dict[str, dict[str, Any]]
"""The contents of the workers' answers, by run, in the order in which they were asked for."""


@dataclass
class _Joint:
    number: int
    runs: tuple[str, ...]
    open: set[str]
    """Runs whose workers are at their part."""
    done: Callable[[Answers], None]
    failed: Callable[[str, Answers], None]
    progress: Callable[[int, int], None] | None
    request: Any
    answers: Answers = field(default_factory=dict)
    counts: dict[str, tuple[int, int]] = field(default_factory=dict)
    error: str = ""

    @property
    def in_order(self) -> Answers:
        """The answers that there are; they came in any order."""
        return {run: self.answers[run] for run in self.runs if run in self.answers}

    def id(self, run: str) -> str:
        """The id of a worker's part: the session's own, never a browser's."""
        return f"joint {self.number} {run}"


def is_joint(content: dict[str, Any]) -> bool:
    """Whether a request to a worker, or its answer, is a part of a joint one."""
    given = content.get("id")
    return isinstance(given, str) and given.startswith("joint ")


class JointAnswers:
    """The joint answers that are in the making."""

    def __init__(self, session: "Session") -> None:
        """None yet."""
        self._session = session
        self._open: dict[int, _Joint] = {}
        self._count = 0

    def ask(
        self,
        parts: dict[str, dict[str, Any]],
        done: Callable[[Answers], None],
        failed: Callable[[str, Answers], None],
        progress: Callable[[int, int], None] | None = None,
        request: Any = None,
        send: Callable[[str, dict[str, Any]], None] | None = None,
    ) -> None:
        """Let workers carry out ``parts`` by run, then call ``done``, or ``failed`` once none works on it.

        ``failed`` is told why, and the answers of those that have done their part.
        ``request`` is the id of the browser's request, by which it can be broken off; ``send`` passes a part
        on where that takes more than the worker that there is.
        """
        self._count += 1
        runs = tuple(parts)
        joint = self._open[self._count] = _Joint(
            self._count, runs, set(runs), done, failed, progress, request
        )
        for run, part in parts.items():
            (send or self._forward)(run, {**part, "id": joint.id(run)})

    def takes(self, content: dict[str, Any]) -> bool:
        """Take a worker's message that concerns a part; returns whether it does."""
        if not is_joint(content):
            return False
        number, run = content["id"].split(" ")[1:]
        joint = self._open.get(int(number))
        if joint is None or run not in joint.open:
            return True
        if content["type"] == "progress":
            self._count_on(joint, run, content)
        elif content["type"] == "refused":
            self._fail(joint, content["text"], {run})
        else:
            joint.answers[run] = content
            joint.open.discard(run)
            self._end(joint)
        return True

    def break_off(self, request: Any) -> None:
        """Break off what answers a request of the browser."""
        for joint in [one for one in self._open.values() if request is not None and one.request == request]:
            self._fail(joint, "broken off", set())

    def lose(self, run: str) -> None:
        """The worker of a run has ended."""
        for joint in [one for one in self._open.values() if run in one.open]:
            self._fail(joint, f"the process of run {run} has ended", {run})

    def _forward(self, run: str, part: dict[str, Any]) -> None:
        self._session.workers[run].forward(part)

    def _count_on(self, joint: _Joint, run: str, content: dict[str, Any]) -> None:
        joint.counts[run] = content["done"], content["of"]
        if joint.progress is not None:
            joint.progress(*(sum(numbers) for numbers in zip(*joint.counts.values(), strict=True)))

    def _fail(self, joint: _Joint, why: str, ended: set[str]) -> None:
        joint.open -= ended
        if not joint.error:
            joint.error = why
            for run in joint.open:
                self._session.workers[run].send("break_off", of=joint.id(run))
        self._end(joint)

    def _end(self, joint: _Joint) -> None:
        if joint.open:
            return
        del self._open[joint.number]
        if joint.error:
            joint.failed(joint.error, joint.in_order)
        else:
            joint.done(joint.in_order)
