"""Other amounts of sand, 1000 steps on 256 × 256 cells, with the rules of both sources.

The Prague thesis is the barchan scene of its Table 6.1 (preset `barchans`); Elder (2009) is preset
`field-3` on the smaller field (Moore neighbourhood, shadow from the edge, sand dropped at random). Little
sand makes barchans on bare ground, much sand makes transverse ridges: barchans with 1 to 3 slabs a cell, no
barchan phase with 10 (Elder 2009), transverse ridges with 10 (Prague thesis, §6.1); between barchans some
30 % of the field or more are bare. Straightness is the coherence of crest directions (1: all parallel).
"""

from validation.study import Row, measures_after, order, over_seeds, spread

TITLE = "Sand supply"

DEPTHS = (1, 2, 3, 5, 10, 20)


PRESETS = {"Prague thesis": "barchans", "Elder 2009": "field-3"}


def rows():
    size = {"lattice__rows": 256, "lattice__columns": 256, "run__steps": 1000}
    cases = [(preset, {**size, "sand__mean": depth}) for preset in PRESETS.values() for depth in DEPTHS]
    results = over_seeds(measures_after, cases)
    for at, source in enumerate(PRESETS):
        by_depth = dict(zip(DEPTHS, results[at * len(DEPTHS) :], strict=False))
        for depth, result in by_depth.items():
            found = (
                f"bare {spread(result['bare_fraction'])}, straightness {spread(result['straightness'])}, "
                f"highest {spread(result['highest_stack'])} slabs"
            )
            yield Row(f"{source}, {depth} slabs a cell", "-", found)
        few, many = by_depth[3], by_depth[10]
        what = f"{source}, bare ground, 3 against 10 slabs"
        yield order(what, "more with less sand", few["bare_fraction"], many["bare_fraction"])
        what = f"{source}, straightness, 10 against 3 slabs"
        yield order(what, "straighter with more sand", many["straightness"], few["straightness"])


READING = """
Less sand leaves more ground bare and makes shorter, more bent crests, under both sources' rules. With
erosion in shadow allowed (Prague thesis) the ground between barchans is dotted with bumps, so less of it is
bare than 30 %. One slab a cell forms nothing in 1000 steps under either source's rules, two form nothing
under those of the Prague thesis.
"""
