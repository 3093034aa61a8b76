"""Colours of a mesh's vertices: natural, or those of a field, on one scale for all files of an export."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import ExportError
from barchan.export.source import Source, changed
from barchan.scenario import Scenario, nearest

if TYPE_CHECKING:
    import xarray as xr

NATURAL = "natural"
"""The colours of sand or snow by its elevation, with bare ground, plants and whatever else lies over it."""


def colours_of(source: Source) -> NDArray[np.float32]:
    """Colours (red, green, blue from 0 to 1, as screens show them) of the only frame, without shade.

    Raises ExportError where there is no field of the name that is asked for.
    """
    from barchan.analysis.on_squares import on_squares

    (step,) = source.steps
    scale = scale_of(source)
    frame, scenario = on_squares(source.frame(step), source.scenario)
    name = _name(source)
    base = _natural(frame, scenario, scale) if name == NATURAL else _field(source, frame, scenario, scale)
    channels = [changed(base[..., k], scenario.lattice.periodic, source.options) for k in range(3)]
    return np.clip(np.stack(channels, axis=-1).reshape(-1, 3), 0.0, 1.0).astype("<f4")


def scale_of(source: Source) -> tuple[float, float]:
    """Lowest and highest value of the colour scale over all frames of the export."""
    from barchan.figures.maps import range_over

    name = _name(source)
    if name not in source.scales:
        if name == NATURAL:
            frames = source.dataset.sel(step=list(source.all_steps))
            source.scales[name] = range_over(frames, source.scenario)
        else:
            found = [_limits(source, step) for step in source.all_steps]
            source.scales[name] = min(low for low, _ in found), max(high for _, high in found)
    return source.scales[name]


def colour_facts(source: Source) -> dict[str, Any]:
    """What the side-car file says of the colours: whose they are, and the ends of their scale."""
    (low, high), name, unit = scale_of(source), _name(source), "m"
    if name != NATURAL:
        declared = _of(source, source.steps[-1]).attrs
        low, unit = max(low, declared.get("least", low)), str(declared["unit"])
    return {"colours": {"of": name, "lowest": low, "highest": high, "unit": unit}}


def _name(source: Source) -> str:
    return source.options.colour_by or NATURAL


def _of(source: Source, step: int) -> "xr.DataArray":
    """The field that colours a frame, on the model's cells."""
    from barchan.analysis.fields import field_names, field_of

    name, frame = _name(source), source.frame(step)
    known = [NATURAL, *field_names(frame, source.scenario)]
    if name not in known:
        raise ExportError(
            f"--colour-by: no field '{name}'; there are {', '.join(known)}{nearest(name, known)}"
        )
    return field_of(frame, source.scenario, name)


def _limits(source: Source, step: int) -> tuple[float, float]:
    from barchan.analysis.on_squares import field_on_squares, on_squares
    from barchan.figures.fields import automatic_limits

    field = field_on_squares(_of(source, step), source.scenario)
    return automatic_limits(field, *on_squares(source.frame(step), source.scenario))


def _natural(frame: "xr.Dataset", scenario: Scenario, scale: tuple[float, float]) -> NDArray[np.float64]:
    from matplotlib.colors import Normalize

    from barchan.figures.bare import with_bare_ground
    from barchan.figures.layers import overlaid
    from barchan.figures.style import SMOOTHING, colour_map, material_of, smooth

    shown = smooth(frame["elevation"].values, SMOOTHING, scenario)
    base = np.asarray(colour_map("natural", material_of(scenario))(Normalize(*scale)(shown)))[..., :3]
    return overlaid(with_bare_ground(base, frame, scenario, SMOOTHING), frame, scenario)


def _field(
    source: Source, frame: "xr.Dataset", scenario: Scenario, scale: tuple[float, float]
) -> NDArray[np.float64]:
    from barchan.analysis.on_squares import field_on_squares
    from barchan.figures.fields import field_colours

    field = field_on_squares(_of(source, source.steps[0]), source.scenario)
    colours, _, _ = field_colours(field, frame, scenario, automatic=scale)
    return colours
