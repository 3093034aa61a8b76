"""Snow in the wind: how it bonds, how dense it falls and lies, how it packs, and how much of it drifts.

Pure functions of numbers and arrays. Temperatures in °C, winds (m/s) at 10 m, ages in hours, densities in
kg/m³, stresses in Pa.
"""
