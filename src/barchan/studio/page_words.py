"""Refusals and remarks in the words of the page, where the command line speaks of keys, JSON and commands."""

import re
from collections.abc import Iterable

_SPOKEN: tuple[tuple[re.Pattern[str], str], ...] = (
    (re.compile(r"give the scenario a clock \(key clock\)"), "switch Clock on in the panel"),
    (
        re.compile(r'the speed in m/s \(with "unit": "m/s"\) or leave it out and set model\.wind_speed'),
        "the speed in m/s, chosen as its unit, or leave it out and set the wind speed of the model",
    ),
    (
        re.compile(r'state what enters with "influx", for instance \{[^}]*\}'),
        "choose what enters under Influx in the panel, for instance the kind saturation with a share of 0.2",
    ),
    (re.compile(r'\("unit": "(\w+)"\)'), r"(unit \1)"),
    (
        re.compile(r": rio warp FILE new\.tif --dst-crs \S+ --resampling bilinear"),
        ", which a GIS does (in QGIS: Raster, Projections, Warp)",
    ),
)


def page_words(text: str) -> str:
    """A text as those read it who have the panel before them, not a file or a terminal."""
    for pattern, spoken in _SPOKEN:
        text = pattern.sub(spoken, text)
    return text


def all_page_words(texts: Iterable[str]) -> list[str]:
    """Several texts, likewise."""
    return [page_words(text) for text in texts]
