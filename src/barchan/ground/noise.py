"""Smooth random hills."""

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice
from barchan.streams import Stream


def hills(lattice: Lattice, stream: Stream, size: float) -> NDArray[np.float64]:
    """White noise seen through a Gaussian of standard deviation ``size`` (m), stretched to 0 … 1.

    The hills continue across the edges of the field, joined or not. In shifted rows they are taken at the
    cells' true centres.
    """
    white = (stream.draws(0, lattice.cells) / 2.0**64).reshape(lattice.shape)
    along_y = np.fft.fftfreq(lattice.rows, lattice.row_spacing)[:, None]
    along_x = np.fft.rfftfreq(lattice.columns, lattice.cell_size)[None, :]
    window = np.exp(-2.0 * (np.pi * size * np.hypot(along_x, along_y)) ** 2)
    window[0, 0] = 0.0
    waves = np.fft.rfft2(white) * window
    if lattice.hexagonal:
        waves = np.fft.ifft(waves, axis=0) * np.exp(2j * np.pi * along_x * lattice.shift[:, None])
        smooth = np.fft.irfft(waves, n=lattice.columns, axis=1)
    else:
        smooth = np.fft.irfft2(waves, s=lattice.shape)
    spread = np.ptp(smooth)
    return (smooth - smooth.min()) / spread if spread > 0 else np.zeros(lattice.shape)
