"""What there is to say of a wind: a record, or that of a scenario, over its sand."""

from dataclasses import dataclass, replace

from barchan.aeolian.saltation import Saltation
from barchan.errors import BarchanError
from barchan.models import models
from barchan.scenario import Scenario
from barchan.theory.assessment import Assessment, assess_record, assess_winds
from barchan.theory.record_remarks import is_annual
from barchan.theory.wind_table import Rows, drift_rows, potential_rows, record_rows, weather_rows
from barchan.wind import SeriesWind
from barchan.wind.records import WindRecord
from barchan.wind.records.summary import height_remarks, weather_remarks

OF_SAND = "drift potential, fingers of scarce sand and dunes to expect hold for dry sand, not for snow"
"""Said of winds over snow."""


@dataclass(frozen=True)
class Subject:
    """A wind that is looked at."""

    title: str
    rows: Rows
    found: Assessment
    record: WindRecord | None
    """The record, where the wind is one or is made up as one."""
    sand: Saltation
    remarks: tuple[str, ...] = ()
    """Assumptions made in reading it."""
    over_snow: bool = False
    """Whether it blows over snow, of which what is told of sand does not hold."""

    @property
    def table(self) -> Rows:
        """All rows: what the wind is, its drift potential, the drift and what it shapes."""
        return [*self.rows, *drift_rows(self.found)]

    @property
    def measured(self) -> WindRecord | None:
        """The winds that were measured, without those supposed in gaps."""
        return None if self.record is None else self.record.measured

    @property
    def warnings(self) -> tuple[str, ...]:
        """What makes the wind implausible."""
        return (*(self.measured.warnings if self.measured else ()), *self.found.warnings)

    @property
    def doubt(self) -> str:
        """Why its drift potential should not be quoted; empty where all is well."""
        annual = self.measured is None or is_annual(self.measured)
        return "; ".join((*self.warnings, *(() if annual else ("not that of a year",))))

    @property
    def all_remarks(self) -> tuple[str, ...]:
        """All that a reader should know, in order."""
        still = () if self.found.moves else ("nothing would move: no wind exceeds the threshold",)
        return (*self.remarks, *self.found.remarks, *self.found.nearby, *still)


def of_record(record: WindRecord, sand: Saltation, supply: float | None, key: str) -> Subject:
    """A record over some sand; ``key`` is where the height of its speeds can be stated."""
    measured = record.measured
    try:
        found = assess_record(measured, sand, supply)
    except ValueError as error:
        raise BarchanError(f"{record.source}: {error}") from None
    potential = potential_rows(found.potential, found.threshold, is_annual(measured))
    remarks = [*record.remarks, *height_remarks(record, sand.height, key)]
    remarks += weather_remarks(record)
    if record.supposed is not None:
        remarks.append("roses, drift and potential are of the wind as measured, without gaps")
    rows = [*record_rows(measured, sand), *weather_rows(record), *potential]
    return Subject(record.source, rows, found, record, sand, tuple(remarks))


def of_winds(scenario: Scenario, supply: float) -> Subject:
    """The wind of a scenario over its sand: its record, or its winds weighted by the sand they move.

    ``supply`` is the equivalent sand thickness (m). Over snow a remark says what is of sand only.
    """
    found = _over_sand(scenario, supply)
    if models()[scenario.model.name].material != "snow":
        return found
    return replace(found, remarks=(*found.remarks, OF_SAND), over_snow=True)


def _over_sand(scenario: Scenario, supply: float) -> Subject:
    sand = scenario.clock or Saltation()
    if isinstance(scenario.wind, SeriesWind):
        record = scenario.wind.series(scenario.seed).record
        return of_record(record, sand, supply, "wind.columns.height")
    found = assess_winds(scenario, supply)
    weights = [("weights", "polls times hop length", "")] if found.drift.unit == "-" else []
    rows = [*weights, *potential_rows(found.potential, found.threshold, annual=True)]
    return Subject(scenario.title, rows, found, None, sand)
