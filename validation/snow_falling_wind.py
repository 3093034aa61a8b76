"""Do dunes of snow survive a strong wind that falls slowly?

60 kg/m² of loose drift, 2.4 × 9.6 m, periodic, cells and hops of 0.1 m, quanta of 2 kg/m², bonds growing;
12 m/s for 6 hours. Then the wind stops at once, and nothing moves any more; or it falls evenly to 6 m/s
within 12 hours, or goes on for 12 hours. Relief and skewness of slopes at 6 and at 18 hours. Creep by
impacts, the default, and by the threshold; with bonds that grow and without; with bonds that impacts break
to a depth (`bonding.impact_mass`), by default none; five seeds.
"""

from validation.snow_scenes import advance, at_rest, falling, fine, part
from validation.study import Row, over_seeds, spread

TITLE = "Dunes of snow under a wind that falls"

GROWING, ENDING = 6.0, 12.0
FALLS, GOES_ON = ENDINGS = ("falls", "goes on")
CASES = (
    ("impacts", -10.0, True, 0.0),
    ("impacts", -20.0, True, 0.0),
    ("impacts", -10.0, False, 0.0),
    ("threshold", -10.0, True, 0.0),
)
STRUCK = (("impacts", -10.0, True, 2.0), ("impacts", -10.0, True, 4.0), ("impacts", -20.0, True, 4.0))
"""Cases in which impacts break bonds, under the wind that falls."""


def _ending(kind, temperature):
    if kind == FALLS:
        return falling(ENDING, 12.0, 6.0, temperature)
    return [part(ENDING, 12.0, temperature)]


def after(law, temperature, bonds, struck, ending, seed):
    """Relief and skewness before and after a storm ends, whose impacts break bonds in ``struck`` kg/m²."""
    winds = [part(GROWING, 12.0, temperature), *_ending(ending, temperature)]
    model = {"temperature": temperature, "reference_wind": 10, "quantum": 2, "creep": {"law": law}}
    model["bonding"] = {"grows": bonds, "impact_mass": struck}
    simulation = fine(winds, seed, mean=30, rows=24, columns=96, **model)
    advance(simulation, GROWING)
    before = at_rest(simulation)
    advance(simulation, ENDING)
    last = at_rest(simulation)
    kept = last["relief"] / before["relief"]
    return {
        "kept": kept,
        "before": before["relief"],
        "relief": last["relief"],
        "skew": last["skew"],
        "skew_before": before["skew"],
    }


def rows():
    cases = [(*case, ending) for case in CASES for ending in ENDINGS]
    cases += [(*case, FALLS) for case in STRUCK]
    found = dict(zip(cases, over_seeds(after, cases), strict=True))
    for case in (*CASES, *STRUCK):
        yield _first(case, found[(*case, FALLS)])
        for ending in ENDINGS:
            if (*case, ending) in found:
                yield _row(f"{_where(*case)}: wind {ending}", found[(*case, ending)])


def _first(case, found):
    text = f"{_cm(found['before'])} cm, skewness {spread(found['skew_before'])}"
    return Row(f"{_where(*case)}: after 6 h of 12 m/s, and after a sudden stop", "", text)


def _where(law, temperature, bonds, struck):
    bonding = "" if bonds else ", no bonds"
    if struck:
        bonding = f", bonds broken in {struck:g} kg/m²"
    return f"creep by {law}, {temperature:g} °C{bonding}"


def _row(what, found):
    text = f"{_cm(found['relief'])} cm, skewness {spread(found['skew'])}"
    survive = sum(kept >= 0.5 for kept in found["kept"])
    return Row(what, "", f"{text}; {spread(found['kept'])} of the relief", f"{survive} of 5 keep half of it")


def _cm(values):
    return spread([100.0 * value for value in values])


READING = """
Under a steady wind dunes keep their relief or grow, and a sudden stop leaves them as they are. A wind that
falls within half a day planes them where bonds grow: at -10 °C a quarter of the relief is left, at -20 °C,
where bonds grow half as fast, half of it. Without bonds four fifths are left, and slip faces stay. So what
planes is not creep but bonding: as the wind falls, snow that lands in the troughs soon withstands it there,
while the crests, where the stress is greatest, go on giving. In one run watched from hour to hour relief
went from 15 to 5 cm while the wind fell from 9 to 6.5 m/s, and less than a tenth of the surface had bonded:
the troughs hold by young bonds. Creep by impacts is better than creep by the threshold, which leaves a
tenth, but does not cure it.

Sommer et al. (2018) saw no hardening while drift erodes. Where impacts break the young bonds of 4 kg/m² at
the surface, two thirds of the relief are left at -10 and at -20 °C, with slip faces, in every seed; of 2
kg/m² less than half of it. Ripples of snow turn over 1 to 7 kg/m², so the depth is assumed, and the lower
part of that range does not cure it. Under this closure drift that is in the air does not let its snow bond,
so that forms no longer come to rest in a steady 7 m/s (three seeds).
"""
