"""Arrays lent to kernels: not counted, not kept, and given back as they were."""

import ast
import gc
import sys
import weakref
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numba import njit

from barchan import kernels
from barchan.kernels.core.borrow import borrowed


class Pair(NamedTuple):
    """Two arrays, one of which may be missing, and a number."""

    left: np.ndarray
    right: np.ndarray | None
    step: float


@njit
def add(values, at, step):
    """Add to a value, where there are any."""
    if values is not None:
        values[at] += step


@njit
def turn(pair, at):
    """Change one or the other, on ways that leave in several places."""
    if pair.left[at] > 0.0:
        pair.left[at] = -pair.left[at]
        return
    add(pair.right, at, pair.step)


@njit
def turn_all(pair, nested):
    """Change all."""
    pair, nested = borrowed((pair, nested))
    for at in range(pair.left.size):
        turn(pair, at)
        nested[0][0][at] += nested[1]


def test_lent_arrays_live_as_long_as_python_holds_them():
    left, right, inner = np.array([1.0, -1.0]), np.array([1.0, 1.0]), np.zeros(2)
    held = [sys.getrefcount(one) for one in (left, right, inner)]
    for _ in range(3):
        turn_all(Pair(left, right, 0.5), ((inner,), 2.0))
    assert [sys.getrefcount(one) for one in (left, right, inner)] == held
    assert (left.tolist(), right.tolist(), inner.tolist()) == ([-1.0, -1.0], [2.0, 2.5], [6.0, 6.0])
    watched = weakref.ref(left)
    del left
    gc.collect()
    assert watched() is None


def test_what_is_missing_stays_missing():
    left, inner = np.array([1.0, -1.0]), np.zeros(2)
    turn_all(Pair(left, None, 0.5), ((inner,), 1.0))
    assert (left.tolist(), inner.tolist()) == ([-1.0, -1.0], [1.0, 1.0])


def loans():
    """Every function of the kernels that borrows: where it stands, its arguments, and what it borrows."""
    for path in sorted(Path(kernels.__file__).parent.rglob("*.py")):
        for function in ast.walk(ast.parse(path.read_text("utf-8"))):
            if not isinstance(function, ast.FunctionDef):
                continue
            arguments = {argument.arg for argument in function.args.args}
            for call in ast.walk(function):
                if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "borrowed":
                    yield f"{path.name}: {function.name}", arguments, call.args[0]


def test_kernels_borrow_nothing_but_their_arguments():
    """The memory of an array that a kernel makes and borrows at once is free while it is used."""
    found = list(loans())
    assert found
    for where, arguments, lent in found:
        parts = lent.elts if isinstance(lent, ast.Tuple) else [lent]
        assert {ast.unparse(part) for part in parts} <= arguments, where
