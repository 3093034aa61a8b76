"""The layers of a cell as a list in plain Python, and as the kernels keep them."""

from itertools import pairwise

import numpy as np

from barchan.kernels.snow.state import ONE_QUANTUM, Pack, density_of, epoch_of, quanta_of


def bare(kept):
    one = np.zeros(1, np.int32)
    return Pack(
        one.copy(), one.copy(), np.zeros(1, np.int64), np.zeros((1, kept), np.int64), np.zeros(1, np.uint8)
    )


def stack(pack):
    """(quanta, epoch, density) of the cell's layers, the deepest first."""
    words = [*pack.buried[0, : pack.buried_count[0]], pack.top[0]]
    return [
        (int(quanta_of(w)), int(epoch_of(w)), round(float(density_of(w)) * 64))
        for w in words
        if w >= ONE_QUANTUM
    ]


def merged(lower, upper):
    (m, e, d), (n, f, g) = lower, upper
    return m + n, (m * e + n * f) // (m + n), round((m + n) / (m / d + n / g))


class PlainLayers:
    """A list of layers; when one too many is buried, the two neighbours that differ least become one."""

    def __init__(self, kept):
        self.layers, self.kept = [], kept

    def lay(self, epoch, density):
        if self.layers and self.layers[-1][1:] == (epoch, density):
            quanta, *kind = self.layers.pop()
            self.layers.append((quanta + 1, *kind))
            return
        if len(self.layers) == self.kept + 1:
            buried = self.layers[:-1]
            costs = [min(a[0], b[0]) * abs(a[1] - b[1]) for a, b in pairwise(buried)]
            at = costs.index(min(costs))
            self.layers[at : at + 2] = [merged(self.layers[at], self.layers[at + 1])]
        self.layers.append((1, epoch, density))

    def take(self):
        quanta, epoch, density = self.layers.pop()
        if quanta > 1:
            self.layers.append((quanta - 1, epoch, density))
        return density
