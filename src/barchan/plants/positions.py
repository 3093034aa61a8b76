"""How much of a dune's sides plants cover."""

from typing import Any

from barchan.bed import Bed
from barchan.measures.positions import Position, mean_by_position, positions
from barchan.model import ModelMeasure
from barchan.wind.segment import Segment

TITLES = {
    Position.FLOOR: "plants on the floor between dunes",
    Position.WINDWARD: "plants on windward sides",
    Position.CREST: "plants on crests",
    Position.LEE: "plants on lee sides",
}


def cover_at(position: Position) -> ModelMeasure:
    """The mean effectiveness of all plants on the cells of a position; NaN where there is none."""

    def compute(model: Any, bed: Bed, wind: Segment) -> float:
        from barchan.measures.bedform_surface import bedform_surface
        from barchan.measures.landform import half_spacing
        from barchan.measures.spacing import dominant_spacing

        lattice = bed.lattice
        surface = bedform_surface(bed.ground, bed.depth, lattice.cell_size, lattice.periodic)
        spacing = dominant_spacing(surface, lattice.cell_size, wind.direction, lattice.periodic)
        reach = half_spacing(spacing, lattice.cell_size, surface.shape)
        found = positions(surface, lattice.cell_size, wind.direction, reach, lattice.periodic)
        return mean_by_position(model.effectiveness(bed), found)[position]

    return ModelMeasure(f"plants_{position.name.lower()}", TITLES[position], "-", compute)


COVER_BY_POSITION = tuple(map(cover_at, Position))
"""Measures of the plants on each part of the dunes."""
