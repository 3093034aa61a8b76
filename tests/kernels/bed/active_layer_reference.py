"""Sand of several sizes the slow and obvious way: a list of parcels in each cell's layer and one below it."""

from barchan.streams import GOLDEN, MASK, mix


class Stacks:
    """Cells with sorted parcels in the active layer and below it."""

    def __init__(self, layers, deeps, full, turn=0):
        self.layers, self.deeps = [sorted(one) for one in layers], [sorted(one) for one in deeps]
        self.full, self.turn = full, turn

    def draw(self, parcels):
        """A parcel of a sorted list, drawn by the next 32 bits, without it in the list any more."""
        self.turn = (self.turn + GOLDEN) & MASK
        return parcels.pop((mix(self.turn) >> 32) * len(parcels) >> 32)

    def put(self, cell, kind, parcels):
        layer, deep = self.layers[cell], self.deeps[cell]
        layer.extend([kind] * parcels)
        layer.sort()
        while len(layer) > self.full:
            deep.append(self.draw(layer))
            deep.sort()

    def take(self, cell, kind, parcels):
        layer, deep = self.layers[cell], self.deeps[cell]
        for _ in range(parcels):
            layer.remove(kind)
        while len(layer) < self.full and deep:
            layer.append(self.draw(deep))
            layer.sort()

    def slide(self, cell, other):
        layer = self.layers[cell]
        kind = self.draw(layer)
        layer.append(kind)
        layer.sort()
        self.take(cell, kind, 1)
        self.put(other, kind, 1)

    def counts(self, sizes):
        """Parcels by size and cell, in the layers and below."""
        return [
            [[cell.count(kind) for cell in cells] for kind in range(sizes)]
            for cells in (self.layers, self.deeps)
        ]
