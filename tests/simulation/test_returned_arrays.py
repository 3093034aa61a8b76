"""Arrays that a model returns are checked before compiled code reads them."""

import numpy as np
import pytest

import barchan
from barchan.errors import BarchanError, FieldError
from barchan.models.werner import Werner
from barchan.simulation import Simulation
from tests.tiny import COLUMNS, ROWS, tiny


def one_nan():
    field = np.ones((ROWS, COLUMNS))
    field[2, 5] = np.nan
    return field


@pytest.mark.parametrize(
    ("returned", "said"),
    [
        (np.ones((COLUMNS, ROWS)), r"mobility of .* has shape \(24, 16\), the lattice \(16, 24\)"),
        (np.ones(ROWS * COLUMNS), r"has shape \(384,\)"),
        (one_nan(), r"is nan at row 2, column 5; allowed: finite numbers"),
        (np.full((ROWS, COLUMNS), np.inf), r"is inf at row 0, column 0 and 383 more cells"),
        (np.full((ROWS, COLUMNS), "1"), r"is of type <U1; allowed: numbers"),
    ],
)
def test_a_mobility_that_is_no_field_is_refused(monkeypatch, returned, said):
    monkeypatch.setattr(Werner, "mobility", lambda *_: returned)
    simulation = Simulation(tiny())
    with pytest.raises(FieldError, match=said):
        simulation.advance()


def test_a_hop_length_that_is_no_number_is_refused(monkeypatch):
    monkeypatch.setattr(Werner, "hop_length", lambda *_: float("nan"))
    simulation = Simulation(tiny())
    with pytest.raises(BarchanError, match=r"hop length of .* is nan"):
        simulation.advance()


@pytest.mark.parametrize(
    ("broken", "said"),
    [
        (lambda sand: sand.astype(np.float64), "sand is of type float64, declared int32"),
        (lambda sand: sand[:-1], r"sand has shape \(15, 24\)"),
        (lambda sand: sand - 100, r"sand is -\d+ slabs; allowed: none or more"),
    ],
)
def test_a_model_that_leaves_the_bed_out_of_shape_is_refused(monkeypatch, broken, said):
    whole = Werner.advance

    def advance(self, bed, segment, stream):
        tally = whole(self, bed, segment, stream)
        bed.arrays["sand"] = broken(bed.sand)
        return tally

    monkeypatch.setattr(Werner, "advance", advance)
    simulation = Simulation(tiny())
    with pytest.raises(FieldError, match=said):
        simulation.advance()


def test_a_layer_of_parts_of_slabs_is_refused():
    simulation = Simulation(barchan.load("barchans", rows=8, columns=8))
    with pytest.raises(FieldError, match=r"sand is 0.5 at row 0, column 0 and 63 more cells; allowed: whole"):
        simulation.bed.add(simulation.bed.layers[0], np.full((8, 8), 0.5))
