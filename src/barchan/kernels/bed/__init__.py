"""What happens to a bed whoever moves its sand: neighbours, slopes that relax, mean levels, active layers.

Nothing here knows of wind.
"""
