"""``barchan check`` over terrain from a file: what it states, remarks on and asks."""

import numpy as np
import pytest


@pytest.fixture
def dem(tmp_path):
    def write(heights):
        head = "ncols 24\nnrows 16\nxllcorner 500000\nyllcorner 4000000\ncellsize 2\n"
        (tmp_path / "dem.asc").write_text(
            head + "\n".join(" ".join(f"{v:g}" for v in row) for row in heights)
        )
        return ["--ground.kind", "file", "--ground.path", str(tmp_path / "dem.asc")]

    return write


SLOPE = np.broadcast_to(0.1 * np.arange(24.0), (16, 24))


def test_check_states_what_was_read_and_remarks_on_edges_that_do_not_match(barchan, dem):
    """The slope drops by 23 steps of 0.1 m where its edges are joined."""
    result = barchan("check", "barchans", *dem(SLOPE), "--lattice", "from ground")
    said = " ".join(result.out.split())
    assert "terrain: 16 rows of 24 cells of 2 m; west edge 500000 m, south edge 4000000 m" in said
    assert "the west and east edges are joined, but the ground does not match there" in said
    assert "breaks off by up to 2.3 m" in said


def test_an_open_boundary_answers_the_remark(barchan, dem):
    more = ["--lattice.kind", "from ground", "--lattice.boundary-x", "open"]
    assert "does not match" not in barchan("check", "barchans", *dem(SLOPE), *more).out


def test_an_undeclared_code_is_answered_on_the_command_line(barchan, dem):
    holed = SLOPE.copy()
    holed[4, 5] = -9999
    command = ["check", "barchans", *dem(holed), "--lattice", "from ground"]
    refused = barchan(*command)
    assert refused.code == 1
    assert "state missing [-9999] if it is one" in " ".join(refused.err.split())
    answered = barchan(*command, "--ground.missing", "-9999", "--ground.fill", "interpolate")
    assert answered.code == 0
    assert "1 of 384 cells without a value, filled from those around them" in " ".join(answered.out.split())
