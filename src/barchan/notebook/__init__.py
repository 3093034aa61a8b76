"""A live view in notebooks: the studio's scene of a simulation or a run, in the cell and without a server.

>>> from barchan.notebook import view
>>> view("barchans")
"""

from typing import TYPE_CHECKING, Any

from barchan.errors import BarchanError

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import xarray as xr

    from barchan.notebook.widget import View
    from barchan.scenario import Scenario
    from barchan.simulation import Simulation

MISSING = "a view in a notebook needs anywidget; install it with: python -m pip install anywidget"


def view(
    shown: "str | Path | Mapping[str, Any] | Scenario | Simulation | xr.Dataset",
    *,
    field: str = "natural",
    height: int = 420,
    **overrides: Any,
) -> "View":
    """A view of a scenario, a simulation or a run; the last expression of a cell shows it there.

    ``shown`` is a preset's name, a scenario or its file, whose simulation the view runs, with ``overrides``
    as in ``barchan.load``; a :class:`barchan.Simulation`, which stays as it is, for the view runs a copy; the
    folder of a run, which the view continues in memory; or the frames of a run (``barchan.simulate``,
    ``barchan.open_run``), which can be looked at.

    ``field`` colours the surface: ``natural`` (the material's own colour), ``elevation``, ``depth``,
    ``slope``, or a field of the model. ``height`` is that of the scene in pixels.

    Raises BarchanError without the library anywidget or the built client, for a field that the model does not
    have, and for whatever is no run; ScenarioError for a scenario with mistakes.
    """
    try:
        from barchan.notebook.widget import View
    except ModuleNotFoundError as error:
        if error.name != "anywidget":
            raise
        raise BarchanError(MISSING) from error
    from barchan.notebook.sources import run_of

    return View(run_of(shown, overrides), field=field, height=height)


__all__ = ["view"]
