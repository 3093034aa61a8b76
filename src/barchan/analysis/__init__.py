"""Measures of a bed and of its course in time: plain functions of arrays in SI units and degrees.

A measure that does not exist for a bed (the spacing of a flat one) is NaN, never a made-up number.
"""

from barchan.analysis.dunes import Dune, find_dunes
from barchan.analysis.heights import bare_fraction, highest_stack, sand_volume
from barchan.analysis.horns import Horns, horns
from barchan.analysis.migration import Migration, migration
from barchan.analysis.orientation import Orientation, crest_orientation
from barchan.analysis.relief import bedform_height, bedform_index
from barchan.analysis.slopes import Slopes, streamwise_slopes
from barchan.analysis.spacing import dominant_spacing
from barchan.analysis.stars import Summit, summits
from barchan.analysis.transport import flux

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
    "sand_volume",
    "streamwise_slopes",
    "summits",
]
