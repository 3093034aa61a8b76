"""Frames of runs for other programs: one format a module, one function for all of them."""

from barchan.export.formats import FORMATS, Format, format_of
from barchan.export.layer_table import layer_table
from barchan.export.options import Options
from barchan.export.writing import export

__all__ = ["FORMATS", "Format", "Options", "export", "format_of", "layer_table"]
