"""The numbers of ``barchan wind`` as measures, for JSON and CSV, and the table of its roses."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

from barchan.aeolian.saltation import Saltation
from barchan.analysis.declared_measures import FROM_NORTH, Measure, Value
from barchan.cli.measure_table import Words

if TYPE_CHECKING:
    from barchan.theory.assessment import Assessment
    from barchan.theory.crests import Crest
    from barchan.theory.drift import Drift
    from barchan.theory.wind_report import Subject
    from barchan.wind.records import WindRecord


def record_values(record: "WindRecord", sand: Saltation) -> list[Value]:
    """Time, rows, speeds and exceedance of a record over some sand."""
    import numpy as np

    from barchan.wind.clock import DAY

    exceeds = sand.at_own_height(record.speed, record.height) > sand.threshold_speed()
    whole = len(record) + record.missing
    doubt = "; ".join(record.warnings)
    mean = float(np.average(record.speed, weights=record.duration))
    tall = record.height if record.height is not None else sand.height
    return [
        _value("days", "time covered", "days", record.seconds / DAY),
        _value("rows", "rows", "-", whole),
        _value("missing", "rows without a wind", "fraction", record.missing / whole),
        _value("calm", "time that is calm", "fraction", record.calm_share),
        _value("height", "height of the speeds", "m", tall, "" if record.height is not None else _SUPPOSED),
        _value("mean_speed", "mean wind speed", "m/s", mean, doubt),
        _value("highest_speed", "highest wind speed", "m/s", float(record.speed.max()), doubt),
        _value("threshold", f"threshold at {sand.height:g} m", "m/s", sand.threshold_speed()),
        _value(
            "exceeded",
            "time above the threshold",
            "fraction",
            float(record.duration[exceeds].sum()) / record.seconds,
        ),
    ]


def found_values(found: "Assessment", doubt: str) -> list[Value]:
    """Drift potential, drift, crests and fingers of a wind; ``doubt`` is that of its drift potential."""
    drift = found.drift
    values = [] if found.potential is None else _potential_values(found.potential, found.threshold, doubt)
    if drift.unit != "-":
        values += [
            _value("flux", "sand flux to all sides", drift.unit, drift.total),
            _value("resultant_flux", "resultant flux", drift.unit, drift.resultant),
        ]
    return [
        *values,
        _value("flux_steadiness", "resultant over whole flux", "-", drift.steadiness),
        _angle("flux_towards", "resultant flux towards", drift.toward, "no direction stands out"),
        _crest("crest_gross_transport", "crests by gross transport", found.gross_transport),
        _crest("crest_bed_instability", "crests by bed instability", found.bed_instability),
        _angle(
            "fingers_towards", "fingers of scarce sand grow towards", found.elongation, "they do not grow"
        ),
    ]


def part_values(
    record: "WindRecord", sand: Saltation, threshold: float, by: Literal["month", "season"]
) -> list[Value]:
    """Drift potential by month or by season; raises BarchanError where the record has no dates."""
    from barchan.cli.wind_table import parts_of

    values = []
    for part in parts_of(record, sand, threshold, by):
        name, of = part.name.lower().replace(" ", "_"), f", {part.name}"
        values += [
            _value(f"days_{name}", f"days of winds{of}", "days", part.days),
            _value(f"drift_potential_{name}", f"drift potential{of}", "VU", part.potential.total),
            _value(f"resultant_{name}", f"resultant drift potential{of}", "VU", part.potential.resultant),
            _angle(
                f"direction_{name}", f"resultant drift towards{of}", part.potential.toward, "nothing moves"
            ),
        ]
    return values


def words_of(found: "Assessment") -> list[Words]:
    """Name, title, text and doubt of what the theories say in words."""
    from barchan.theory.limits_nearby import class_nearby, dunes_nearby

    near = dunes_nearby(found.drift.steadiness, found.supply)
    return [
        ("directions", "class of directions", found.variability.name, "; ".join(class_nearby(found.drift))),
        ("dunes", "dunes to expect", found.dunes, "; ".join(near)),
    ]


def rose_rows(subject: "Subject", sectors: int) -> tuple[list[str], list[list[float]]]:
    """A row for each direction that winds come from: the sand that they move and the time that they blow.

    With the names and units of its columns. Of a record the time is given by classes of speed, which the
    threshold of movement parts.
    """
    from barchan.theory.roses import sand_rose, speed_limits, wind_rose

    found, record = subject.found, subject.measured
    unit = "share" if found.drift.unit == "-" else found.drift.unit
    heading = ["from (degrees)", f"sand moved ({unit})"]
    columns: list[Sequence[float]] = [
        [360.0 * k / sectors for k in range(sectors)],
        sand_rose(found.drift, sectors).tolist(),
    ]
    if found.potential is not None:
        heading.append("drift potential (VU)")
        columns.append(sand_rose(found.potential, sectors).tolist())
    if record is not None:
        limits = speed_limits(record, subject.sand.threshold_speed())
        shares, _, _ = wind_rose(record, limits, sectors)
        edges = [f"of {low:.3g} to {high:.3g} m/s" for low, high in pairwise(limits)]
        edges = [f"below {limits[0]:.3g} m/s", *edges, f"from {limits[-1]:.3g} m/s on"]
        heading += [f"time {edge} (fraction)" for edge in edges]
        columns += shares.T.tolist()
    return heading, [list(row) for row in zip(*columns, strict=True)]


_SUPPOSED = "the record does not state it; supposed"


def _potential_values(potential: "Drift", threshold: float, doubt: str) -> list[Value]:
    from barchan.theory.drift import in_metres

    metric = "drift_potential_by_metres"
    return [
        _value("drift_potential_threshold", "threshold of drift potential at 10 m", "kn", threshold),
        _value("drift_potential", "drift potential DP", "VU", potential.total, doubt),
        _value(
            metric,
            "drift potential DP",
            "VU by m/s",
            in_metres(potential.total),
            doubt,
            row="drift_potential",
        ),
        _value(
            "resultant_drift_potential", "resultant drift potential RDP", "VU", potential.resultant, doubt
        ),
        _value("steadiness", "RDP/DP", "-", potential.steadiness),
        _angle(
            "resultant_drift_direction",
            "resultant drift direction RDD towards",
            potential.toward,
            "it cancels",
        ),
    ]


def _value(name: str, title: str, unit: str, value: float, doubt: str = "", row: str = "") -> Value:
    return Value(Measure(name, title, unit, _stated, row=row), float(value), doubt)


def _angle(name: str, title: str, value: float, absent: str, doubt: str = "") -> Value:
    measure: Measure[Any] = Measure(name, title, "degrees", _stated, reference=FROM_NORTH)
    return Value(measure, value, absent if math.isnan(value) else doubt)


def _crest(name: str, title: str, crest: "Crest") -> Value:
    rivals = ", ".join(f"{rival:.0f}°" for rival in crest.rivals)
    return _angle(
        name, title, crest.azimuth, "no direction stands out", f"as good are {rivals}" if rivals else ""
    )


def _stated(_: Any) -> float:
    raise NotImplementedError("the value of a wind is stated beside its measure")
