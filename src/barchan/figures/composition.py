"""Two scales in one picture: a field of ripples laid over a dune, for pictures only."""

from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from barchan.analysis.fields import field_of
from barchan.analysis.on_squares import on_squares
from barchan.directions import downwind
from barchan.errors import BarchanError
from barchan.fields import depth_of
from barchan.measures.filters import Field, Periodic, gradient, smoothed
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr

QUANTUM = 0.01
"""Height of a composition's slabs, over the width of its cells."""

SLIP = (15.0, 25.0)
"""Slopes (degrees) down the wind on which ripples begin to fade and on which there are none."""

_MARGIN = 8
"""Cells beyond the field that a spline sees."""


def laid_over(
    frame: "xr.Dataset", scenario: Scenario, relief: NDArray, factor: int, smoothing: float = 1.0
) -> tuple["xr.Dataset", Scenario]:
    """A frame of a slab model on cells ``factor`` times as fine, with ripples on its sand.

    ``relief`` are heights (m) on the fine cells, about their mean, repeated over the field where they cover
    less of it. Ripples are as high as that where sand in the wind is deeper than they are; they fade out on
    thinner sand, and there are none in shadow, on slip faces and on bare ground. The dune is smoothed over
    ``smoothing`` of its cells, for its slabs would show as steps; sand thinner than half a slab then counts
    as bare ground.

    The result is a frame and a scenario for pictures (``relief_map``, ``oblique_view``, ``profile``). It is
    no state of a run: two models never meet on one bed, and sand is conserved only about. Raises BarchanError
    where the model knows no shadow or ``factor`` is below 1.
    """
    if factor < 1:
        raise BarchanError(f"factor is {factor}; allowed: 1 or more fine cells to a cell")
    frame, scenario = on_squares(frame, scenario)
    lattice = scenario.lattice
    fine = lattice.model_copy(
        update={
            "rows": lattice.rows * factor,
            "columns": lattice.columns * factor,
            "cell_size": lattice.cell_size / factor,
            "slab_aspect": QUANTUM,
            "slab_height": None,
        }
    )
    ripples = _repeated(np.asarray(relief, float) - np.mean(relief), fine.shape)
    height = float(np.ptp(ripples))
    coarse = smoothed(depth_of(scenario.layers, frame, lattice.thickness).values, smoothing, lattice.periodic)
    ground = finer(frame["ground"].values, factor, lattice.periodic, 1)
    depth = finer(coarse, factor, lattice.periodic)
    depth[depth < 0.5 * lattice.thickness] = 0.0
    shadow = smoothed(field_of(frame, scenario, "shadow").values, smoothing, lattice.periodic)
    share = np.minimum(depth / height, 1.0) if height > 0 else np.ones(fine.shape)
    share *= 1.0 - np.clip(finer(shadow, factor, lattice.periodic, 1), 0.0, 1.0)
    share *= _off_slip_faces(ground + depth, fine.cell_size, float(frame["wind_direction"]), fine.periodic)
    sand = np.rint(np.maximum(depth + share * ripples, 0.0) / fine.thickness)
    title = f"{scenario.title or 'Run'} with ripples laid over it"
    composed = scenario.model_copy(update={"lattice": fine, "title": title})
    return _frame(frame, composed, ground, sand.astype(np.int32)), composed


def finer(field: NDArray, factor: int, periodic: Periodic, order: Literal[1, 3] = 3) -> Field:
    """A field on cells ``factor`` times as fine, by splines of an order through the cells' centres."""
    padded = np.asarray(field, float)
    for axis, joined in enumerate(periodic):
        margin = [(0, 0), (0, 0)]
        margin[axis] = (_MARGIN, _MARGIN)
        padded = np.pad(padded, margin, mode="wrap" if joined else "edge")
    wide = ndimage.zoom(padded, factor, order=order, mode="nearest", grid_mode=True)
    inside = slice(_MARGIN * factor, -_MARGIN * factor)
    return wide[inside, inside]


def _repeated(relief: Field, shape: tuple[int, int]) -> Field:
    times = [-(-size // own) for size, own in zip(shape, relief.shape, strict=True)]
    return np.tile(relief, times)[: shape[0], : shape[1]]


def _off_slip_faces(surface: Field, cell_size: float, direction: float, periodic: Periodic) -> Field:
    """1 on slopes where ripples form, 0 on those too steep down the wind, and between in between."""
    east, north = gradient(surface, cell_size, periodic)
    x, y = downwind(direction)
    fall = np.degrees(np.arctan(-(east * x + north * y)))
    return np.clip((SLIP[1] - fall) / (SLIP[1] - SLIP[0]), 0.0, 1.0)


def _frame(frame: "xr.Dataset", scenario: Scenario, ground: Field, sand: NDArray[np.int32]) -> "xr.Dataset":
    """A frame with another surface; everything else stays as it is."""
    lattice = scenario.lattice
    plain = frame.drop_vars([name for name, values in frame.variables.items() if values.dims != ()])
    fields = {
        "ground": ground,
        scenario.layers[-1].name: sand,
        "elevation": ground + sand * lattice.thickness,
    }
    return plain.assign_coords(y=("y", lattice.y), x=("x", lattice.x)).assign(
        {name: (("y", "x"), values, frame[name].attrs) for name, values in fields.items()}
    )
