"""Crests under pairs of winds, with the rules that are the default off the axes.

Two winds 60 to 150° apart blow in turn, one of them once, twice or four times as long as the other (a
turn of the weaker one is 5 steps); their bisector comes from 270°, along an axis, or from 250°. 256 ×
256 cells with 10 slabs each, 800 steps, 5 seeds; Werner's and Momiji's model with shadow from the place over
sloping tops and slides downslope, and Momiji's with some changes (3 seeds). Theory is gross
bedform-normal transport (Rubin & Hunter 1987). Of two winds it has two candidates, one across the sum of
both, one across their difference, of which the one with more transport across it should win. Errors are from
the winner, positive clockwise. Cases whose candidates lie less than 20° apart are left out; at 90° both have
the same transport, and the nearer one counts. A case is a pair of winds with both bisectors.
"""

from pathlib import Path

import numpy as np

from barchan.directions import bearing, downwind
from barchan.figures.style import new_figure
from barchan.theory.crests import gross_transport
from barchan.theory.drift import Drift
from validation.isotropy import DEFAULT, NO_SPEEDUP
from validation.isotropy_bench import Case, Variant, measured
from validation.orientation import difference
from validation.study import Row

TITLE = "Crests under pairs of winds, with shadow from the place"

FIGURE = Path(__file__).parents[1] / "docs" / "_static" / "directions-pairs.png"
DIVERGENCES = (60, 75, 90, 105, 120, 135, 150)
RATIOS = (1, 2, 4)
BISECTORS = (250.0, 270.0)
SEEDS = (1, 2, 3, 4, 5)
TURN = 5
LEAST_APART = 20.0
LEAST_COHERENCE = 0.3
TIE = 0.01
"""Candidates whose transport differs by less than this share are equally good."""


def winds(divergence, ratio, bisector, turn=TURN):
    """The stronger wind and the weaker one, with their steps."""
    half = divergence / 2
    return ((bisector - half) % 360, ratio * turn), ((bisector + half) % 360, turn)


def candidates(divergence, ratio, bisector):
    """Crests across the sum and the difference of both winds, the best first, and which of them may win."""
    strong, weak = (
        steps * np.array(downwind(direction)) for direction, steps in winds(divergence, ratio, bisector)
    )
    vectors = sorted((strong + weak, strong - weak), key=np.linalg.norm, reverse=True)
    best, other = (float(np.linalg.norm(vector)) for vector in vectors)
    azimuths = [(bearing(*vector) + 90.0) % 180.0 for vector in vectors]
    return azimuths, azimuths if other > (1.0 - TIE) * best else azimuths[:1]


def told(divergence, ratio):
    """Whether the candidates lie far enough apart to be told from each other."""
    azimuths, _ = candidates(divergence, ratio, 270.0)
    return abs(difference(*azimuths)) >= LEAST_APART


VARIANTS = {model: Variant(model, model, DEFAULT) for model in ("werner", "momiji")}
PROBES = {
    "without speedup": (NO_SPEEDUP, TURN, ((60, 4), (105, 4), (120, 4), (135, 2))),
    "with the linear part of the speedup alone": ({"speedup_quadratic": 0.0}, TURN, ((120, 4),)),
    "with hops by the height at the start": ({"hop_from": "start"}, TURN, ((120, 4),)),
    "with turns of 1 step": ({}, 1, ((60, 4), (120, 4))),
    "with turns of 20 steps": ({}, 20, ((60, 4), (120, 4))),
}
"""Changes of Momiji's model, or of the turns, in some cases with the bisector along an axis."""
PROBED = (1, 2, 3)

FLUX_UP = (1.6, 0.0, -0.2, -0.4, -0.5, -0.6)
"""Flux-up ratios γ: that of Courrech du Pont et al. (2014), none (Rubin & Hunter 1987), and some below."""

CASES = [(d, n) for n in RATIOS for d in DIVERGENCES if told(d, n)]


def error(azimuth, divergence, ratio, bisector):
    """From the winning candidate (of equally good ones the nearer) to a crest (degrees, clockwise)."""
    _, winners = candidates(divergence, ratio, bisector)
    return nearest(azimuth, winners)


def nearest(azimuth, crests):
    """From the nearest of some expected crests to one that grew (degrees, clockwise)."""
    return min((difference(azimuth, crest) for crest in crests), key=abs)


def grown(variants, bisectors, seeds):
    """Measures of all runs of some variants, by variant, pair of winds and bisector."""
    return {
        (name, *case, bisector): [measured(Case(variant, winds(*case, bisector), seed)) for seed in seeds]
        for name, variant in variants.items()
        for bisector in bisectors
        for case in CASES
    }


def rows_of(found, variants, bisectors, cases=tuple(CASES)):
    """Errors case by case, with the bisector off the axes and along one, then over all cases."""
    for name in variants:
        for case in cases:
            yield _row(name, case, found, bisectors)
    for name in variants:
        for ratio in RATIOS:
            yield _summary(f"{name}, {ratio}:1", {k: v for k, v in found.items() if k[:3:2] == (name, ratio)})
        yield _summary(f"**{name}**", {k: v for k, v in found.items() if k[0] == name})


def rows():
    found = grown(VARIANTS, BISECTORS, SEEDS)
    draw(found).savefig(FIGURE)
    yield from rows_of(found, VARIANTS, BISECTORS)
    for model in VARIANTS:
        for flux_up in FLUX_UP:
            yield _flux_up_row(
                model, flux_up, {key: value for key, value in found.items() if key[0] == model}
            )
    for name, (changes, turn, cases) in PROBES.items():
        variant = Variant(name, "momiji", {**DEFAULT, **changes})
        for case in cases:
            blown = winds(*case, 270.0, turn)
            yield _probe(
                name,
                case,
                [measured(Case(variant, blown, seed)) for seed in PROBED],
                found["momiji", *case, 270.0],
            )


def _flux_up_row(model, flux_up, found):
    """Errors from the theory with a flux-up ratio (Courrech du Pont et al. 2014), by case."""
    by_case = {}
    for (_, divergence, ratio, bisector), results in found.items():
        if divergence == 90:
            continue
        directions, steps = zip(*winds(divergence, ratio, bisector), strict=True)
        best = gross_transport(Drift(np.array(directions), np.array(steps, float)), flux_up)
        values = [nearest(result["azimuth"], (best.azimuth, *best.rivals)) for result in results]
        by_case.setdefault((divergence, ratio), []).extend(values)
    means = [np.mean(values) for values in by_case.values()]
    return Row(
        f"{model}, theory with a flux-up ratio of {flux_up:g}",
        "0°",
        f"of the cases' means but at 90° {np.mean(np.abs(means)):.1f}°, "
        f"the worst {max(means, key=abs):+.1f}°",
        "",
    )


def _probe(name, case, results, before):
    """Errors after a change, and the mean without it over the same seeds."""
    mean, was = (
        np.mean([error(result["azimuth"], *case, 270.0) for result in some])
        for some in (results, before[: len(results)])
    )
    return Row(
        f"momiji {name}, {case[1]}:1, {case[0]}° apart",
        _theory(*case),
        f"along an axis: {_errors(results, *case, 270.0)}; mean {mean:+.1f}°",
        f"as it is {was:+.1f}°",
    )


def _theory(divergence, ratio):
    azimuths, winners = candidates(divergence, ratio, 270.0)
    joined = " or " if len(winners) > 1 else ", not "
    return joined.join(f"{azimuth:.0f}°" for azimuth in azimuths)


def _errors(results, divergence, ratio, bisector):
    return ", ".join(
        f"{value:+.0f}°" if result["coherence"] >= LEAST_COHERENCE else f"({value:+.0f}°)"
        for result in results
        for value in [error(result["azimuth"], divergence, ratio, bisector)]
    )


def _row(name, case, found, bisectors):
    oblique, straight = bisectors
    off, along = (found[name, *case, bisector] for bisector in bisectors)
    coherence = np.mean([result["coherence"] for result in (*off, *along)])
    return Row(
        f"{name}, {case[1]}:1, {case[0]}° apart",
        _theory(*case),
        f"along an axis: {_errors(along, *case, straight)}; coherence {coherence:.2f}",
        f"off the axes: {_errors(off, *case, oblique)}",
    )


def _summary(name, found):
    """Errors over all runs whose crests have a direction."""
    known = {
        key: [
            error(result["azimuth"], *key[1:]) for result in results if result["coherence"] >= LEAST_COHERENCE
        ]
        for key, results in found.items()
    }
    every = np.array([value for values in known.values() for value in values])
    runs = sum(map(len, found.values()))
    cases = {key[1:3] for key in known if key[1] != 90}
    means = [
        np.mean([value for key, values in known.items() if key[1:3] == case for value in values])
        for case in cases
    ]
    return Row(
        name,
        "0°",
        f"mean size of errors {np.abs(every).mean():.1f}°, median {np.median(every):+.1f}°, "
        f"the worst {max(every, key=abs):+.0f}°; of the cases' means but at 90° {np.abs(means).mean():.1f}°, "
        f"the worst {max(means, key=abs):+.1f}°",
        f"{np.sum(np.abs(every) <= 10)} of {len(every)} within 10°, {runs - len(every)} without direction",
    )


def draw(found):
    """Errors over divergence: a panel a model and ratio, a mark a run."""
    figure = new_figure(10.0, 5.2)
    panels = figure.subplots(len(VARIANTS), len(RATIOS), sharex=True, sharey=True, squeeze=False)
    for row, model in zip(panels, VARIANTS, strict=True):
        for axes, ratio in zip(row, RATIOS, strict=True):
            for bisector, mark, colour in zip(BISECTORS, "^o", ("#b5651d", "#35507a"), strict=True):
                shown = [
                    (d, error(result["azimuth"], d, ratio, bisector))
                    for d, n in CASES
                    if n == ratio
                    for result in found[model, d, n, bisector]
                    if result["coherence"] >= LEAST_COHERENCE
                ]
                shift = 1.5 if mark == "o" else -1.5
                label = "off the axes" if mark == "^" else "along an axis"
                axes.plot(
                    [d + shift for d, _ in shown],
                    [value for _, value in shown],
                    mark,
                    color=colour,
                    markersize=4,
                    alpha=0.7,
                    label=f"bisector {label}",
                )
            axes.axhspan(-5, 5, color="#35507a", alpha=0.08)
            axes.set_title(f"{model.capitalize()}, {ratio}:1", loc="left", fontsize=10)
            axes.set_xticks(DIVERGENCES)
            axes.grid(alpha=0.3)
    for axes in panels[-1]:
        axes.set_xlabel("divergence of the winds (degrees)", fontsize=9)
    for axes in panels[:, 0]:
        axes.set_ylabel("crests' error (degrees)", fontsize=9)
        axes.set_ylim(-45, 45)
    panels[0, 0].legend(fontsize=7, loc="lower left")
    return figure


READING = """
![Errors of crests under pairs of winds, over their divergence](_static/directions-pairs.png)

Crests take the candidate that theory prefers in every case, on either side of 90°, whether the bisector
lies along an axis or not; at 90° the candidates are equally good, and crests of Werner's model often lie
between both. But for that, the cases' means of Werner's model are off by 1.9° in the mean and by 4.1° at
most. So are those of Momiji's model under equal winds (1.4 and 2.2°). Under unequal winds its crests lie as
if the weaker wind had a greater share: 5 to 8° to one side below 90°, 9 to 17° to the other above it, with
every seed and along the lattice as well as off it. Its speedup does that: without it the same cases are off
by 5, -3, -3 and 0°. The lattice does not, nor do the turns: where the weaker wind blows for 1, 5 and 20
steps at a time the error under 4:1, 120° apart, is -17, -14 and -9° (three seeds). With the linear part of
the speedup alone it is -15°, with hops by the height at the start -16°. How it does that is seen by the
theory of Courrech du Pont et al. (2014), in which the flux over a crest is 1 + γ |sin| times that over a
flat bed: positive γ would turn crests to the stronger wind and makes the errors larger. With γ = -0.5 the
means of Momiji's cases are off by 3.4° instead of 7.5°, with γ = -0.2 those of Werner's by 1.4° instead of
1.9°: in the model a wind builds crests the less for its sand, the more squarely it blows across them, for
slabs that come to high ground hop on. γ is fitted here, one number to all cases of a model.
"""
