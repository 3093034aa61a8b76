"""Rocks in the wind: with slabs that stop before walls and without (Prague thesis, Figs. 6.14 and 6.15).

Presets `three-rocks` and `three-rocks-ignored`, 500 steps. Published: without the test sand lies on the rocks
and none gathers before them; with it the tops stay bare and sand gathers on the windward side and trails
in the lee. Before and behind are the 8 columns on either side of a rock.
"""

import numpy as np

import barchan
from validation.study import Row, order, over_seeds, spread

TITLE = "Rocks in the wind"

NEAR = 8


def sand_about(preset, seed):
    simulation = barchan.Simulation(barchan.load(preset, run__seed=seed))
    simulation.advance(500)
    rock = simulation.bed.ground > 0
    sand = simulation.bed.sand
    before = np.zeros(rock.shape, bool)
    behind = np.zeros(rock.shape, bool)
    for shift in range(1, NEAR + 1):
        before |= np.roll(rock, -shift, axis=1)
        behind |= np.roll(rock, shift, axis=1)
    return {
        "top": float(sand[rock].mean()),
        "bare": float(np.mean(sand[rock] == 0)),
        "before": float(sand[before & ~rock].mean()),
        "behind": float(sand[behind & ~rock].mean()),
        "away": float(sand[~(before | behind | rock)].mean()),
    }


def rows():
    tested, ignored = over_seeds(sand_about, [("three-rocks",), ("three-rocks-ignored",)])
    yield order("sand on tops, without against with the test", "more", ignored["top"], tested["top"], "slabs")
    yield Row("bare tops, with the test", "all", spread(tested["bare"]))
    yield order(
        "sand before rocks, with against without the test",
        "more",
        tested["before"],
        ignored["before"],
        "slabs",
    )
    yield order(
        "sand before rocks against away, with the test", "more", tested["before"], tested["away"], "slabs"
    )
    yield order(
        "sand behind rocks against away, with the test", "more", tested["behind"], tested["away"], "slabs"
    )


READING = """
With the test the tops stay bare and sand heaps up before and behind the rocks; without it hardly any
gathers before them. Rocks of 20 m stand high above the dunes, where the speed-up makes hops long, so in
both runs little stays on the tops; rocks of 10 m, lower than the dunes, are climbed with the test too.
"""
