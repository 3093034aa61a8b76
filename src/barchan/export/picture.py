"""Pictures: a map of one frame with title, scale and wind, of any size."""

from io import BytesIO
from pathlib import Path
from typing import Any

from barchan.export.source import Source

CENTIMETRES = 2.54
"""Centimetres to the inch."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Draw the surface, or another field."""
    from barchan.analysis.fields import field_of
    from barchan.figures.fields import field_map
    from barchan.figures.maps import relief_map

    (step,), (name,), scenario = source.steps, source.fields, source.scenario
    frame = source.frame(step)
    if name == "elevation":
        figure = relief_map(frame, scenario)
    else:
        figure = field_map(field_of(frame, scenario, name), frame, scenario)
    if source.options.size is not None:
        width, height = source.options.size
        figure.set_size_inches(width / CENTIMETRES, height / CENTIMETRES)
    drawn = BytesIO()
    figure.savefig(drawn, dpi=source.options.dpi or figure.dpi, format=path.suffix[1:].lower())
    path.write_bytes(drawn.getvalue())
    return {}
