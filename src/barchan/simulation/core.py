"""The simulation itself."""

from collections.abc import Iterator
from dataclasses import asdict, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.errors import BarchanError
from barchan.kernels.core.threads import asked_for
from barchan.lattice import Lattice
from barchan.models import Model, Tally
from barchan.scenario import Scenario, validate
from barchan.scenario.effects import refuse_weather
from barchan.scenario.summary import html_table, summary
from barchan.simulation.events import AnyEvent, Record
from barchan.simulation.frame import Frame
from barchan.simulation.ledger import Ledger
from barchan.simulation.memory import refuse_too_large
from barchan.simulation.progress import progress
from barchan.simulation.state import State
from barchan.simulation.stop import StopConditions
from barchan.streams import Stream
from barchan.wind import Segment, Wind


class Simulation:
    """A scenario set in motion.

    >>> simulation = Simulation(load("barchans"))
    >>> simulation.advance(100)
    >>> simulation.elevation.max()

    Iterating yields the frames that the scenario asks for, the first one at once, until its last step or
    until one of its ``run.until`` conditions ends it.
    """

    def __init__(self, scenario: Scenario) -> None:
        """Build the bed of a scenario; without a seed one is drawn, see ``simulation.scenario``."""
        self._set_up(scenario.seeded())
        scene = self.scenario
        refuse_too_large(scene)
        with scene.source_map.locating_errors():
            self.forcing.wind_of(0)
            refuse_weather(scene, scene.wind)
            self.bed = scene.first_bed()
            self.model.initialise(self.bed, scene.seed)
        self.ledger = Ledger(self.bed.units)
        self.model.relax(self.bed)
        self.model.start(self.bed)

    def _set_up(self, scenario: Scenario) -> None:
        self.scenario = scenario
        self._wind = scenario.wind
        self.forcing = scenario.forcing()
        self.model: Model = scenario.new_model()
        self.stream = Stream(scenario.seed, "transport")
        self.steps_done = 0
        self.finished: str | None = None
        self.tally = Tally()
        self.events: list[Record] = []
        self.stop_conditions = StopConditions(scenario)
        self._framed = -1
        self._broken_off = False

    def __repr__(self) -> str:
        named = f" of '{self.scenario.title}'" if self.scenario.title else ""
        return f"<Simulation{named}: {', '.join(progress(self).values())}>"

    def _repr_html_(self) -> str:
        rows = {**summary(self.scenario), **progress(self)}
        return html_table(self.scenario.title or "Simulation", rows)

    @property
    def lattice(self) -> Lattice:
        """The lattice."""
        return self.scenario.lattice

    @property
    def wind(self) -> Wind:
        """The wind that blows from now on."""
        return self._wind

    @wind.setter
    def wind(self, wind: Wind) -> None:
        self._wind = wind
        self.forcing = replace(self.forcing, wind=wind)
        self.model.winds_off_axes = wind.off_axes(self.lattice.hexagonal)

    @property
    def wind_direction(self) -> float:
        """Where the wind of the last step came from, or before any step that of the first (degrees).

        Of several winds in one step it is where their mean transport came from.
        """
        return self.last_segment.direction

    @property
    def winds(self) -> int:
        """From how many directions winds blew in the last step, or blow in the first before any."""
        _, _, intervals = next(self.forcing.constant_intervals(max(self.steps_done - 1, 0), 1))
        return len({interval.direction for interval in intervals})

    @property
    def last_segment(self) -> Segment:
        """The wind segment of the last step, or before any step that of the first."""
        return self.forcing.wind_of(max(self.steps_done - 1, 0))

    @property
    def elevation(self) -> NDArray[np.float64]:
        """Elevation of the surface (m)."""
        return self.bed.elevation

    def advance(self, steps: int = 1) -> Tally:
        """Do ``steps`` steps, fewer where a condition of ``run.until`` ends the run; returns their tally.

        KeyboardInterrupt may break a step off, also a long one. Its bed is half done then, and the simulation
        cannot go on: a later call, or ``state``, raises BarchanError.
        """
        self._refuse_half_done()
        try:
            with asked_for(self.scenario.run.threads):
                return self._advance(steps)
        except KeyboardInterrupt:
            self._broken_off = True
            raise

    def _refuse_half_done(self) -> None:
        if self._broken_off:
            raise BarchanError(
                f"a step after step {self.steps_done} was broken off and its bed is half done; go on from an "
                "earlier state, or from the checkpoint of its archive"
            )

    def _advance(self, steps: int) -> Tally:
        total = Tally(airborne=self.tally.airborne, finished=self.tally.finished)
        end = self.steps_done + steps
        while self.steps_done < end and self.finished is None:
            count = self.stop_conditions.steps_to_next(self.steps_done, end - self.steps_done)
            since = Tally()
            for segments in self.forcing.segments(self.steps_done, count):
                since.add(self._blow(segments))
                if since.finished is not None:
                    break
            self.steps_done += since.steps
            total.add(since)
            self.finished = since.finished or self.stop_conditions.check(self, since)
        self._book(total)
        return total

    def _blow(self, segments: list[Segment]) -> Tally:
        """Let the winds of one step blow, or one wind for several steps."""
        if len(segments) == 1:
            return self.model.advance(self.bed, segments[0], self.stream)
        total = Tally()
        for segment in segments:
            total.add(self.model.advance(self.bed, segment, self.stream))
            if total.finished is not None:
                break
        return replace(total, steps=1)

    def _book(self, tally: Tally) -> None:
        self.tally.add(tally)
        self.ledger.entered += tally.entered
        self.ledger.left += tally.left
        self.ledger.airborne = tally.airborne
        self.bed.check()
        self.ledger.check(self.bed)

    @property
    def done(self) -> bool:
        """Whether the run has come to its end."""
        return self.finished is not None or self.steps_done >= self.scenario.run.steps

    def extend(self, steps: int) -> None:
        """Let the run go on to ``steps`` steps in all.

        Raises BarchanError where it has done more already, or has ended for another reason.
        """
        if steps < self.steps_done:
            raise BarchanError(f"{self.steps_done} steps are done already; {steps} cannot be the last one")
        if self.finished is not None:
            raise BarchanError(f"the run ended at step {self.steps_done}: {self.finished}")
        data = self.scenario.data()
        self.scenario = validate({**data, "run": {**data["run"], "steps": steps}}, "longer run")

    @property
    def next_frame(self) -> int:
        """The step at which the next frame is due: now, where one is due that was not handed out."""
        every = self.scenario.run.save_every
        if self.steps_done % every == 0 and not self.framed:
            return self.steps_done
        return min((self.steps_done // every + 1) * every, self.scenario.run.steps)

    def frame(self) -> Frame:
        """The bed as it is now, copied."""
        self._framed = self.steps_done
        return Frame(
            self.steps_done,
            self.wind_direction,
            self.bed.frame(),
            Ledger(**vars(self.ledger)),
            Tally(**vars(self.tally)),
        )

    @property
    def framed(self) -> bool:
        """Whether the bed as it is now has been handed out as a frame."""
        return self._framed == self.steps_done

    def __iter__(self) -> Iterator[Frame]:
        """Run to the end, frame by frame."""
        while True:
            if not self.framed and (self.done or self.next_frame == self.steps_done):
                yield self.frame()
            if self.done:
                return
            self.advance(self.next_frame - self.steps_done)

    def apply(self, event: AnyEvent) -> Record:
        """Let something happen now, between two steps; it is journaled in ``events``."""
        event.apply(self)
        self.finished = None
        record = Record(self.steps_done, event)
        self.events.append(record)
        return record

    def current_data(self) -> dict[str, Any]:
        """The scenario's data with the parameters and the wind that events have changed."""
        model: dict[str, Any] = self.model.parameters.model_dump(mode="json")
        return {**self.scenario.data(), "model": model, "wind": self.wind.model_dump(mode="json")}

    @property
    def scenario_in_force(self) -> Scenario:
        """The scenario with the parameters and the wind that events have changed."""
        return validate(self.current_data(), "run")

    @property
    def scenario_as_run(self) -> Scenario:
        """The same, with steps as long as this run's are whatever parameters have become."""
        return self.scenario_in_force.lasting(self.scenario)

    def change_model(self, scenario: Scenario) -> None:
        """Give the model the parameters of a scenario; by a clock the polls of winds follow them."""
        self.model.change(scenario.model)
        if scenario.clock is not None:
            clock = scenario.lasting(self.scenario).forcing().clock
            self.forcing = replace(self.forcing, clock=clock)

    def state(self) -> State:
        """Everything it takes to go on from here with the same bits."""
        self._refuse_half_done()
        arrays = {f"bed/{name}": array.copy() for name, array in self.bed.arrays.items()}
        arrays |= {f"model/{name}": np.asarray(value) for name, value in self.model.state().items()}
        conditions, seen = self.stop_conditions.state()
        arrays |= {f"stop/{name}": array for name, array in seen.items()}
        now = self.current_data()
        data: dict[str, Any] = {
            "scenario": self.scenario.data(),
            "model": now["model"],
            "wind": now["wind"],
            "step": self.steps_done,
            "framed": self._framed,
            "finished": self.finished,
            "ledger": asdict(self.ledger),
            "tally": asdict(self.tally),
            "events": [record.data() for record in self.events],
            "stop_conditions": conditions,
        }
        return State(data, arrays)

    @classmethod
    def from_state(cls, state: State) -> Self:
        """The simulation that was in this state; sums are checked where the state is ``whole``."""
        state = state.up_to_date()
        data = state.data
        simulation = cls.__new__(cls)
        simulation._set_up(validate(data["scenario"], "state"))
        now = validate({**data["scenario"], "model": data["model"], "wind": data["wind"]}, "state")
        simulation.change_model(now)
        simulation.wind = now.wind
        model = simulation.model
        bed = Bed.from_fields(simulation.lattice, state.group("bed/"), model.fields, model.layers)
        simulation.bed = bed
        simulation.model.restore(state.group("model/"))
        simulation.steps_done = data["step"]
        simulation._framed = data["framed"]
        simulation.finished = data["finished"]
        simulation.ledger = Ledger(**data["ledger"])
        simulation.tally = Tally(**data["tally"])
        simulation.events = [Record.from_data(record) for record in data["events"]]
        simulation.stop_conditions.restore(data["stop_conditions"], state.group("stop/"))
        if state.whole:
            simulation.ledger.check(bed)
        return simulation
