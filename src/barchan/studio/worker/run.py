"""One simulation in the studio: it runs, pauses, is changed, remembers, and can go back."""

import time
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.balance import balance_now
from barchan.errors import BarchanError
from barchan.measures import highest_stack
from barchan.scenario import Scenario
from barchan.simulation import Simulation, State
from barchan.studio.worker.bookmarks import Bookmark, Bookmarks
from barchan.studio.worker.branches import Branch, Branches
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.frame_fields import STEPS_OF_CHANGE
from barchan.studio.worker.history import FINEST, History
from barchan.studio.worker.live_measures import LiveMeasures, measures_until
from barchan.studio.worker.measuring import Row
from barchan.studio.worker.painting import Painting
from barchan.studio.worker.run_speed import RunSpeed

CHUNK_SECONDS = 0.016
"""Seconds of work between two looks at the browser's requests: a call of the model costs some tenths of a
millisecond beside its steps, so shorter chunks would cost speed."""


def last_step(simulation: Simulation) -> int:
    """The step at which a run stops by itself; each change before it lets a scenario's steps follow."""
    steps = end = simulation.scenario.run.steps
    for record in simulation.events:
        if record.step < end:
            end = max(end, record.step + steps)
    return end


class StudioRun:
    """A simulation with its speed, its history and its measures."""

    def __init__(self, simulation: Simulation, desk: Desk | None = None) -> None:
        """Take a simulation over, paused, and let its states be measured at a desk."""
        self.continues = True
        """Whether there is a state that it can go on from; frames alone hold none."""
        self.wanted = True
        """Whether somebody asked for it, or has saved it; a studio may begin with another one by itself."""
        self.speed = RunSpeed(CHUNK_SECONDS)
        self.desk = desk or Desk()
        every = simulation.scenario.run.save_every
        self.begin(simulation, History(min(every, FINEST)), LiveMeasures(every, self.desk))
        self.measures.take(simulation)
        self.branches = Branches(Branch(1, 0, self.live, self.history, self.measures))
        self.bookmarks = Bookmarks()

    def begin(self, simulation: Simulation, history: History, measures: LiveMeasures) -> None:
        """Continue with a simulation that has this past."""
        self.live = simulation
        self.history = history
        self.measures = measures
        self.painting = Painting()
        self.looking: Simulation | None = None
        self.can_branch = True
        self.running = self.brief = False
        self.target: int | None = None
        self._to_end = False
        """Whether the target is the step at which it stops by itself."""
        self._surfaces: list[tuple[int, NDArray[np.float64]]] = []
        self.remember()

    @property
    def shown(self) -> Simulation:
        """The simulation that is looked at: its newest state, or an earlier one."""
        return self.live if self.looking is None else self.looking

    @property
    def busy(self) -> bool:
        """Whether there are steps to do."""
        return self.running and self.continues and self.live.finished is None

    @property
    def rests(self) -> bool:
        """Whether it stays at its newest state until it is told to go on."""
        return not self.running and not self.brief

    @property
    def end(self) -> int:
        """The step at which it stops by itself."""
        return last_step(self.live)

    @property
    def past_its_end(self) -> bool:
        """Whether it has come to its end."""
        return self.live.steps_done >= self.end

    @property
    def would_be_missed(self) -> bool:
        """Whether anything would be lost with it: steps asked for, changes, moments, or other branches."""
        first_asked_for = 0 if self.wanted else self.live.scenario.run.steps
        done = self.live.steps_done > first_asked_for or self.live.events
        return bool(done or self.bookmarks.data() or self.branches.others)

    def run(self, target: int | None = None, brief: bool = False) -> None:
        """Run, on and on or up to a step; ``brief`` where it will continue at once from there."""
        goes_on = brief and self.brief
        self.looking = None
        self.brief = brief
        self.target = target
        self._to_end = False
        self.running = target is None or target > self.live.steps_done
        if not goes_on:
            self.speed.restart()

    def run_to_its_end(self) -> None:
        """Run up to its end, or on and on where that is behind."""
        ahead = not self.past_its_end
        self.run(self.end if ahead else None)
        self._to_end = ahead

    def carry_on(self) -> None:
        """Go as far as a change lets it, where it is on its way to its end."""
        if self._to_end:
            self.target = self.end

    def pause(self) -> None:
        """Stop; measures of the state follow, at whatever step it is."""
        self.running = self.brief = False
        self.measures.take_extra(self.live)

    def recover(self) -> None:
        """Pause at the state that was kept last, where steps have failed half-way."""
        self.running = False
        self.change(Simulation.from_state(self.history.states[-1]))

    def advance_chunk(self) -> bool:
        """Do a chunk of steps; returns whether a set target is reached."""
        steps = 0 if self.desk.full else self.speed.steps
        if self.target is not None:
            steps = min(steps, self.target - self.live.steps_done)
        steps = min(steps, min(self.history.due, self.measures.due) - self.live.steps_done)
        if steps > 0:
            began = time.perf_counter()
            done = self.live.advance(steps).steps
            self.speed.record(done, time.perf_counter() - began)
            self.painting.stepped()
        self.remember()
        self.measures.take(self.live)
        arrived = self.target is not None and self.live.steps_done >= self.target
        if self.live.finished or arrived:
            self.running = False
        if self.rests:
            self.measures.take_extra(self.live)
        return not self.running and self.target is not None

    def remember(self) -> None:
        """Keep the state where one is due, and the surface from which change is counted."""
        step = self.live.steps_done
        if step >= self.history.due:
            self.history.keep(self.live.state())
        if not self._surfaces or step - self._surfaces[-1][0] >= STEPS_OF_CHANGE:
            self._surfaces = [*self._surfaces[-1:], (step, self.live.elevation)]

    def earlier(self) -> NDArray[np.float64] | None:
        """The elevation that erosion and deposition are counted from."""
        if self.looking is None:
            return self._surfaces[0][1]
        before = [s for s in self.history.steps if s <= self.looking.steps_done - STEPS_OF_CHANGE]
        return Simulation.from_state(self.history.at(before[-1])).elevation if before else None

    def look(self, step: int) -> None:
        """Look at the state nearest to a step; the run is paused."""
        self.pause()
        state = self.history.at(step)
        self.looking = Simulation.from_state(state)
        self.can_branch = state.whole

    def look_now(self) -> None:
        """Look at the newest state."""
        self.looking = None

    def branch(self) -> None:
        """Continue from the state that is looked at; the steps after it are kept as a branch of their own.

        Raises BarchanError where an archive holds no more of it than a picture.
        """
        if self.looking is not None:
            if not self.can_branch:
                raise BarchanError("an archive keeps its frames to look at; go on from its newest state")
            step = self.looking.steps_done
            past = self.history.until(step), self.measures.until(step, self.history.states)
            self.branches.leave(self.live, self.history, self.measures)
            self.begin(self.looking, *past)
            self.branches.add(self.live, *past)

    def switch(self, number: int) -> None:
        """Go back to another branch, paused where it was left; raises BarchanError where it is not kept."""
        self.branches.leave(self.live, self.history, self.measures)
        branch = self.branches.take(number)
        self.begin(branch.simulation, branch.history, branch.measures)

    def adopt(self, other: "StudioRun") -> None:
        """Keep the branch that another run is on, with its bookmarks, as a branch of this one."""
        here = self.branches.current
        self.branches.leave(self.live, self.history, self.measures)
        self.branches.add(other.live, other.history, other.measures, other.branches.began)
        number = self.branches.current
        for bookmark in other.bookmarks_here():
            if bookmark.id not in self.bookmarks:
                self.bookmarks.set(replace(bookmark, branch=number))
        self.branches.leave(other.live, other.history, other.measures)
        self.branches.take(here)

    def mark(self, bookmark: Bookmark) -> None:
        """Set a bookmark, or name a known one otherwise; its state is kept, now or once reached."""
        new = bookmark.id not in self.bookmarks
        self.bookmarks.set(bookmark)
        if new:
            self.history.marks[bookmark.id] = bookmark.step
        if new and self.looking is None and bookmark.step == self.live.steps_done:
            self.history.keep(self.live.state())  # what was painted since this step was kept belongs to it

    def bookmarks_here(self) -> list[Bookmark]:
        """The bookmarks on the branch that the run is on, as those of a run without other branches."""
        return [replace(one, branch=1) for one in self.bookmarks if one.id in self.history.marks]

    def unmark(self, bookmark_id: str) -> None:
        """Remove a bookmark; the state at its step is kept no longer than others."""
        self.bookmarks.remove(bookmark_id)
        self.history.marks.pop(bookmark_id, None)

    def change(self, simulation: Simulation) -> None:
        """Continue with a simulation that the brush has brought to another state."""
        self.live = simulation
        self.looking = None

    def status(self) -> dict[str, Any]:
        """The numbers and flags that the browser always shows, SI units."""
        shown = self.shown
        seconds, balance = shown.scenario.step_seconds, balance_now(shown)
        return {
            "step": shown.steps_done,
            "live": self.live.steps_done,
            "end": self.end,
            "running": self.busy,
            "finished": self.live.finished,
            "looking": self.looking is not None,
            "can_branch": self.looking is not None and self.can_branch,
            "rate": self.speed.rate if self.busy or self.brief else 0.0,
            "limit": self.speed.limit,
            "highest": highest_stack(shown.bed.stack),
            "deepest": float(shown.bed.depth.max()),
            "volume": shown.bed.volume,
            "balance": {"unit": balance.unit, "mass": balance.mass, "parts": balance.rows()},
            "wind": shown.wind_direction,
            "winds": shown.winds,
            "time": None if seconds is None else seconds * shown.steps_done,
            "undo": len(self.painting.done),
            "redo": len(self.painting.undone),
        }


def started(scenario: Scenario, desk: Desk | None = None) -> StudioRun:
    """A run of a scenario, at its beginning."""
    return StudioRun(Simulation(scenario), desk)


def resumed(state: State, history: History, desk: Desk | None = None, rows: Sequence[Row] = ()) -> StudioRun:
    """A run that continues from a state and has this past, of which these measures are known."""
    run = StudioRun(Simulation.from_state(state), desk)
    run.begin(run.live, history, measures_with(rows, run.live, history, run.desk))
    run.branches = Branches(Branch(1, 0, run.live, history, run.measures))
    return run


def measures_with(rows: Sequence[Row], simulation: Simulation, history: History, desk: Desk) -> LiveMeasures:
    """The measures of a simulation that has this past, of which these ``rows`` are known."""
    now = simulation.state()
    states = [*(state for state in history.states if state.step < now.step), now]
    return measures_until(now.step, simulation.scenario.run.save_every, desk, list(rows), states)


def states_of(run: StudioRun) -> tuple[State, ...]:
    """The kept states of a run and its newest one, which later steps leave as they are."""
    now = run.live.state()
    return (*(state for state in run.history.states if state.step < now.step), now)
