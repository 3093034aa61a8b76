"""How much of a dune's sides plants cover."""

from typing import Any

from barchan.bed import Bed
from barchan.model import ModelMeasure
from barchan.wind.segment import Segment

TITLES = {
    "floor": "plants on the floor between dunes",
    "windward": "plants on windward sides",
    "crest": "plants on crests",
    "lee": "plants on lee sides",
}


def cover_by_position(model: Any, bed: Bed, wind: Segment) -> dict[str, float]:
    """The mean effectiveness of all plants on the cells of each position; NaN where it has none."""
    from barchan.measures.landform import half_spacing
    from barchan.measures.positions import mean_by_position, positions
    from barchan.measures.spacing import dominant_spacing
    from barchan.squares import Squares, bedforms_of

    lattice, surface = bed.lattice, bedforms_of(bed)
    spacing = dominant_spacing(surface, lattice.cell_size, wind.direction, lattice.periodic)
    reach = half_spacing(spacing, lattice.cell_size, surface.shape)
    found = positions(surface, lattice.cell_size, wind.direction, reach, lattice.periodic)
    means = mean_by_position(Squares(lattice).between(model.effectiveness(bed)), found)
    return {position.name.lower(): mean for position, mean in means.items()}


COVER_BY_POSITION = tuple(
    ModelMeasure(f"plants_{name}", title, "-", lambda means, name=name: means[name], cover_by_position)
    for name, title in TITLES.items()
)
"""Measures of the plants on each part of the dunes."""
