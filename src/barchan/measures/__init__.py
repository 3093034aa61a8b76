"""Measures of a bed: pure functions of arrays, in SI units and degrees.

A measure that does not exist for a bed (the spacing of a flat one) is NaN, never a made-up number. Nothing
here knows of simulations, models or files.
"""

from barchan.measures.amounts import bare_fraction, flux, highest_stack, stack_volume
from barchan.measures.dunes import Dune, find_dunes
from barchan.measures.horns import Horns, horns
from barchan.measures.migration import Migration, migration
from barchan.measures.orientation import Orientation, crest_orientation
from barchan.measures.relief import bedform_height, bedform_index
from barchan.measures.slopes import Slopes, streamwise_slopes
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
    "crest_orientation",
    "dominant_spacing",
    "find_dunes",
    "flux",
    "highest_stack",
    "horns",
    "migration",
    "stack_volume",
    "streamwise_slopes",
    "summits",
]
