"""Surfaces whose measures are known: plane waves and ridges that fit the field, and drifting hills."""

import math

import numpy as np

ROWS, COLUMNS = 48, 80

WAVES = [(5, 0), (0, 3), (4, 2), (3, -2), (5, 3), (2, 3), (-4, 1)]
"""Waves over the field's width and over its depth."""


def phase(m, n, shape=(ROWS, COLUMNS)):
    """The phase (in turns) of a wave with ``m`` periods over the width and ``n`` over the depth."""
    row, col = np.mgrid[0 : shape[0], 0 : shape[1]]
    return m * col / shape[1] + n * row / shape[0] + 0.05


def sine(m, n, shape=(ROWS, COLUMNS)):
    """A plane wave of amplitude 1."""
    return np.cos(2 * np.pi * phase(m, n, shape))


def ridges(m, n, windward=0.75, shape=(ROWS, COLUMNS)):
    """Straight ridges of height 1 that rise over a share of their period and fall over the rest."""
    turn = phase(m, n, shape) % 1.0
    return np.where(turn < windward, turn / windward, (1 - turn) / (1 - windward))


def wavelength(m, n, shape=(ROWS, COLUMNS)):
    """Distance (cells) from one crest to the next."""
    return 1 / math.hypot(m / shape[1], n / shape[0])


def wind_along(m, n, shape=(ROWS, COLUMNS)):
    """The direction of the wind that blows along the wave, up its windward side."""
    return math.degrees(math.atan2(-m / shape[1], -n / shape[0])) % 360


def random_surface(seed, drift=(0.0, 0.0), shape=(ROWS, COLUMNS), size=4.0):
    """A smooth random surface, the same for the same seed, displaced by some rows and columns."""
    noise = np.fft.fft2(np.random.default_rng(seed).normal(size=shape))
    y, x = np.fft.fftfreq(shape[0])[:, None], np.fft.fftfreq(shape[1])[None, :]
    smooth = np.exp(-2 * (np.pi * size) ** 2 * (x**2 + y**2))
    return np.fft.ifft2(noise * smooth * np.exp(-2j * np.pi * (y * drift[0] + x * drift[1]))).real


def hill(row, column, shape=(ROWS, COLUMNS), size=4.0):
    """A rounded hill about a point."""
    y, x = np.mgrid[0 : shape[0], 0 : shape[1]]
    return np.exp(-((y - row) ** 2 + (x - column) ** 2) / (2 * size**2))
