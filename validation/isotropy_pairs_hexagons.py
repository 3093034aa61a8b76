"""Crests under pairs of winds on hexagons, with the rules that are the default off the axes.

The winds and the theory are those of the study of squares: two winds 60 to 150° apart in turn, one of them
once, twice or four times as long as the other. Their bisector comes from 270°, along the rows, or from 255°,
half way from an axis to the next axis of symmetry. 256 × 296 hexagons with 10 slabs each, 800 steps; one
seed, so that cases tell more than runs.
"""

from validation.isotropy import DEFAULT
from validation.isotropy_bench import Variant
from validation.isotropy_pairs import grown, rows_of

TITLE = "Crests under pairs of winds on hexagons"

BISECTORS = (255.0, 270.0)
SEEDS = (1,)
HEXAGONS = {"kind": "hex", "rows": 296, "columns": 256}
VARIANTS = {model: Variant(model, model, DEFAULT, HEXAGONS) for model in ("werner", "momiji")}


def rows():
    yield from rows_of(grown(VARIANTS, BISECTORS, SEEDS), VARIANTS, BISECTORS)


READING = """
Crests on hexagons lie as they do [on squares](#crests-under-pairs-of-winds-with-shadow-from-the-place),
along the rows as well as off them: but at 90° the cases' means of Werner's model are off by 2.0° in the
mean and by 6.5° at most, those of Momiji's by 2.1 and 4.8° under equal winds and by some 9 and 14° under
unequal ones, to the same side. So what turns Momiji's crests under unequal winds is the model and no
lattice.
"""
