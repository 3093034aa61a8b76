"""Weather of nine hours as a file of the kind SMET, with units and what is added to them in its heading."""

SMET = """SMET 1.1 ASCII
[HEADER]
station_id = SNOW
nodata = -999
fields = timestamp TA PSUM
units_offset = 0 273.15 0
[DATA]
2024-01-01T00:00 -10.0 0.0
2024-01-01T03:00 -16.0 6.0
2024-01-01T06:00 -16.0 3.0
2024-01-01T09:00 -19.0 0.0
"""
