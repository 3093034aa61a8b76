"""``barchan check``: is a scenario sound?"""

from pathlib import Path

import pytest

from barchan.scenario import preset_names

COMPILED = "and 10 to 60 seconds where its rules are compiled first"


@pytest.mark.parametrize("name", preset_names())
def test_every_preset_is_sound_and_so_is_what_it_is_printed_as(here, barchan, name):
    told = barchan("check", name).out
    assert told.startswith(f"{name}: sound")
    assert "has no effect: it acts" not in told
    (here / "mine.json").write_text(barchan("presets", name).out)
    result = barchan("check", "mine.json")
    assert (result.code, result.err) == (0, "")
    assert result.out.startswith("mine.json: sound")


def test_a_run_is_checked_by_its_folder(finished, barchan):
    assert barchan("check", finished).out.startswith(f"{finished}: sound\n")


def test_what_the_parameters_come_to_is_told(here, barchan):
    out = barchan("check", "tiny.json", "--model.neighbourhood", "moore", "--model.hop-length", 13).out
    assert "effective repose angle: 33.7° towards faces (2 slabs), 25.2° towards corners (2 slabs)" in out
    assert "note: hop length 13 cells is longer than half the field" in out


def test_size_steps_and_expected_time_are_told(here, barchan):
    """300 × 200 cells, 1000 steps: 60 million polls at 20 million a second."""
    size = ("--lattice.columns", 300, "--lattice.rows", 200, "--run.steps", 1000)
    lines = barchan("check", "barchans", *size).out.splitlines()
    assert lines[1].startswith("field: 300 × 200 cells of 1 m, slabs of ")
    assert lines[2:4] == ["steps: 1000", f"expected time: about 3 seconds, {COMPILED}"]


def test_every_mistake_is_told_with_its_line(here, barchan):
    (here / "bad.json").write_text('{\n"barchan": 5,\n"lattice": {"rows": 0},\n"run": {"step": 3}\n}')
    result = barchan("check", "bad.json", "--model.p-s", "2")
    assert result.code == 1
    assert result.err.splitlines() == [
        "barchan: bad.json: 3 problems",
        "  lattice.rows: is 0; allowed: whole number ≥ 1 and ≤ 65536 (bad.json:3)",
        "  model.p_s: is 2; allowed: number ≥ 0 and ≤ 1 (command line)",
        (
            "  run.step: unknown key; did you mean 'steps'?; known here: steps, seed, save_every, threads, "
            "until (bad.json:4)"
        ),
    ]


def test_checking_runs_nothing_and_writes_nothing(here, barchan):
    barchan("check", "tiny.json")
    assert [path.name for path in here.iterdir()] == ["tiny.json"]


@pytest.mark.parametrize("name", ["dunes[a].json", "dunes[/a].json"])
def test_a_file_with_brackets_is_told_by_its_name(here, barchan, name):
    place = here / name
    place.parent.mkdir(exist_ok=True)
    place.write_text((here / "tiny.json").read_text())
    assert barchan("check", name).out.startswith(f"{name}: sound\n")


def test_a_file_of_plants_that_is_missing_is_told(barchan):
    failed = barchan(
        "check", "nebkhas", "--model.vegetation.kind", "file", "--model.vegetation.path", "no.npy"
    )
    assert failed.code != 0
    assert f"model.vegetation.path: '{Path.cwd() / 'no.npy'}': no such file (command line)" in failed.err


def test_mistakes_in_files_are_told_with_the_line_that_names_them(here, barchan):
    """All that is found out only when ground and first sand are made."""
    text = """{
      "barchan": 5, "lattice": {"rows": 8, "columns": 8},
      "ground": {"kind": "file",
        "path": "none.npy"},
      "sand": {"kind": "ripples",
        "wavelength": 900.0}
    }"""
    (here / "lost.json").write_text(text)
    said = barchan("check", "lost.json", "--run.seed", "1").err
    assert f"ground.path: '{here / 'none.npy'}': no such file (lost.json:4)" in said
    assert "sand.wavelength: is 900 m" in said
    assert "at least one (lost.json:6)" in said
    assert "lost.json: 2 problems" in said


def test_a_wind_under_which_nothing_can_move_is_not_called_sound(barchan):
    still = barchan("check", "ripples", "--wind.speed", 3, "--wind.unit", "m/s")
    assert still.out.startswith("ripples: without mistakes, but nothing moves\n")
    assert "friction velocity: 0.083 m/s, threshold 0.2" in still.out


MAST = (
    "time,speed (m/s),direction\n2024-01-01T00:00,8,270\n2024-01-01T01:00,9,280\n"
    "2024-01-01T02:00,7,270\n2024-01-01T03:00,0,\n2024-01-02T00:00,7,270\n2024-01-02T01:00,7,\n"
)
"""Six hours with a gap; one is calm, one has no direction."""


def test_a_record_is_told_with_its_columns_height_rows_and_gaps(here, barchan):
    (here / "mast.csv").write_text(MAST)
    told = barchan("check", "recorded-wind", "--wind.path", "mast.csv").out.replace("\n", " ")
    for words in (
        "record: mast.csv",
        "read: speed (m/s) and direction, in m/s, taken to be at 10 m",
        "rows: 6, 0.0 % missing, 16.7 % of the known time calm, 1 gap",
        "note: gaps: 1;",
        "the record does not state the height of its speeds; taken to be at 10 m; wind.columns.height",
    ):
        assert words in told


def test_the_height_of_a_record_is_that_of_the_clock_until_it_is_stated(here, barchan):
    (here / "mast.csv").write_text(MAST)
    command = ("check", "recorded-wind", "--wind.path", "mast.csv", "--clock.height", 2)
    assert "taken to be at 2 m;" in barchan(*command).out.replace("\n", " ")
    stated = barchan(*command, "--wind.columns.height", 4).out
    assert "in m/s, at 4 m" in stated
    assert "taken to be" not in stated


def test_a_key_that_the_choice_of_another_leaves_without_effect_is_remarked(here, barchan):
    command = ("check", "tiny.json", "--model.corner-limit", "geometric")
    said = "note: model.corner_limit 'geometric' has no effect: it acts where neighbourhood is 'moore'"
    assert said in barchan(*command).out
    assert "has no effect" not in barchan(*command, "--model.neighbourhood", "moore").out


@pytest.mark.parametrize("model", ["wang_hu", "ripples"])
def test_cells_wider_than_a_hop_of_a_grain_are_remarked(here, barchan, model):
    """At 10 m/s a grain leaves at 1.4 x 0.28 m/s, flies for 0.08 s and goes some 0.2 m."""
    command = ("check", "tiny.json", "--model", model, "--lattice.slab-height", 1e-3, "--lattice.cell-size")
    assert "cells of 1 m are wider than a hop of about 0.2 m" in " ".join(barchan(*command, 1).out.split())
    assert "wider than a hop" not in barchan(*command, 0.01).out
