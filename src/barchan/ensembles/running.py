"""Running an ensemble: tasks are handed out a few at a time, and again where that can help."""

from collections import deque
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from dataclasses import dataclass, field
from pathlib import Path

from barchan.ensembles.kernel_choices import one_of_each
from barchan.ensembles.plan import Member, Plan
from barchan.ensembles.reports import STOP, Failure, State, state_of, write_failure
from barchan.ensembles.task import Ended, bring_to_end, compile_kernels
from barchan.ensembles.workers import Workers, processes
from barchan.errors import BarchanError

ATTEMPTS = 3
"""Times that a member is tried where its worker died or the system failed."""

LOOK_EVERY = 0.5
"""Seconds between two looks at whether someone wants it to stop."""

DEAD = "its worker died"

Told = Callable[[Ended, int, int], None]
"""Called with each member that ended, how many have, and how many there are."""


@dataclass
class EnsembleOutcome:
    """How the members of an ensemble ended."""

    folder: Path
    done: list[Ended] = field(default_factory=list)
    failed: list[Ended] = field(default_factory=list)
    waiting: list[str] = field(default_factory=list)
    """Members that are not at their end: stopped on request, or in the hands of another process."""

    @property
    def complete(self) -> bool:
        """Whether every member that was asked for is at its end."""
        return not self.failed and not self.waiting

    def __repr__(self) -> str:
        ended = f"{len(self.done)} done, {len(self.failed)} failed, {len(self.waiting)} waiting"
        return f"<EnsembleOutcome in {self.folder}: {ended}>"


def run_ensemble(
    plan: Plan,
    folder: str | Path,
    workers: Workers | None = None,
    *,
    only: Iterable[State] = tuple(State),
    told: Told = lambda *_: None,
    stop: Callable[[], bool] = lambda: False,
) -> EnsembleOutcome:
    """Bring the members of a plan to their ends in a folder, those in the states ``only``.

    Finished members are left as they are, others go on from their newest checkpoints, so that a call after
    an interruption does what is missing. Without ``workers`` as many processes as cores work. A member whose
    worker dies, or that meets an error of the system, is tried up to ``ATTEMPTS`` times; no failure stops the
    others. Raises ArchiveError where the folder cannot be written, BarchanError where all workers are gone.
    """
    folder = Path(folder)
    plan.save(folder)
    (folder / STOP).unlink(missing_ok=True)
    workers = workers or processes()
    chosen = set(only)
    unique = {member.id: member for member in plan.members}
    asked = [member for member in unique.values() if state_of(folder, member.id) in chosen]
    try:
        return _Run(folder, workers, told, stop, len(asked)).all(asked)
    finally:
        (folder / STOP).unlink(missing_ok=True)


class _Run:
    """The members in work and those that wait."""

    def __init__(
        self, folder: Path, workers: Workers, told: Told, stop: Callable[[], bool], total: int
    ) -> None:
        self.workers, self.told, self.stop, self.total = workers, told, stop, total
        self.folder = folder
        self.outcome = EnsembleOutcome(folder)
        self.attempts: dict[str, int] = {}
        self.queue: deque[Member] = deque()
        self.at_work: dict[Future[Ended], Member] = {}
        self.executor: Executor | None = None

    def all(self, members: list[Member]) -> EnsembleOutcome:
        self.queue.extend(member for member in members if not self._is_done(member))
        try:
            if self.queue:
                self._compile()
            while self.at_work or (self.queue and not self.stop()):
                self._hand_out()
                ready, _ = wait(self.at_work, LOOK_EVERY, FIRST_COMPLETED)
                if self.stop():
                    (self.folder / STOP).touch()
                self._take_in(ready)
        finally:
            self._shut_down()
        self.outcome.waiting += [member.id for member in self.queue]
        return self.outcome

    def _is_done(self, member: Member) -> bool:
        done = state_of(self.folder, member.id) == State.DONE
        if done:
            self._end(Ended(member.id, State.DONE, ran=False))
        return done

    def _compile(self) -> None:
        """Compile what the members need once, before all workers would at the same time."""
        for member in one_of_each(self.queue):
            future = self._opened().submit(compile_kernels, member.text)
            while not future.done() and not self.stop():
                wait([future], LOOK_EVERY)
            if future.done() and isinstance(future.exception(), BrokenExecutor):
                self.executor = None

    def _opened(self) -> Executor:
        if self.executor is None:
            self.executor = self.workers.open()
        return self.executor

    def _hand_out(self) -> None:
        while self.queue and len(self.at_work) < self.workers.count and not self.stop():
            member = self.queue.popleft()
            try:
                home = str(self.folder.absolute())
                future = self._opened().submit(bring_to_end, home, member.id, member.text)
            except (BrokenExecutor, RuntimeError) as error:
                if not self.workers.replaceable:
                    raise BarchanError(_gone(self.workers, self.folder)) from error
                self.queue.appendleft(member)
                self.executor = None
                return
            self.at_work[future] = member

    def _take_in(self, ready: Iterable["Future[Ended]"]) -> None:
        for future in ready:
            member = self.at_work.pop(future)
            if future.cancelled():
                raise BarchanError(_gone(self.workers, self.folder))
            error = future.exception()
            if error is None:
                self._judge(member, future.result())
            elif isinstance(error, CancelledError):
                raise BarchanError(_gone(self.workers, self.folder))
            else:
                self._died(member, error)

    def _died(self, member: Member, error: BaseException) -> None:
        if isinstance(error, BrokenExecutor):
            self.executor = None
        ended = Ended(member.id, State.FAILED, True, message=f"{DEAD} ({error})", again=True)
        if self._spent(member):
            write_failure(self.folder, Failure(member.id, type(error).__name__, ended.message))
        self._judge(member, ended, counted=True)

    def _spent(self, member: Member) -> bool:
        self.attempts[member.id] = self.attempts.get(member.id, 0) + 1
        return self.attempts[member.id] >= ATTEMPTS

    def _judge(self, member: Member, ended: Ended, *, counted: bool = False) -> None:
        if ended.state == State.FAILED and ended.again:
            spent = self.attempts[member.id] >= ATTEMPTS if counted else self._spent(member)
            if not spent:
                self.queue.append(member)
                return
        self._end(ended)

    def _end(self, ended: Ended) -> None:
        if ended.state == State.DONE:
            self.outcome.done.append(ended)
        elif ended.state == State.FAILED:
            self.outcome.failed.append(ended)
        else:
            self.outcome.waiting.append(ended.id)
        count = len(self.outcome.done) + len(self.outcome.failed)
        self.told(ended, count, self.total)

    def _shut_down(self) -> None:
        if self.at_work:  # broken off: members save where they are
            (self.folder / STOP).touch()
        if self.executor is not None and self.workers.replaceable:
            self.executor.shutdown(cancel_futures=True)
        self.workers.close()


def _gone(workers: Workers, folder: Path) -> str:
    return (
        f"the workers ({workers.name}) went away; what is finished in {folder} stays; give the same command "
        "again to go on with the rest"
    )
