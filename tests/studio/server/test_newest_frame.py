"""Frames for browsers that missed some: put together by hand from three frames of two by two cells."""

import numpy as np

from barchan.studio.protocol import EncodedField, frame
from barchan.studio.server.newest_frame import NewestFrame
from tests.studio.frames import read_frame

GROUND = np.zeros((2, 2), np.float32)


def row(step: int) -> dict:
    return {"step": step, "values": {"crests": step / 10}, "doubts": {}}


def a_frame(step: int, *fields: EncodedField, shown=(), **parts) -> bytes:
    depth = EncodedField("depth", np.full((2, 2), step, np.uint8), 0.5)
    head = {"run": "a", "rows": 2, "columns": 2, "shown": list(shown), "status": {"step": step}}
    return frame({**head, **parts}, [depth, *fields])


def taken() -> NewestFrame:
    """A frame with ground, slope, history and a row; one with another row; one that shows no slope."""
    newest = NewestFrame()
    ground, slope = EncodedField("ground", GROUND), EncodedField("slope", GROUND + 7)
    first = {"history": [0], "measures": [row(0)], "measures_replaced": True, "paths": [[1.0, 2.0, 3.0]]}
    newest.take(a_frame(1, ground, slope, shown=["slope"], **first))
    newest.take(a_frame(2, shown=["slope"], measures=[row(20)]))
    newest.take(a_frame(3, shown=[]))
    return newest


def test_a_browser_that_has_all_but_the_newest_frame_gets_that_as_it_is():
    assert taken().since(2) == a_frame(3)


def test_a_browser_without_any_frame_gets_all_that_was_shown_and_is_still_wanted():
    header, fields = read_frame(taken().since(0))
    assert header["status"] == {"step": 3}
    assert (header["history"], header["paths"]) == ([0], [[1.0, 2.0, 3.0]])
    assert (header["measures"], header["measures_replaced"]) == ([row(0), row(20)], True)
    assert sorted(fields) == ["depth", "ground"]
    assert np.array_equal(fields["depth"], np.full(4, 1.5))


def test_a_browser_that_missed_a_frame_gets_only_what_came_since():
    header, fields = read_frame(taken().since(1))
    assert header["measures"] == [row(20)]
    assert not {"measures_replaced", "history"} & header.keys()
    assert list(fields) == ["depth"]


def test_of_another_run_nothing_of_the_one_before_is_shown():
    newest = taken()
    depth, ground = (EncodedField(name, np.ones((3, 3), np.uint8)) for name in ("depth", "ground"))
    head = {"run": "a", "rows": 3, "columns": 3, "shown": ["slope"], "status": {"step": 0}}
    newest.take(frame({**head, "measures": [], "measures_replaced": True, "history": [0]}, [depth, ground]))
    newest.take(frame(head, [depth]))
    for number in (0, 3):
        header, fields = read_frame(newest.since(number))
        assert sorted(fields) == ["depth", "ground"]
        assert (header["measures"], header["measures_replaced"], "paths" in header) == ([], True, False)
