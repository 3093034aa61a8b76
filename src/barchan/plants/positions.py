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


def cover_at(position: str) -> ModelMeasure:
    """The mean effectiveness of all plants on the cells of a position; NaN where there is none."""

    def compute(model: Any, bed: Bed, wind: Segment) -> float:
        from barchan.measures.landform import half_spacing
        from barchan.measures.positions import Position, mean_by_position, positions
        from barchan.measures.spacing import dominant_spacing
        from barchan.squares import Squares, bedforms_of

        lattice, surface = bed.lattice, bedforms_of(bed)
        spacing = dominant_spacing(surface, lattice.cell_size, wind.direction, lattice.periodic)
        reach = half_spacing(spacing, lattice.cell_size, surface.shape)
        found = positions(surface, lattice.cell_size, wind.direction, reach, lattice.periodic)
        cover = Squares(lattice).between(model.effectiveness(bed))
        return mean_by_position(cover, found)[Position[position.upper()]]

    return ModelMeasure(f"plants_{position}", TITLES[position], "-", compute)


COVER_BY_POSITION = tuple(map(cover_at, TITLES))
"""Measures of the plants on each part of the dunes."""
