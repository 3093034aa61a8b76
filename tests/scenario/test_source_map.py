"""Every key and item of a JSON text is known by its line, and nothing in it is accepted in silence."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.scenario.source_map import dotted, parse, path_of

texts = st.text(max_size=6) | st.sampled_from(['"', "{", "]", ":", ",", "\\", 'a": 1', "\n"])
leaves = st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | texts
values = st.recursive(
    leaves,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(texts, inner, max_size=4),
    max_leaves=20,
)
gaps = st.lists(st.sampled_from(["", " ", "\n", "\n\n", "\t", " \n "]), min_size=1, max_size=7)


class Writer:
    """Writes JSON with gaps between all its tokens, and notes the line of every key and item."""

    def __init__(self, gaps_):
        self.gaps = gaps_
        self.text = ""
        self.tokens = 0
        self.lines = {}

    def put(self, token):
        self.text += token + self.gaps[self.tokens % len(self.gaps)]
        self.tokens += 1

    def write(self, value, path=()):
        if isinstance(value, dict):
            self.put("{")
            for number, (key, inner) in enumerate(value.items()):
                self.put(",") if number else None
                self.lines[(*path, key)] = self.text.count("\n") + 1
                self.put(json.dumps(key))
                self.put(":")
                self.write(inner, (*path, key))
            self.put("}")
        elif isinstance(value, list):
            self.put("[")
            for number, inner in enumerate(value):
                self.put(",") if number else None
                self.lines[(*path, number)] = self.text.count("\n") + 1
                self.write(inner, (*path, number))
            self.put("]")
        else:
            self.put(json.dumps(value))


@given(values, gaps)
def test_every_key_and_every_item_is_known_by_its_line(value, gaps_):
    writer = Writer(gaps_)
    writer.write(value)
    data, lines, problems = parse(writer.text, "file")
    assert data == value
    assert lines == writer.lines
    assert problems == []


def test_items_of_lists_within_lists_have_lines_of_their_own():
    text = '{\n"a": [\n[1,\n2],\n{"b":\n[3\n]}\n]\n}'
    assert parse(text, "file")[1] == {
        ("a",): 2,
        ("a", 0): 3,
        ("a", 0, 0): 3,
        ("a", 0, 1): 4,
        ("a", 1): 5,
        ("a", 1, "b"): 5,
        ("a", 1, "b", 0): 6,
    }


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('{"a": 1,\n "a": 2}', ["a: given twice (file:2)"]),
        ('{"g": {\n"a": 1,\n"b": 2,\n"a": 3}}', ["g.a: given twice (file:4)"]),
        ('[{"a": 1}, {"a": 1}]', []),
        ('[{"a": 1,\n"a": 1}]', ["[0].a: given twice (file:2)"]),
        ('{"a": 1, "\\u0061": 2}', ["a: given twice (file:1)"]),
    ],
)
def test_a_key_that_is_given_twice_in_one_object_is_reported_at_its_second_place(text, said):
    assert [str(problem) for problem in parse(text, "file")[2]] == said


@pytest.mark.parametrize(
    ("text", "place"),
    [('{"a" 1}', "file:1:6"), ('{\n"a": 1,\n}', "file:3:1"), ("", "file:1:1"), ("{", "file:1:2")],
)
def test_text_that_is_not_json_is_reported_where_it_goes_wrong(text, place):
    data, _, (problem,) = parse(text, "file")
    assert data is None
    assert problem.place == place
    assert problem.message.startswith("not valid JSON")


@pytest.mark.parametrize("constant", ["NaN", "Infinity", "-Infinity"])
def test_numbers_that_are_none_are_refused(constant):
    data, _, (problem,) = parse(f'{{"a": 1,\n"b": {constant}}}', "file")
    assert data is None
    assert f"{constant} is not a number" in problem.message


def test_numbers_that_are_none_are_reported_with_their_line():
    _, _, (problem,) = parse('{"a": 1,\n"b": NaN}', "file")
    assert problem.place.startswith("file:2")


def test_a_path_is_written_as_users_write_it():
    assert dotted(("sand", "parts", 0, "mean")) == "sand.parts[0].mean"
    assert dotted(()) == ""


PATHS = st.lists(st.one_of(st.sampled_from(["sand", "parts", "mean"]), st.integers(0, 99)), min_size=1)


@given(PATHS.filter(lambda path: isinstance(path[0], str)))
def test_a_path_that_was_written_out_is_read_back(path):
    assert path_of(dotted(tuple(path))) == tuple(path)
