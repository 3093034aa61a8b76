"""Surfaces of each class of dune field, drawn by formulas; metres on cells of 1 m unless said otherwise."""

import numpy as np

from tests.measures.waves import ridges, sine


def barchan(along, across, height=4.0, size=16.0):
    """A crescent whose horns point to growing ``along``: a gentle back, a steep front, arms to both sides."""
    bend = (
        0.6 * size * np.minimum((across / size) ** 2, 4.0)
    )  # the brink recedes from the middle to the horns
    width = np.clip(1.0 - (across / (1.25 * size)) ** 2, 0.0, None)
    place = along - bend
    back, front = 1.6 * size * width, 0.4 * size * np.sqrt(width) + 1e-9
    profile = np.where(place < 0, 1 + place / np.maximum(back, 1e-9), 1 - place / front)
    return height * width * np.clip(profile, 0.0, None)


def field_of_dunes(one, places, shape=(128, 128)):
    """The highest of copies of a dune at places (row, column) on a floor."""
    north, east = np.mgrid[: shape[0], : shape[1]].astype(float)
    surface = np.zeros(shape)
    for row, column in places:
        surface = np.maximum(surface, one(east - column, north - row))
    return surface


PLACES = [(30, 30), (34, 94), (94, 62)]


def star(x, y, height=12.0, arms=4):
    """A peak with straight arms."""
    distance, angle = np.hypot(x, y), np.arctan2(y, x)
    thickness = np.abs(np.sin(arms * angle / 2)) * distance
    arm = np.exp(-((thickness / 8.0) ** 2)) * np.clip(1 - distance / 60.0, 0, None)
    return height * np.maximum(arm, np.exp(-((distance / 12.0) ** 2)))


FIELDS = {
    "flat": (0.02 * sine(6, 0, (128, 128)), 1.0, np.nan),
    "ripples": (0.008 * ridges(6, 0, shape=(128, 128)), 0.006, np.nan),
    "transverse": (3.0 * ridges(5, 1, shape=(128, 128)), 1.0, np.nan),
    "linear": (3.0 * sine(5, 1, (128, 128)), 1.0, 170.0),
    "barchan": (field_of_dunes(barchan, PLACES), 1.0, np.nan),
    "parabolic": (field_of_dunes(lambda x, y: barchan(-x, y), PLACES), 1.0, 270.0),
    "star": (field_of_dunes(star, [(64, 64), (64, 190), (190, 64), (190, 190)], (256, 256)), 1.0, np.nan),
}
"""For each class a surface, the size of its cells (m) and the wind, NaN where the shape shows it."""
