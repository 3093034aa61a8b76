"""Star dunes under uneven winds: do they keep their form longer?

Star dunes are said to need winds that vary in direction, speed and time, with one dominant direction; the
Prague thesis (§4.2) leaves open what that would do, and finds that stars under four equal winds merge and
lose their form (§6.1). Presets `star` (80 steps a wind), `star-unequal` (120, 80, 40 and 80 steps),
`star-speeds` (hops grow from 2 to 8 cells under each), `star-dominant` (half of the time from the west),
`star-five` (five even directions, 64 steps each), 192² cells with 10 slabs each. Arms are ridges that lead
away from a summit, top and foot the upper and the lowest third of its relief
([measures](measures.md#star-dunes)); a star has 3 arms or more. In nature arms are 3 or 4, slopes 15 to 30°
along the crest and 5 to 10° at the foot (Prague thesis, §2.1.3).
"""

import numpy as np

import barchan
from barchan.measures.orientation import crest_orientation
from barchan.measures.stars import summits
from validation.study import Row, over_seeds, spread

TITLE = "Star dunes under uneven winds"
SEEDS = (1, 2, 3)
STEPS = (640, 1280, 2560)
PRESETS = ("star", "star-unequal", "star-speeds", "star-dominant", "star-five")


def forms(preset, seed):
    """Arms, slopes and straightness after each number of steps."""
    size = {"lattice__rows": 192, "lattice__columns": 192}
    scenario = barchan.load(preset, **size, run__steps=STEPS[-1], run__save_every=640, run__seed=seed)
    run = barchan.simulate(scenario)
    found = {}
    for step in STEPS:
        surface = run["elevation"].sel(step=step).values
        peaks = summits(surface, scenario.lattice.cell_size)
        arms = [peak.arms for peak in peaks]
        found |= {
            f"summits {step}": len(peaks),
            f"arms {step}": np.mean(arms),
            f"stars {step}": np.mean(np.array(arms) >= 3),
            f"top {step}": np.mean([peak.top_slope for peak in peaks]),
            f"foot {step}": np.mean([peak.foot_slope for peak in peaks]),
            f"straightness {step}": crest_orientation(surface, scenario.lattice.cell_size).coherence,
        }
    return found


def rows():
    for preset, found in zip(PRESETS, over_seeds(forms, [(p,) for p in PRESETS], SEEDS), strict=True):
        for step in STEPS:
            spreads = {name: spread(values, 2) for name, values in found.items() if name.endswith(f" {step}")}
            yield Row(
                f"`{preset}`, {step} steps",
                "3 to 4 arms, top 15–30°, foot 5–10°" if step == STEPS[0] else "-",
                f"{spreads[f'summits {step}']} summits, {spreads[f'arms {step}']} arms, "
                f"stars {spreads[f'stars {step}']}, "
                f"top {spreads[f'top {step}']}°, foot {spreads[f'foot {step}']}°, "
                f"straightness {spreads[f'straightness {step}']}",
            )


READING = """
No. After 640 steps most summits stand on ridges with two ends, and few are stars by our count: 1 in 28
under equal winds, as few under uneven ones. The later share of stars is larger only because fewer summits
are left. After 2560 steps none of the three kinds of unevenness that the Prague thesis asks for has more
stars than equal winds, nor crests less straight, beyond the scatter of three runs; under hops that grow no
star is left. What the four winds share, directions along the axes of the lattice and right angles between
them, shapes ridges along its diagonals. Five even directions change more than any unevenness: most summits
are left, and the largest share of them, two fifths in the mean of three runs, has three arms at the end.
(Over level tops of stacks, with slides to the steepest neighbour, it was a quarter.) Slopes
at the top grow to 15 to 19° with size, and so into the range of real crests (15 to 30°); feet stay at 13 to
20°, too steep, for slabs leave no gentle apron.
"""
