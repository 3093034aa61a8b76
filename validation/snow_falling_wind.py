"""Do dunes of snow survive a strong wind that falls slowly?

60 kg/m² of loose drift, 2.4 × 9.6 m, periodic, cells and hops of 0.1 m, quanta of 2 kg/m², bonds growing;
12 m/s for 6 hours. Then the wind stops at once, falls evenly to 6 m/s within 12 hours, or goes on for 12
hours; relief and skewness of slopes before and after. Creep by impacts, the default, and by the threshold;
five seeds.
"""

from validation.snow_scenes import advance, at_rest, falling, fine, part
from validation.study import Row, over_seeds, spread

TITLE = "Dunes of snow under a wind that falls"

GROWING, ENDING = 6.0, 12.0
ENDINGS = ("stops", "falls", "goes on")
LAWS = ("impacts", "threshold")
TEMPERATURES = (-10.0, -20.0)


def _ending(kind, temperature):
    if kind == "falls":
        return falling(ENDING, 12.0, 6.0, temperature)
    return [part(ENDING, 12.0 if kind == "goes on" else 0.0, temperature)]


def after(law, temperature, ending, seed):
    """Relief and skewness before and after the end of a storm."""
    winds = [part(GROWING, 12.0, temperature), *_ending(ending, temperature)]
    model = {"temperature": temperature, "reference_wind": 10, "quantum": 2, "creep": {"law": law}}
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
    cases = [(law, cold, ending) for law in LAWS for cold in TEMPERATURES for ending in ENDINGS]
    found = dict(zip(cases, over_seeds(after, cases), strict=True))
    for law in LAWS:
        for cold in TEMPERATURES:
            first = found[law, cold, "stops"]
            where = f"creep by {law}, {cold:g} °C"
            text = f"{_cm(first['before'])} cm, skewness {spread(first['skew_before'])}"
            yield Row(f"{where}: relief after 6 h of 12 m/s", "", text)
            for ending in ENDINGS:
                yield _row(f"{where}: wind {ending}", found[law, cold, ending])


def _row(what, found):
    text = f"{_cm(found['relief'])} cm, skewness {spread(found['skew'])}"
    survive = sum(kept >= 0.5 for kept in found["kept"])
    return Row(what, "", f"{text}; {spread(found['kept'])} of the relief", f"{survive} of 5 keep half of it")


def _cm(values):
    return spread([100.0 * value for value in values])


READING = """
"""
