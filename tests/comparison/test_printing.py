"""Reports on paper, as a browser prints them: nothing is wider than a page, pictures can be read."""

import re

import pytest

from barchan.comparison.published.reproducing import reproduce
from barchan.comparison.published.results import Case, Claim, Experiment, PublishedSet
from barchan.ensembles.workers import given
from tests.comparison.test_compare import Here
from tests.studio.browser.conftest import chromium  # noqa: F401

SMALL = {"lattice.rows": 24, "lattice.columns": 32, "run.steps": 10, "run.save_every": 5}
PAPER = 688
"""Pixels between the margins of A4: 182 mm at 96 dots per inch."""

WIDER = f"""[...document.querySelectorAll("table, img, pre, h2, p")]
    .filter((one) => one.getBoundingClientRect().right > {PAPER} + 1)
    .map((one) => one.tagName + ": " + one.textContent.slice(0, 60))"""
LOWEST = "Math.min(...[...document.querySelectorAll('img')].map((one) => one.getBoundingClientRect().height))"


@pytest.mark.extended
def test_a_report_of_published_results_fits_its_pages(chromium, tmp_path):  # noqa: F811
    """Two sections of five pictures, and a brief one of seven rows of maps."""
    claims = [Claim("higher than a plain, as a source has it", "0", "highest_stack", value=9)]
    cases = {str(k): Case("barchans", {**SMALL, "sand.mean": 3 + k}) for k in range(7)}
    chosen = PublishedSet(
        "mine",
        "Mine",
        "somewhere",
        cases,
        [
            Experiment("one", "Fig. 1", "One", "A plain. " * 12, ["0"], claims),
            Experiment("two", "Fig. 2", "Two", "Another.", ["1"], []),
            Experiment("all", "Fig. 3", "All", "All of them.", list(cases), [], brief=True),
        ],
    )
    report = reproduce(chosen, tmp_path, seeds=2, workers=given(Here(), 1), command="barchan compare").report
    page = chromium.new_page(viewport={"width": PAPER, "height": 1000})
    page.goto(report.as_uri())
    page.emulate_media(media="print")
    assert page.evaluate(WIDER) == []
    assert page.evaluate(LOWEST) > 60
    strip = page.locator("section#all img")
    assert strip.bounding_box()["height"] > 500  # seven rows of maps, as high as half a page
    printed = page.pdf(prefer_css_page_size=True)
    page.close()
    assert printed.startswith(b"%PDF")
    assert len(re.findall(rb"/Type\s*/Page\b", printed)) <= 6
