"""``barchan sweep`` and ``barchan compare`` on the command line."""

import csv

import pytest

from barchan.cli import ensembles
from barchan.ensembles.workers import given
from tests.ensembles.test_ensembles import Here


@pytest.fixture(autouse=True)
def in_this_process(monkeypatch):
    """Members run in this process, for speed."""
    monkeypatch.setattr(ensembles, "workers_of", lambda *_: given(Here(), 1))


def test_a_sweep_writes_its_table_its_small_maps_and_a_diagram_and_goes_on(here, barchan):
    words = ("--vary", "model.hop_length=1,3", "--vary", "sand.mean=2,4", "--run.save_every", 10)
    done = barchan("sweep", "tiny.json", *words, "--out", "hops", "--measure", "bare_fraction")
    assert done.code == 0, done.err
    assert "4 points, 4 runs" in done.out
    with (here / "hops" / "measures.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [(row["hop_length"], row["mean"]) for row in rows] == [
        ("1", "2"),
        ("1", "4"),
        ("3", "2"),
        ("3", "4"),
    ]
    for name in ("small-multiples.png", "bare_fraction.png"):
        assert (here / "hops" / name).stat().st_size > 1000
    again = barchan("sweep", "hops")
    assert again.code == 0
    assert "of 4 runs" not in again.out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--vary", "model.hop_length=-1,0"], ["is -1", "is 0"]),
        (["--vary", "model.hop=1,2"], ["model.hop", "did you mean"]),
        (["--vary", "sand.mean=1,2", "--measure", "spacin"], ["--measure spacin", "did you mean 'spacing'"]),
        (["--measure", "spacing"], ["1 or 2 varied keys"]),
        (["--seeds", "0"], ["--seeds 0: allowed: 1 or more"]),
        (["--design", "latin", "--vary", "sand.mean=lin(1,5)"], ["--points"]),
    ],
)
def test_a_sweep_that_cannot_be_run_says_why_and_leaves_nothing(here, barchan, words, said):
    done = barchan("sweep", "tiny.json", *words, "--out", "no")
    assert done.code == 1
    assert all(part in done.err for part in said), done.err
    assert not (here / "no").exists()


def test_a_sweep_with_failures_lists_them_and_how_to_try_again(here, barchan):
    values = f'{{"kind": "file", "path": "{here}/none.asc"}},{{"kind": "flat"}}'
    done = barchan("sweep", "tiny.json", "--vary", f"ground={values}", "--out", "half")
    assert done.code == 1
    assert "failed: 1; try again with: barchan sweep half --only failed" in done.out
    assert "none.asc" in done.out
    assert barchan("sweep", "half", "--only", "waiting").code == 0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--models", "werner,momji"], "did you mean 'momiji'?"),
        (["--models", "werner,momiji", "--seeds", "0"], "--seeds 0"),
        (["--models", "werner,momiji", "--step", "7"], "--step 7: is not saved; allowed: multiples of 5"),
        (["--models", "werner,momiji", "--vary", "model.hop_length=0"], "is 0; allowed"),
        (["--preset-set", "thesis"], "--preset-set is stated with a scenario; a set states its own"),
    ],
)
def test_a_comparison_that_cannot_be_made_says_why(here, barchan, words, said):
    done = barchan("compare", "tiny.json", *words, "--out", "no")
    assert done.code == 1
    assert said in done.err
    assert not (here / "no").exists()
