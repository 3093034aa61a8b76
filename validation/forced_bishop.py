"""Forced erosion speeds the growth of Bishop's barchans (Prague thesis, §6.5.4 and Fig. 6.17).

Presets `bishop-unforced` and `bishop-forced`, 700 steps; and the angle of repose of Fig. 6.16 (presets
`bishop-repose-30` and `bishop-repose-33.7`, 500 steps): steeper slopes at the larger angle.
"""

from validation.study import measures_after, order, over_seeds

TITLE = "Bishop's barchans: forced erosion, angle of repose"


def rows():
    presets = ("bishop-forced", "bishop-unforced", "bishop-repose-33.7", "bishop-repose-30")
    forced, unforced, steep, gentle = over_seeds(measures_after, [(preset, {}) for preset in presets])
    yield order(
        "highest stack, forced against not",
        "larger",
        forced["highest_stack"],
        unforced["highest_stack"],
        "slabs",
    )
    yield order(
        "bare ground, forced against not", "larger", forced["bare_fraction"], unforced["bare_fraction"]
    )
    yield order("lee slope, 33.7° against 30°", "steeper", steep["lee_slope"], gentle["lee_slope"], "degrees")


READING = """
Forced erosion hastens Bishop's barchans as the Prague thesis shows. The mean lee slope does not
separate the two angles of repose: at 500 steps little of the field is slip face.
"""
