"""Words and numbers of reports: lists, values with their spread, probabilities, durations."""

import json
import math
import re
from collections.abc import Sequence

from barchan.analysis import suited_units
from barchan.comparison.page import Markup, text
from barchan.comparison.statistics import Spread

_ROOT = r"(?:[A-Za-z]:[\\/]|/)"
_FOLDERS = re.compile(
    rf"(?<=['\"]){_ROOT}(?:[^/\\'\"\n]+[/\\])+|(?<![\w.~:/\\]){_ROOT}(?:[^/\\'\"=,;:<>\s]+[/\\])+"
)
"""The folders before the name of a file whose path is absolute, with spaces only in quotation marks."""


def without_folders(words: str) -> str:
    """Words in which files whose paths are absolute stand by their names."""
    return _FOLDERS.sub("", words)


def listed(names: Sequence[str]) -> str:
    """Names with commas and a last *and*."""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def number(value: float) -> str:
    """A value with four digits and a true minus; a dash where there is none."""
    return suited_units.number(value).replace("-", "−")


def spread_text(found: Spread, of: int) -> str:
    """Mean ± deviation, and of how many seeds where some have no value; a dash where none has."""
    if not found.count:
        return "–"
    more = f" ± {found.deviation:.2g}" if math.isfinite(found.deviation) else ""
    return f"{number(found.mean)}{more}" + (f" ({found.count}/{of})" if found.count < of else "")


def named(title: str, unit: str) -> Markup:
    """The title of a measure with its unit."""
    return Markup(text(title) + ("" if unit == "-" else f' <span class="unit">{text(unit)}</span>'))


def probability(p: float) -> str:
    """A probability with two digits; a dash where there is none."""
    return "–" if math.isnan(p) else "< 0.0001" if p < 1e-4 else f"{p:.2g}"


def seconds_text(duration: float) -> str:
    """A duration (s); a dash where it is not known."""
    return "–" if math.isnan(duration) else f"{duration:.1f}"


def value_text(value: object) -> str:
    """A value of a scenario as its file has it, words without quotation marks."""
    return value if isinstance(value, str) else json.dumps(value)
