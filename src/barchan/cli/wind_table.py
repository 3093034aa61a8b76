"""Rows of the table of ``barchan wind --by``: the drift potential of months or seasons."""

from typing import TYPE_CHECKING, Literal

from barchan.aeolian.saltation import Saltation

if TYPE_CHECKING:
    from barchan.theory.seasons import PartOfYear
    from barchan.theory.wind_table import Rows
    from barchan.wind.records import WindRecord


def parts_of(
    record: "WindRecord", sand: Saltation, threshold: float, by: Literal["month", "season"]
) -> "list[PartOfYear]":
    """The months or seasons of a record; raises BarchanError where it has no dates."""
    from barchan.errors import BarchanError
    from barchan.theory.assessment import at_ten_metres
    from barchan.theory.seasons import by_part_of_year

    try:
        return by_part_of_year(at_ten_metres(record, sand), by, threshold)
    except ValueError as error:
        raise BarchanError(f"--by {by}: {error}") from None


def part_rows(
    record: "WindRecord", sand: Saltation, threshold: float, by: Literal["month", "season"]
) -> "Rows":
    """Drift potential by month or by season; raises BarchanError where the record has no dates."""
    from barchan.theory.wind_table import toward

    return [
        (
            part.name,
            (
                f"DP {part.potential.total:.1f} VU, RDP {part.potential.resultant:.1f} VU "
                f"{toward(part.potential.toward)}, of {part.days:.4g} days"
            ),
            "",
        )
        for part in parts_of(record, sand, threshold, by)
    ]
