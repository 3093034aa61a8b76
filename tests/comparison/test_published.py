"""Published results set up again: every case can run, claims are judged by rules worked out by hand."""

import math

import pandas as pd
import pytest

from barchan.comparison.published import reproducing
from barchan.comparison.published.judging import judge, prediction
from barchan.comparison.published.reproducing import reproduce
from barchan.comparison.published.results import (
    Case,
    Claim,
    Experiment,
    PublishedSet,
    load_set,
    plan_of,
    set_names,
)
from barchan.comparison.variants import Variant
from barchan.ensembles.reports import Report
from barchan.ensembles.workers import Workers, given
from barchan.errors import BarchanError
from barchan.models import model_names
from tests.comparison.test_compare import Here

SMALL = {"lattice.rows": 24, "lattice.columns": 32, "run.steps": 10, "run.save_every": 5}


def variant(label: str, **finals: list[float]) -> Variant:
    """Finished runs of seeds 1, 2, … with measures of their last frames."""
    reports = {}
    for number in range(len(next(iter(finals.values())))):
        series = {"step": [98], **{name: [values[number]] for name, values in finals.items()}}
        reports[number + 1] = Report("x", "all steps done", 98, 1.0, 1.0, "", series=series)
    return Variant(label, 0, None, [], reports)


@pytest.mark.parametrize("name", set_names())
def test_every_claim_is_about_a_case_of_its_experiment_and_every_case_is_run_for_one(name):
    chosen = load_set(name)
    used = set()
    for experiment in chosen.experiments:
        used |= set(experiment.cases)
        for claim in experiment.claims:
            assert {claim.case, claim.than_case} - {""} <= set(experiment.cases), (experiment.name, claim)
    assert used == set(chosen.cases)


def test_the_set_of_the_thesis_has_every_model_that_the_thesis_compares():
    plan = plan_of(load_set("thesis"), seeds=2)
    models = {member.scenario["model"]["name"] for member in plan.members}
    assert (
        models == {"werner", "momiji", "bishop", "nield_baas", "wang_hu", "snow_werner"} <= set(model_names())
    )
    assert (
        len({member.id for member in plan.members}) == len(plan.members) == 2 * len(load_set("thesis").cases)
    )


def test_one_more_run_lies_in_the_interval_of_student():
    """1, 2, 3: mean 2, deviation 1, t(0.975, 2) = 4.3027, times the root of 4/3."""
    low, high = prediction([1.0, 2.0, 3.0])
    assert (low, high) == pytest.approx(
        (2 - 4.3027 * math.sqrt(4 / 3), 2 + 4.3027 * math.sqrt(4 / 3)), rel=1e-4
    )
    assert prediction([1.0]) == (-math.inf, math.inf)


@pytest.mark.parametrize(
    ("claim", "result"),
    [
        (Claim("a", "a", "highest", value=6.9), "agrees"),
        (Claim("a", "a", "highest", value=7.4), "agrees"),
        (Claim("a", "a", "highest", value=7.6), "differs"),
        (Claim("a", "a", "highest", value=7.6, rounding=0.5), "agrees"),
        (Claim("a", "b", "highest", value=14.5), "agrees"),
        (Claim("a", "b", "highest", value=17.1), "differs"),
        (Claim("a", "b", "highest", than_case="a"), "agrees"),
        (Claim("a", "a", "highest", than_case="b"), "differs"),
        (Claim("a", "a", "highest", than_measure="uneven"), "undecided"),
        (Claim("a", "b", "highest", than_case="a", within=12.0), "agrees"),
        (Claim("a", "b", "highest", than_case="a", within=5.0), "differs"),
        (Claim("a", "a", step=98), "agrees"),
        (Claim("a", "a", step=99), "differs"),
        (Claim("a", "none", "highest", value=2.0), "undecided"),
        (Claim("a"), "for the eye"),
    ],
)
def test_claims_are_judged_over_seeds(claim, result):
    """a: 1, 2, 3, one more run up to 6.97, and half a slab; b: ten higher, but for a hundredth."""
    cases = {
        "a": variant("a", highest=[1.0, 2.0, 3.0], uneven=[9.0, -9.0, 3.0]),
        "b": variant("b", highest=[11.0, 12.01, 13.0]),
    }
    assert judge(claim, cases).result == result


def test_two_runs_of_as_many_slabs_do_not_foretell_the_next_to_the_slab():
    cases = {"a": variant("a", highest=[22.0, 22.0])}
    assert judge(Claim("a", "a", "highest", value=23.0, rounding=0.5), cases).result == "agrees"
    assert judge(Claim("a", "a", "highest", value=24.0, rounding=0.5), cases).result == "differs"


def test_a_set_is_run_again_and_its_report_says_what_agrees(tmp_path, monkeypatch):
    monkeypatch.setattr(reproducing, "processes", lambda: Workers(Here, 1, "here"))
    claims = [
        Claim("at least as flat", "low", "highest_stack", value=-5.0),
        Claim("a plain", "low", forms=["flat"]),
        Claim("look"),
    ]
    cases = {"low": Case("barchans", SMALL), "thick": Case("barchans", {**SMALL, "sand.mean": 9})}
    both = [
        Experiment("one", "Fig. 1", "One", "A <plain>.", ["low"], claims),
        Experiment("two", "Fig. 2", "Two", "Another.", ["low", "thick"], [], brief=True),
    ]
    chosen = PublishedSet("mine", "Mine", "somewhere", cases, both)
    done = reproduce(chosen, tmp_path, seeds=2, workers=given(Here(), 1), command="barchan compare")
    text = done.report.read_text("utf-8")
    assert "Of 3 statements" in text
    assert "1 are for the eye" in text
    assert "A &lt;plain&gt;." in text
    assert text.count("<img") == 1 + 4 + 1
    assert list(pd.read_csv(tmp_path / "claims.csv")["verdict"])[::2] == ["differs", "for the eye"]
    assert len(list((tmp_path / "scenarios").iterdir())) == 2


def test_an_unknown_set_is_named():
    with pytest.raises(
        BarchanError, match=r"--preset-set theses: no such set; allowed: thesis.*did you mean 'thesis'"
    ):
        load_set("theses")
