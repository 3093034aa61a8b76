"""The air as grains meet it: wind and drag, as tables that flight reads."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import above_focus, focused_wind, unstable_wind
from barchan.directions import downwind
from barchan.grains.closure import Setting
from barchan.grains.parameters import GrainFlight
from barchan.grains.wind_feedback import WindFeedback
from barchan.kernels.grains.air_state import TABLE_SHIFT, Air, Table

_PER_DOUBLING = 64
"""Entries of a table from a number to its double, as the kernels read them."""

HEIGHTS = -20, 7
"""Doublings of 1 m that the table of the wind covers: a thousandth of a millimetre to 128 m."""

SQUARED_SPEEDS = -24, 14
"""Doublings of 1 m²/s² that the table of the drag covers: 0.2 mm/s to 128 m/s."""

_KEPT = 8
"""Winds whose tables are kept."""

_CALM = 1e-9
"""Components of the wind's direction below this are zero: their squares would be too small to be fast."""


def table(of: Callable[[NDArray], NDArray], doublings: tuple[int, int]) -> Table:
    """A kernel's table of a function of a positive number within ``doublings`` of 1.

    An entry holds the value in the middle of the numbers that share its leading bits; below the table
    the first value holds, above it the last.
    """
    first, last = doublings
    begin = int(np.float32(2.0**first).view(np.int32))
    bits = np.arange((last - first) * _PER_DOUBLING, dtype=np.int64) << TABLE_SHIFT
    middle = (bits + begin + (1 << (TABLE_SHIFT - 1))).astype(np.int32).view(np.float32)
    return Table(of(middle.astype(np.float64)).astype(np.float32), np.int32(begin), np.int32(middle.size - 1))


@lru_cache(_KEPT)
def log_table(ustar: float, roughness: float, displacement: float, stability: float) -> Table:
    """The table of a wind by the law of the wall, with ``stability`` (m/s) added to its speed."""
    return table(lambda height: unstable_wind(height, ustar, roughness, displacement, stability), HEIGHTS)


@lru_cache(_KEPT)
def tables_about_focus(
    ustar: float, roughness: float, focus: float, displacement: float
) -> tuple[Table, Table]:
    """Tables of a wind in a layer of grains: its shape below the focus, and the speed gained above.

    The shape is for a friction velocity of 1 m/s near the bed.
    """
    about = roughness, focus, displacement

    def shape(height: NDArray) -> NDArray:
        return focused_wind(height, 1.0, 1.0, *about) - above_focus(height, 1.0, *about)

    return table(shape, HEIGHTS), table(lambda height: above_focus(height, ustar, *about), HEIGHTS)


def wind_profile(
    rules: GrainFlight, height: NDArray[np.float64], ustar: float, feedback: WindFeedback | None
) -> NDArray[np.float64]:
    """Wind speed (m/s) at heights (m) above the surface, of a wind of friction velocity ``ustar`` (m/s).

    Near a bed where the wind varies in space the profile is that of the mean near-bed friction velocity.
    """
    if feedback is None or feedback.closure.near_bed == "log":
        return unstable_wind(height, ustar, rules.roughness_length, rules.displacement, rules.stability)
    near, focus = float(feedback.near_bed_ustar(ustar).mean()), feedback.closure.focus_height
    return focused_wind(height, ustar, near, rules.roughness_length, focus, rules.displacement)


def wind_tables(
    rules: GrainFlight, ustar: float, feedback: WindFeedback | None
) -> tuple[Table, Table | None]:
    """The wind by height, and the speed gained above the focus where the near-bed wind varies in space."""
    if feedback is None:
        return log_table(ustar, rules.roughness_length, rules.displacement, rules.stability), None
    if feedback.closure.varies_in_space:
        focus = feedback.closure.focus_height
        return tables_about_focus(ustar, rules.roughness_length, focus, rules.displacement)
    return table(lambda height: wind_profile(rules, height, ustar, feedback), HEIGHTS), None


def drag_table(rules: GrainFlight) -> Table:
    """Share of a velocity difference that drag takes away in a time step, for each size class."""
    tables = [
        table(lambda squared, one=one: rules.drag_share(np.sqrt(squared), one), SQUARED_SPEEDS)  # type: ignore[misc]
        for one in rules.diameters
    ]
    if not rules.size_classes:
        return tables[0]
    return tables[0]._replace(values=np.concatenate([one.values for one in tables]))


def air_of(setting: Setting, feedback: WindFeedback | None, drag: Table) -> Air:
    """The effect of the air on grains in one time step, as kernels take it."""
    rules, cell_size = setting.rules, setting.lattice.cell_size
    x, y = (0.0 if abs(part) < _CALM else part for part in downwind(setting.direction))
    step = rules.time_step
    late = 1.0 if rules.scheme == "euler" else 0.5
    early = 1.0 - late
    before, after = early * step, late * step
    fall = rules.gravity * step
    wind, above = wind_tables(rules, setting.ustar, feedback)
    return Air(
        wind=wind,
        drag=drag,
        wind_x=np.float32(x),
        wind_y=np.float32(y),
        fall=np.float32(fall),
        early_fall=np.float32(fall * early),
        before=np.float32(before / cell_size),
        after=np.float32(after / cell_size),
        rise_before=np.float32(before),
        rise_after=np.float32(after),
        above=above,
    )
