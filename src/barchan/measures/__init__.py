"""Measures of a bed: pure functions of arrays, in SI units and degrees.

A measure that does not exist for a bed (the spacing of a flat one) is NaN, never a made-up number. Cells that
are NaN are voids and count for nothing. Nothing here knows of simulations, models or files.
"""

from barchan.measures.amounts import bare_fraction, flux, highest_stack, stack_volume
from barchan.measures.arms import Arms, arms
from barchan.measures.bedform_surface import bedform_surface
from barchan.measures.change import Budget, Displacement, Estimate, budget, displacement_between
from barchan.measures.crest_lines import CrestLine, crest_length, crest_lines, defect_density, mean_direction
from barchan.measures.crest_spacing import CrestSpacing, crest_spacing
from barchan.measures.crest_to_toe import crest_to_toe_height
from barchan.measures.dune_shapes import DuneShape, dune_shape, outline
from barchan.measures.dune_tracks import Encounter, Track, Tracks, track_dunes
from barchan.measures.dunes import Dune, find_dunes
from barchan.measures.fits import Fitted, PowerLaw, SpeedSizeLaw, power_law, speed_size
from barchan.measures.floor import dunes_on_floor, floor_beneath, floor_share
from barchan.measures.flux_profile import FluxProfile, flux_profile
from barchan.measures.horns import Horns, horns
from barchan.measures.landform import Landform, landform
from barchan.measures.lee_side import LeeSide, lee_side
from barchan.measures.migration import Migration, migration
from barchan.measures.orientation import Orientation, crest_orientation
from barchan.measures.positions import Position, mean_by_position, positions
from barchan.measures.relief import bedform_height, bedform_index
from barchan.measures.roughness import frontal_area_index, roughness
from barchan.measures.slopes import Slopes, slip_face_angle, streamwise_slopes
from barchan.measures.spacing import dominant_spacing
from barchan.measures.stars import Summit, summits
from barchan.measures.trends import Steadiness, coarsening, steadiness

__all__ = [
    "Arms",
    "Budget",
    "CrestLine",
    "CrestSpacing",
    "Displacement",
    "Dune",
    "DuneShape",
    "Encounter",
    "Estimate",
    "Fitted",
    "FluxProfile",
    "Horns",
    "Landform",
    "LeeSide",
    "Migration",
    "Orientation",
    "Position",
    "PowerLaw",
    "Slopes",
    "SpeedSizeLaw",
    "Steadiness",
    "Summit",
    "Track",
    "Tracks",
    "arms",
    "bare_fraction",
    "bedform_height",
    "bedform_index",
    "bedform_surface",
    "budget",
    "coarsening",
    "crest_length",
    "crest_lines",
    "crest_orientation",
    "crest_spacing",
    "crest_to_toe_height",
    "defect_density",
    "displacement_between",
    "dominant_spacing",
    "dune_shape",
    "dunes_on_floor",
    "find_dunes",
    "floor_beneath",
    "floor_share",
    "flux",
    "flux_profile",
    "frontal_area_index",
    "highest_stack",
    "horns",
    "landform",
    "lee_side",
    "mean_by_position",
    "mean_direction",
    "migration",
    "outline",
    "positions",
    "power_law",
    "roughness",
    "slip_face_angle",
    "speed_size",
    "stack_volume",
    "steadiness",
    "streamwise_slopes",
    "summits",
    "track_dunes",
]
