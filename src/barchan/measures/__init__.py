"""Measures of a bed: pure functions of arrays, in SI units and degrees.

A measure that does not exist for a bed (the spacing of a flat one) is NaN, never a made-up number. Cells that
are NaN are voids and count for nothing. Nothing here knows of simulations, models or files.
"""

from barchan.measures.amounts import bare_fraction, flux, highest_stack, stack_volume
from barchan.measures.bedform_surface import bedform_surface
from barchan.measures.crest_to_toe import crest_to_toe_height
from barchan.measures.dunes import Dune, find_dunes
from barchan.measures.horns import Horns, horns
from barchan.measures.migration import Migration, migration
from barchan.measures.orientation import Orientation, crest_orientation
from barchan.measures.relief import bedform_height, bedform_index
from barchan.measures.slopes import Slopes, slip_face_angle, streamwise_slopes
from barchan.measures.spacing import dominant_spacing
from barchan.measures.stars import Summit, summits

__all__ = [
    "Dune",
    "Horns",
    "Migration",
    "Orientation",
    "Slopes",
    "Summit",
    "bare_fraction",
    "bedform_height",
    "bedform_index",
    "bedform_surface",
    "crest_orientation",
    "crest_to_toe_height",
    "dominant_spacing",
    "find_dunes",
    "flux",
    "highest_stack",
    "horns",
    "migration",
    "slip_face_angle",
    "stack_volume",
    "streamwise_slopes",
    "summits",
]
