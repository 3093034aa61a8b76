"""Wind records: what a station or a reanalysis measured, read from CSV and NetCDF files.

A record is data in SI units; what it does to sand is not known here.
"""

from barchan.wind.records.format import RecordFormat
from barchan.wind.records.reading import SAMPLE, read_record
from barchan.wind.records.record import WindRecord

__all__ = ["SAMPLE", "RecordFormat", "WindRecord", "read_record"]
