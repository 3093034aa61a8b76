"""What a view can show, as runs of the studio."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from barchan.archive.folder import SCENARIO
from barchan.entry import load
from barchan.errors import BarchanError
from barchan.export.writing import opened
from barchan.scenario import Scenario
from barchan.simulation import Simulation
from barchan.studio.worker.desk import ClosedDesk
from barchan.studio.worker.history import FINEST, History
from barchan.studio.worker.run import StudioRun, resumed, started
from barchan.studio.worker.saved_runs import open_saved_run, run_of_frames


def run_of(shown: Any, overrides: Mapping[str, Any]) -> StudioRun:
    """A run of the studio, paused, whose states nobody measures; see ``barchan.notebook.view``.

    Raises BarchanError for whatever is no scenario, simulation or run, and for overrides of these two.
    """
    desk = ClosedDesk()
    if isinstance(shown, str | Path) and (Path(shown) / SCENARIO).is_file():
        _refuse(overrides, f"the run in {shown}")
        return open_saved_run(Path(shown), desk)
    if isinstance(shown, Simulation):
        _refuse(overrides, "a simulation")
        return _continued(shown, desk)
    if isinstance(shown, Scenario):
        return started(load(shown.data(), **overrides) if overrides else shown, desk)
    if _is_dataset(shown):
        _refuse(overrides, "the frames of a run")
        return run_of_frames(*opened(shown), desk)
    if isinstance(shown, str | Path | Mapping):
        return started(load(shown, **overrides), desk)
    raise BarchanError(
        f"no view of a {type(shown).__name__}; allowed are a preset's name, a scenario, a simulation, a "
        "run's folder, and the frames of a run"
    )


def _continued(simulation: Simulation, desk: ClosedDesk) -> StudioRun:
    """A run from the state of a simulation on, which itself stays as it is."""
    state, history = simulation.state(), History(min(simulation.scenario.run.save_every, FINEST))
    history.keep(state)
    return resumed(state, history, desk)


def _is_dataset(shown: Any) -> bool:
    """Whether frames are shown; a dataset is a mapping too, as plain data of a scenario are."""
    import xarray as xr

    return isinstance(shown, xr.Dataset)


def _refuse(overrides: Mapping[str, Any], name: str) -> None:
    if overrides:
        raise BarchanError(f"{', '.join(overrides)}: {name} cannot be changed; a scenario can")
