"""The views of ``barchan show``: a table of pictures, and the options that each of them takes."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from barchan.errors import BarchanError
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

PATHS, HOPS = 20, 1000
"""Grains that are followed for paths and for hops where no number is given."""


ANY = ("size", "dpi", "out")
"""Options that every view takes."""


@dataclass(frozen=True)
class Source:
    """The data of a picture."""

    scenario: Scenario
    run: "xr.Dataset"
    """All frames."""
    frame: "xr.Dataset"
    """The frame that is chosen."""
    field: "xr.DataArray | None"
    """The field of the frame that is chosen, where one is."""


@dataclass(frozen=True)
class View:
    """A row of the table."""

    name: str
    draw: Callable[..., "Figure"]
    """Draws a ``Source``, with the options that are given as keywords."""
    options: tuple[str, ...]
    of_field: bool = False
    """Whether it shows a field."""

    @property
    def of_frame(self) -> bool:
        """Whether it shows one frame, not the whole run."""
        return "step" in self.options

    def check(self, given: dict[str, Any]) -> None:
        """Raise BarchanError for an option that this view does not take, or limits the wrong way round."""
        allowed = ", ".join(f"--{name}" for name in (*self.options, *ANY))
        view = f"--view {self.name}{' with --field' if self.of_field else ''}"
        for name in given:
            if name not in self.options:
                raise BarchanError(f"--{name}: {view} does not take it; it takes {allowed}")
        low, high = given.get("limits", (0.0, 1.0))
        if not low < high:
            raise BarchanError(f"--limits {low:g} {high:g}: the lowest must be below the highest")


def _relief(source: Source, *, bare: bool = True, **options: Any) -> "Figure":
    from barchan.figures.maps import relief_map

    return relief_map(source.frame, source.scenario, show_bare=bare, **options)


def _field(source: Source, **options: Any) -> "Figure":
    from barchan.figures.fields import field_map

    assert source.field is not None
    return field_map(source.field, source.frame, source.scenario, **options)


def _contours(source: Source, **options: Any) -> "Figure":
    from barchan.figures.contours import contour_map

    return contour_map(source.frame, source.scenario, **options)


def _oblique(source: Source, *, bare: bool = True, **options: Any) -> "Figure":
    from barchan.figures.oblique import oblique_view

    return oblique_view(source.frame, source.scenario, show_bare=bare, **options)


def _profile(source: Source, **options: Any) -> "Figure":
    from barchan.figures.sections import profile

    return profile(source.frame, source.scenario, field=source.field, **options)


def _space_time(source: Source, **options: Any) -> "Figure":
    from barchan.figures.space_time import space_time

    return space_time(source.run, source.scenario, **options)


def _series(source: Source) -> "Figure":
    from barchan.analysis.time_series import measure_series
    from barchan.figures.series import time_series

    return time_series(measure_series(source.run, source.scenario), source.scenario)


def _paths(source: Source, *, grains: int = PATHS) -> "Figure":
    from barchan.analysis.grain_paths import grain_paths
    from barchan.figures.paths import path_view

    return path_view(source.frame, source.scenario, grain_paths(source.frame, source.scenario, grains))


def _hops(source: Source, *, grains: int = HOPS) -> "Figure":
    from barchan.analysis.grain_paths import grain_paths
    from barchan.figures.paths import hop_histograms

    return hop_histograms(source.frame, source.scenario, grain_paths(source.frame, source.scenario, grains))


VIEWS = (
    View("map", _relief, ("step", "colours", "limits", "smoothing", "bare", "layers")),
    View("map", _field, ("step", "colours", "limits", "smoothing"), of_field=True),
    View("contours", _contours, ("step", "colours", "limits", "smoothing", "interval", "count")),
    View("oblique", _oblique, ("step", "angle", "colours", "limits", "smoothing", "bare", "layers")),
    View("profile", _profile, ("step", "smoothing", "at", "strata")),
    View("profile", _profile, ("step", "smoothing", "at", "strata"), of_field=True),
    View("space-time", _space_time, ("at", "colours")),
    View("series", _series, ()),
    View("paths", _paths, ("step", "grains")),
    View("hops", _hops, ("step", "grains")),
)
"""Every view, without and with a field."""


def view_of(name: str, field: str | None) -> View:
    """The view of a name; raises BarchanError where it shows no field but one is given."""
    for view in VIEWS:
        if view.name == name and view.of_field == (field is not None):
            return view
    known = " or ".join(view.name for view in VIEWS if view.of_field)
    raise BarchanError(f"--field {field}: a field is drawn as --view {known}, not {name}")
