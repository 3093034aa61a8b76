"""A run that is set aside while another one runs in its place."""

from typing import NamedTuple

from barchan.scenario import Scenario
from barchan.studio.worker.description import named
from barchan.studio.worker.run import StudioRun


class SetAside(NamedTuple):
    """A run that another one has taken the place of."""

    run: StudioRun
    origin: Scenario | None
    loaded: int
    """The number of the start that loaded its scenario."""
    of_it: bool
    """Whether the other one came of it by changes."""

    @property
    def title(self) -> str:
        """Its title, with what was changed."""
        return named(self.run.live, self.origin or self.run.live.scenario).title

    def take_in(self, other: StudioRun) -> None:
        """Keep a run that came of it as a branch of it, unless it has done no step."""
        if other.live.steps_done:
            other.pause()
            self.run.adopt(other)


def held_aside(aside: SetAside | None) -> tuple[StudioRun, list[int]] | None:
    """The run that is set aside, and its branches: what there is to keep of it."""
    return None if aside is None else (aside.run, aside.run.branches.numbers)
