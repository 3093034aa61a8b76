"""Scenarios are read from presets, files and plain data; every mistake is reported, at once and in place."""

import json

import pytest

from barchan.errors import ScenarioError
from barchan.scenario import load_scenario, preset_names, validate
from tests.tiny import data, tiny

THREE_MISTAKES = """{
  "barchan": 5,
  "lattice": {
    "rows": 0
  },
  "sand": { "kind": "dropped", "parts": [
    { "mean": 1 },
    { "mean": 2,
      "noth": 0.5 }
  ] },
  "model": {
    "name": "werner",
    "repose_test": "befor"
  }
}
"""

TWO_MORE = [("run.steps", "many"), ("model.hop-lenght", "7")]


def problems(source, overrides=()):
    """What is wrong with a scenario, by key."""
    with pytest.raises(ScenarioError) as caught:
        load_scenario(source, overrides)
    found = {problem.key: problem for problem in caught.value.problems}
    assert len(found) == len(caught.value.problems)
    return found


@pytest.fixture
def file(tmp_path):
    def write(text):
        path = tmp_path / "dunes.json"
        path.write_text(text, "utf-8")
        return path

    return write


def test_three_mistakes_in_a_file_are_three_problems_each_with_its_line(file):
    path = file(THREE_MISTAKES)
    found = problems(path)
    assert {key: problem.place for key, problem in found.items()} == {
        "lattice.rows": f"{path}:4",
        "sand.parts[1].noth": f"{path}:9",
        "model.repose_test": f"{path}:13",
    }


def test_a_problem_tells_the_value_what_is_allowed_and_the_nearest_name(file):
    found = problems(file(THREE_MISTAKES))
    assert found["lattice.rows"].message == "is 0; allowed: whole number ≥ 1 and ≤ 65536"
    assert found["model.repose_test"].message == (
        "is 'befor'; did you mean 'before'?; allowed: 'before' | 'after'"
    )
    assert found["sand.parts[1].noth"].message == (
        "unknown key; did you mean 'north'?; known here: west, east, south, north, mean"
    )


def test_mistakes_on_the_command_line_are_reported_beside_those_in_the_file(file):
    found = problems(file(THREE_MISTAKES), TWO_MORE)
    assert len(found) == 5
    assert found["run.steps"].place == "command line"
    assert found["model.hop_lenght"].place == "command line"
    assert "did you mean 'hop_length'?" in found["model.hop_lenght"].message


def test_the_error_counts_its_problems_and_names_the_scenario(file):
    path = file(THREE_MISTAKES)
    with pytest.raises(ScenarioError) as caught:
        load_scenario(path)
    first, *rest = str(caught.value).splitlines()
    assert first == f"{path}: 3 problems"
    assert len(rest) == 3
    assert all(line.startswith("  ") for line in rest)


def test_a_mistake_in_plain_data_needs_no_place():
    given = data()
    given["run"]["steps"] = -1
    assert problems(given)["run.steps"].place == ""


@pytest.mark.parametrize(
    ("change", "key", "said"),
    [
        ({"model": {"name": "wernr"}}, "model.name", "is 'wernr'; did you mean 'werner'?"),
        (
            {"sand": {"kind": "droped"}},
            "sand.kind",
            "is 'droped'; did you mean 'dropped'?; allowed: flat, random, dropped, ",
        ),
        (
            {"wind": {"direction": 360}},
            "wind.direction",
            "is 360; allowed: number ≥ 0 and < 360",
        ),
        (
            {"model": {"name": "werner", "lee_erosion": 1}},
            "model.lee_erosion",
            "is 1; allowed: true or false",
        ),
        ({"model": {"name": "werner", "p_s": True}}, "model.p_s", "is true; allowed: number ≥ 0 and ≤ 1"),
        (
            {"model": {"name": "werner", "corner_limit": "fase"}},
            "model.corner_limit",
            "is 'fase'; did you mean 'face'?; allowed: 'face' | 'geometric' | whole number ≥ 1 and ≤ 1000000",
        ),
        (
            {"lattice": {"slab_aspect": 0.5, "slab_height": 1.0}},
            "lattice",
            "slab_aspect 0.5 and slab_height 1.0 m are both given; give one of them",
        ),
        (
            {"sand": {"kind": "flat", "parts": [{"west": 0.5}]}},
            "sand.parts[0].mean",
            "is missing; allowed: number ≥ 0 and ≤ 1000000",
        ),
        (
            {"run": {"until": {"steady": {"windw": 3}}}},
            "run.until.steady.windw",
            "unknown key; did you mean 'window'?; known here: window, tolerance",
        ),
        ({"latice": {}}, "latice", "unknown key; did you mean 'lattice'?; known here: barchan, title, "),
    ],
)
def test_a_mistake_is_told_in_the_words_of_the_scenario(change, key, said):
    found = problems({**data(), **change})
    assert list(found) == [key]
    assert found[key].message.startswith(said)


@pytest.mark.parametrize(
    "change",
    [{"lattice": 3}, {"sand": 3}, {"wind": "west"}, {"run": {"until": {"steady": True}}}],
    ids=["lattice", "sand", "wind", "steady"],
)
def test_a_value_in_the_place_of_a_group_is_reported_without_names_of_the_program(change):
    (problem,) = problems({**data(), **change}).values()
    for name in ("Lattice", "FlatSand", "Steady", "SteadyState", "Input should"):
        assert name not in problem.message


@pytest.mark.parametrize("value", [{}, {"of": 3}])
def test_a_group_in_the_place_of_a_value_is_reported_with_what_is_allowed(value):
    found = problems({**data(), "lattice": {"rows": value}})
    assert "allowed: whole number ≥ 1" in found["lattice.rows"].message


def test_a_title_that_is_too_long_is_told_how_long_it_may_be():
    assert "200" in problems({**data(), "title": "x" * 201})["title"].message


@pytest.mark.parametrize("note", [{"author": "me"}, [1, 2]])
def test_a_note_that_is_no_text_is_one_problem(note):
    assert list(problems({**data(), "note": note})) == ["note"]


def test_nothing_in_the_place_of_a_number_is_called_null():
    assert problems({**data(), "run": {"steps": None}})["run.steps"].message.startswith("is null")


@pytest.mark.parametrize("number", [float("nan"), float("inf"), -float("inf")])
@pytest.mark.parametrize("key", ["cell_size", "rows"])
def test_numbers_that_are_none_are_refused_in_plain_data(key, number):
    given = data()
    given["lattice"][key] = number
    assert f"lattice.{key}" in problems(given)


@pytest.mark.parametrize("text", ["NaN", "nan", "Infinity", "-Infinity", "1e999"])
def test_numbers_that_are_none_are_refused_on_the_command_line(text):
    assert problems(data(), [("lattice.cell_size", text)])["lattice.cell_size"].place == "command line"


def test_numbers_too_large_for_a_number_are_refused_in_a_file(file):
    path = file('{"barchan": 5,\n"lattice": {"cell_size": 1e999}}')
    assert problems(path)["lattice.cell_size"].place == f"{path}:2"


def test_a_key_given_twice_is_one_of_the_problems(file):
    path = file('{"barchan": 5,\n"run": {"steps": 5,\n"steps": -6}}')
    with pytest.raises(ScenarioError) as caught:
        load_scenario(path)
    assert [str(p) for p in caught.value.problems] == [
        f"run.steps: given twice ({path}:3)",
        f"run.steps: is -6; allowed: whole number ≥ 0 and ≤ 1000000000000 ({path}:3)",
    ]


def test_a_key_given_twice_is_refused_even_where_both_values_are_sound(file):
    path = file('{"barchan": 5, "title": "a",\n"title": "b"}')
    with pytest.raises(ScenarioError, match="title: given twice"):
        load_scenario(path)


@pytest.mark.parametrize("text", ["[]", "3", '"barchans"'])
def test_a_file_that_holds_no_object_is_refused(file, text):
    with pytest.raises(ScenarioError, match="must be a JSON object"):
        load_scenario(file(text))


def test_a_file_that_holds_null_is_refused_with_a_reason(file):
    with pytest.raises(ScenarioError, match="must be a JSON object"):
        load_scenario(file("null"))


def test_a_file_in_another_encoding_is_refused_with_a_reason(tmp_path):
    path = tmp_path / "latin.json"
    path.write_bytes('{"barchan": 5, "title": "Dünen"}'.encode("latin-1"))
    with pytest.raises(ScenarioError, match="cannot be read"):
        load_scenario(path)


def test_a_name_that_is_neither_preset_nor_file_is_reported_with_the_nearest_preset():
    with pytest.raises(ScenarioError, match=r"no preset and no file of this name; did you mean 'barchans'\?"):
        load_scenario("barchan")


@pytest.mark.parametrize(
    ("version", "said"),
    [
        (None, 'is missing: the format\'s version, "barchan": 5'),
        (6, "is 6, written by a newer Barchan; this one reads formats up to 5"),
        (0, "is 0; allowed: a format version from 1 to 5"),
        ("1", "is '1'; allowed: a format version from 1 to 5"),
    ],
)
def test_the_formats_version_is_asked_for_beside_other_mistakes(version, said):
    given = {**data(), "barchan": version, "latice": {}}
    if version is None:
        del given["barchan"]
    found = problems(given)
    assert set(found) == {"barchan", "latice"}
    assert found["barchan"].message == said


@pytest.mark.parametrize("name", preset_names())
def test_every_preset_is_sound_and_tells_what_it_is(name):
    scenario = load_scenario(name)
    assert scenario.title
    assert scenario.citation
    assert scenario.look_for


@pytest.mark.parametrize(
    ("key", "text", "value"),
    [
        ("model.hop-length", "7", 7.0),
        ("model.hop_length", "2.5", 2.5),
        ("model.polling", "non_repeated", "non_repeated"),
        ("model.corner-limit", "3", 3),
        ("model.corner-limit", "geometric", "geometric"),
        ("model.lee_erosion", "false", False),
        ("run.seed", "null", None),
        ("run.until.idle_steps", "4", 4),
        ("title", "A title", "A title"),
        ("title", "2024", "2024"),
        ("citation", "null", "null"),
    ],
)
def test_every_value_can_be_overridden_by_its_dotted_key(key, text, value):
    scenario = load_scenario(data(), [(key, text)])
    found = scenario.data()
    for step in key.replace("-", "_").split("."):
        found = found[step]
    assert found == value


def test_a_whole_group_can_be_overridden_by_its_json():
    scenario = load_scenario(data(), [("sand", '{"kind": "dropped", "mean": 0.5}')])
    assert (scenario.sand.kind, scenario.sand.mean) == ("dropped", 0.5)


def test_the_later_of_two_overrides_holds():
    assert load_scenario(data(), [("run.steps", "3"), ("run.steps", "4")]).run.steps == 4


@pytest.mark.parametrize(
    ("key", "text"),
    [("ground.level", "5"), ("sand.mean", "10"), ("model.hop_length", "7"), ("wind.speed", "7")],
)
def test_a_value_of_a_group_that_the_file_leaves_to_its_default_can_be_overridden(key, text):
    group, name = key.split(".")
    scenario = load_scenario({"barchan": 5}, [(key, text)])
    assert getattr(getattr(scenario, group), name) == float(text)


@pytest.mark.parametrize(
    ("given", "same"),
    [
        ({"sand": {"mean": 9}}, {"sand": {"kind": "flat", "mean": 9}}),
        ({"ground": {}}, {"ground": {"kind": "flat"}}),
        ({"model": {"p_s": 0.5}}, {"model": {"name": "werner", "p_s": 0.5}}),
    ],
)
def test_a_group_that_does_not_say_its_kind_is_of_the_kind_that_is_the_default(given, same):
    assert load_scenario({"barchan": 5, **given}) == load_scenario({"barchan": 5, **same})


@pytest.mark.parametrize("kind", ["flat", "random"])
def test_parts_of_whole_stacks_have_whole_means(kind):
    found = problems({**data(), "sand": {"kind": kind, "parts": [{"mean": 1}, {"mean": 2.5}]}})
    assert [problem.message for problem in found.values()] == [
        "parts[1].mean is 2.5; allowed here: whole numbers of slabs"
    ]


def test_parts_of_dropped_sand_have_any_mean():
    scenario = load_scenario({**data(), "sand": {"kind": "dropped", "parts": [{"mean": 2.5}]}})
    assert scenario.sand.parts[0].mean == 2.5


def test_a_value_below_something_that_is_no_group_is_refused():
    found = problems(data(), [("run.steps.more", "3")])
    assert found["run.steps"].message == "is not a group of keys"
    assert found["run.steps"].place == "command line"


def test_overriding_leaves_the_data_it_starts_from_alone():
    given = data()
    before = json.dumps(given)
    load_scenario(given, [("run.steps", "3")])
    assert json.dumps(given) == before


def test_a_scenario_is_validated_from_any_mapping():
    assert validate(tiny().data()) == tiny()
