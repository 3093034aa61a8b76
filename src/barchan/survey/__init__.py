"""Surfaces from anywhere, measured: elevation models, arrays, frames of runs; one, or two dates of one place.

Reads with the readers of ``ground`` and ``archive``, measures with ``measures``, writes crest lines and
dunes.
"""

from barchan.survey.comparing import Comparison, Finding, compare
from barchan.survey.height_field import HeightField
from barchan.survey.measuring import Survey, measure
from barchan.survey.reading import read_field
from barchan.survey.writing import write_crests, write_dunes

__all__ = [
    "Comparison",
    "Finding",
    "HeightField",
    "Survey",
    "compare",
    "measure",
    "read_field",
    "write_crests",
    "write_dunes",
]
