"""``run.barchan``: what Barchan knows of a run, reached from its dataset."""

from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import xarray as xr

from barchan.scenario import Scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@xr.register_dataset_accessor("barchan")  # type: ignore[no-untyped-call]
class RunAccessor:
    """Scenario, fields, measures, pictures and exports of a run, as ``run.barchan``.

    The run is a dataset as ``barchan.open_run`` and ``barchan.simulate`` return it, or one of its frames.
    """

    def __init__(self, run: xr.Dataset) -> None:
        """Take the dataset as it is."""
        self._run = run

    @cached_property
    def scenario(self) -> Scenario:
        """The scenario of the run, with its seed; raises ExportError for a dataset that is no run."""
        from barchan.export.writing import opened

        return opened(self._run)[1]

    def field(self, name: str, step: int | None = None) -> xr.DataArray:
        """A field of one frame, kept or derived, such as ``slope``; of the last frame where no step is given.

        Raises BarchanError where there is no such field or the step was not saved.
        """
        from barchan.analysis.fields import field_of

        return field_of(self._frame(step), self.scenario, name)

    def measures(self) -> xr.Dataset:
        """Every measure over the frames; see ``barchan.analysis.time_series.measure_series``."""
        from barchan.analysis.time_series import measure_series

        return measure_series(self._whole, self.scenario)

    def plot(self, field: str | None = None, step: int | None = None, **options: Any) -> "Figure":
        """A hill-shaded map of a frame, or a map of a field; of the last frame where no step is given.

        ``options`` are those of ``barchan.figures.maps.relief_map`` or ``barchan.figures.fields.field_map``.
        """
        from barchan.figures.fields import field_map
        from barchan.figures.maps import relief_map

        frame = self._frame(step)
        if field is None:
            return relief_map(frame, self.scenario, **options)
        return field_map(self.field(field, step), frame, self.scenario, **options)

    def export(
        self,
        target: str | Path,
        *,
        step: Any = None,
        fields: Sequence[str] | str | None = None,
        **options: Any,
    ) -> list[Path]:
        """Write frames for another program; see ``barchan.export.export``."""
        from barchan.export import export

        return export(self._run, target, step=step, fields=fields, **options)

    @property
    def _whole(self) -> xr.Dataset:
        from barchan.export.writing import opened

        return opened(self._run)[0]

    def _frame(self, step: int | None) -> xr.Dataset:
        from barchan.export.writing import chosen_steps

        (chosen,) = chosen_steps(self._whole, step)
        return self._whole.sel(step=chosen).load()
