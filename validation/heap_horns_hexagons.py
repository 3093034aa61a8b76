"""The horns of one barchan on hexagons, grown out of a round heap, at several angles to their rows.

The heap, the model and the measures are those of the study of squares: 256 × 296 hexagons, 200 steps, winds
at 0 to 30° to the rows of the lattice, 8 seeds; shadow from each slab's place over level tops with slides to
the steepest neighbour, and over sloping tops with slides to a neighbour drawn by the steps.
"""

from validation.heap_horns import HEXAGONS, SEEDS, row, shape

TITLE = "The horns of a heap on hexagons"

ANGLES = (0.0, 7.5, 15.0, 22.5, 30.0)


def rows():
    for rule in HEXAGONS:
        for angle in ANGLES:
            yield row(f"{rule}, {angle:g}°", [shape(rule, angle, seed) for seed in SEEDS])


READING = """
Level tops shorten horns off the rows less than on squares ([above](#the-horns-of-a-heap-off-the-axes)). With
sloping tops and slides downslope horns are 14 to 20 m long where they are 19 m along the rows, and alike
within 11 ± 6 % at every angle.
"""
