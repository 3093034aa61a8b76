"""Mean slopes of both sides of ridges with avalanches either way, and with none against the wind.

Preset `no-upwind-avalanches` (1000 steps) with the switch either way. Elder (2009) finds cross-sections
roughly symmetric with avalanches both ways and asymmetric without those against the wind (its Fig. 5). It
does not say which side is the steeper.
"""

import numpy as np

from validation.study import Row, measures_after, order, over_seeds, spread

TITLE = "Profiles with and without avalanches against the wind"


def rows():
    cases = [("no-upwind-avalanches", {"model__upwind_avalanches": either}) for either in (True, False)]
    both, lee_only = over_seeds(measures_after, cases)
    ratios = [np.divide(case["lee_slope"], case["windward_slope"]) for case in (both, lee_only)]
    for name, published, case, ratio in zip(
        ("either way", "none upwind"), ("about 1", "not 1"), (both, lee_only), ratios, strict=True
    ):
        slopes = f"windward {spread(case['windward_slope'])}°, lee {spread(case['lee_slope'])}°"
        yield Row(f"lee to windward slope, {name}", published, f"{spread(ratio)} ({slopes})")
    asymmetry = [np.abs(np.log(ratio)) for ratio in ratios]
    yield order(
        "asymmetry (log of the ratio, either sign), none upwind against either way",
        "larger",
        asymmetry[1],
        asymmetry[0],
    )


READING = """
Profiles are symmetric with avalanches both ways and asymmetric without those against the wind, but the other
way round than nature's dunes: nothing relaxes the windward side, which becomes a cliff, while the lee side
stays below the angle of repose because slabs that settle in shadow fill it from its foot. The gentle windward
sides of real dunes need the wind's speed-up (Momiji).
"""
