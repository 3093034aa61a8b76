"""``barchan curves``: the curves among a scenario's parameters."""

import pytest
from PIL import Image


@pytest.mark.parametrize(
    "words", [[], ["--out", "growth.png"], ["--model.stabilised-cover", "0.4"]], ids=" ".join
)
def test_the_growth_of_plants_is_drawn_and_told(here, barchan, words):
    result = barchan("curves", "nebkhas", *words)
    name = "growth.png" if "--out" in words else "curves.png"
    assert (result.code, result.out, result.err) == (0, f"{name}\n", "")
    with Image.open(here / name) as picture:
        assert min(picture.size) > 300


def test_the_curves_of_a_run_are_drawn(here, barchan):
    words = ["--lattice.rows", "16", "--lattice.columns", "24", "--run.steps", "0", "--quiet", "--no-picture"]
    assert barchan("run", "nebkhas", *words, "--out", "plants").code == 0
    assert barchan("curves", "plants").code == 0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["tiny.json"], "tiny.json: its model, werner, has no curves"),
        (["nowhere.json"], "nowhere.json"),
        (["nebkhas", "--out", "curves.txt"], "cannot write curves.txt"),
        (["nebkhas", "--uot", "x.png"], "did you mean '--out'"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_what_cannot_be_drawn_is_a_clear_error(here, barchan, words, said):
    result = barchan("curves", *words)
    assert (result.code, result.out) == (1, "")
    assert said in result.err
    assert "Traceback" not in result.err
