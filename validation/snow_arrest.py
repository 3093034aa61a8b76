"""How large may a dune of snow be and still move? Prediction: √(37 Q t* / ρ).

Snow rests in a dune for its length over its speed; where bonds meet the wind first, at the age t* at which
0.64 of the threshold of drift equals the shear stress, it stays. Domes of drift, a 37th as high as long, on
bare ground under a steady wind; one locks when more than a tenth of its snow has never moved in the end. The
greatest mobile length is where that share passes a tenth, between lengths of 1.5 to 12 m; five seeds. A seed
agrees where that interval comes within a factor of two of the prediction.
"""

import math

import numpy as np
from scipy.optimize import brentq

from barchan.snow.conditions import Conditions
from validation.snow_scenes import dome, field
from validation.study import Row, over_seeds, spread

TITLE = "The greatest dune of snow that moves"

LENGTHS = (1.5, 3.0, 6.0, 12.0)
LOCKED = 0.1
CASES = ((7.8, -10.0), (8.5, -10.0), (9.5, -10.0), (7.8, -20.0), (8.5, -20.0))


def predicted(wind, temperature):
    """√(37 Q t* / ρ) in m, t* in hours at this temperature."""
    now = Conditions(field(max(wind, 9.0), temperature, 1).model.parameters, wind, temperature)
    found = brentq(
        lambda log: 0.64 * float(now.threshold(now.drift_density, 10.0**log)) - now.stress, -1.0, 4.0
    )
    hours = 10.0**found / now.rate
    return math.sqrt(37.0 * now.flux * hours * 3600.0 / now.drift_density)


def locked(length, wind, temperature, seed):
    return {"share": dome(length, wind, temperature, seed)}


def bracket(shares):
    """The greatest length that moves in one run of each length, and the least that locks."""
    above = np.flatnonzero(np.asarray(shares) > LOCKED)
    at = int(above[0]) if above.size else len(LENGTHS)
    return (LENGTHS[at - 1] if at else 0.0), (LENGTHS[at] if at < len(LENGTHS) else math.inf)


def rows():
    cases = [(length, wind, temperature) for wind, temperature in CASES for length in LENGTHS]
    results = [result["share"] for result in over_seeds(locked, cases)]
    for number, (wind, temperature) in enumerate(CASES):
        shares = results[number * len(LENGTHS) : (number + 1) * len(LENGTHS)]
        expected = predicted(wind, temperature)
        brackets = [bracket(one) for one in zip(*shares, strict=True)]
        votes = sum(low <= 2.0 * expected and high >= expected / 2.0 for low, high in brackets)
        found = " or ".join(f"between {low:g} and {high:g} m" for low, high in sorted(set(brackets)))
        listed = ", ".join(f"{spread(100.0 * np.array(share), 2)} %" for share in shares)
        yield Row(
            f"{wind:g} m/s, {temperature:g} °C",
            f"{expected:.2g} m",
            f"{found} (never moved: {listed} of {', '.join(map(str, LENGTHS))} m)",
            f"{votes} of {len(brackets)} seeds",
        )


READING = """
The limit grows with the wind and as it gets colder, and lies within a factor of two of the prediction in
all five cases and with every seed. As Sharma et al. (2019, The Cryosphere 13) found, small domes travel on,
middle ones leave a core and large ones stay. At 7.8 m/s and -10 °C, little above the threshold, even the
smallest dome is locked: there snow bonds before it has moved at all. Seeds differ by half a percent of the
snow at most.
"""
