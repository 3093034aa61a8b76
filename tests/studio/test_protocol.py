import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.studio.protocol import EncodedField, frame, is_frame, message
from tests.studio.frames import read_frame


@given(st.integers(1, 7), st.integers(1, 7), st.sampled_from(["uint8", "uint16", "int32", "float32"]))
def test_a_frame_read_is_the_frame_written(rows, columns, dtype):
    numbers = np.arange(rows * columns, dtype=dtype).reshape(rows, columns)
    encoded = [
        EncodedField("depth", numbers, 0.25, -1.0),
        EncodedField("shadow", (numbers % 2).astype(np.uint8)),
    ]
    data = frame({"rows": rows, "columns": columns, "title": "Dünen"}, encoded)
    header, fields = read_frame(data)
    assert is_frame(data)
    assert header["title"] == "Dünen"
    assert np.allclose(fields["depth"], 0.25 * numbers.ravel() - 1.0)
    assert np.array_equal(fields["shadow"], numbers.ravel() % 2)


def test_fields_begin_at_multiples_of_four_bytes_as_browsers_need():
    numbers = np.ones((3, 3), np.uint8)
    for title in ("a", "ab", "abc", "abcd"):
        data = frame(
            {"rows": 3, "columns": 3, "title": title},
            [EncodedField("x", numbers), EncodedField("y", numbers)],
        )
        length = int.from_bytes(data[4:8], "little")
        assert (len(data) - (8 + length + -length % 4)) == 2 * 12


def test_control_messages_hold_no_numbers_that_json_has_not():
    assert not is_frame(message("hello"))
    with pytest.raises(ValueError, match="not JSON compliant"):
        message("scenario", value=float("nan"))


def test_messages_are_of_the_types_that_the_client_knows():
    with pytest.raises(KeyError):
        message("nonsense")
