"""Do dunes of snow survive a strong wind that falls slowly?

60 kg/m² of loose drift, 2.4 × 9.6 m, periodic, cells and hops of 0.1 m, quanta of 2 kg/m², bonds growing;
12 m/s for 6 hours. Then the wind stops at once, and nothing moves any more; or it falls evenly to 6 m/s
within 12 hours, or goes on for 12 hours. Relief and skewness of slopes at 6 and at 18 hours. Creep by
impacts, the default, and by the threshold; with bonds that grow and without; five seeds.
"""

from validation.snow_scenes import advance, at_rest, falling, fine, part
from validation.study import Row, over_seeds, spread

TITLE = "Dunes of snow under a wind that falls"

GROWING, ENDING = 6.0, 12.0
ENDINGS = ("falls", "goes on")
CASES = (
    ("impacts", -10.0, True),
    ("impacts", -20.0, True),
    ("impacts", -10.0, False),
    ("threshold", -10.0, True),
)


def _ending(kind, temperature):
    if kind == "falls":
        return falling(ENDING, 12.0, 6.0, temperature)
    return [part(ENDING, 12.0, temperature)]


def after(law, temperature, bonds, ending, seed):
    """Relief and skewness before and after the end of a storm."""
    winds = [part(GROWING, 12.0, temperature), *_ending(ending, temperature)]
    model = {"temperature": temperature, "reference_wind": 10, "quantum": 2, "creep": {"law": law}}
    model["bonding"] = {"grows": bonds}
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
    found = dict(zip(cases, over_seeds(after, cases), strict=True))
    for law, cold, bonds in CASES:
        first = found[law, cold, bonds, "falls"]
        where = f"creep by {law}, {cold:g} °C{'' if bonds else ', no bonds'}"
        text = f"{_cm(first['before'])} cm, skewness {spread(first['skew_before'])}"
        yield Row(f"{where}: after 6 h of 12 m/s, and after a sudden stop", "", text)
        for ending in ENDINGS:
            yield _row(f"{where}: wind {ending}", found[law, cold, bonds, ending])


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
tenth, but does not cure it. Sommer et al. (2018) saw no hardening while drift erodes; bonds that do not
grow under drift are not modelled.
"""
