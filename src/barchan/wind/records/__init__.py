"""Wind records of stations and reanalyses, read from tables and NetCDF files.

A record is data in SI units; nothing here knows of sand.
"""

from barchan.wind.records.format import RecordFormat
from barchan.wind.records.reading import SAMPLE, read_record
from barchan.wind.records.record import WindRecord

__all__ = ["SAMPLE", "RecordFormat", "WindRecord", "read_record"]
