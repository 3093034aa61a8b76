"""Help says what each command is for, and costs nothing."""

import subprocess
import sys

import pytest

from barchan import __version__
from barchan.cli import COMMANDS

LIGHT = """
import sys
from contextlib import redirect_stdout
from io import StringIO
from barchan.cli import app
words = sys.argv[1:]
with redirect_stdout(StringIO()) as text:
    app()([*words, "--help"], result_action="return_value")
assert len(text.getvalue()) > 200
print(*sorted({name.split(".")[0] for name in sys.modules}))
"""


def words_of(text):
    """A text as one line, without boxes."""
    return " ".join(text.replace("│", " ").split())


def test_help_lists_every_command_with_its_purpose(barchan):
    result = barchan("--help")
    assert result.code == 0
    for name, purpose in COMMANDS.items():
        assert name in result.out
        assert purpose in words_of(result.out)


@pytest.mark.parametrize("name", COMMANDS)
def test_the_help_of_a_command_begins_with_its_purpose(barchan, name):
    result = barchan(name, "--help")
    assert result.code == 0
    assert result.out.startswith(f"Usage: barchan {name}")
    assert COMMANDS[name].rstrip(".") in words_of(result.out)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_argument_and_option_is_explained(barchan, monkeypatch, name):
    monkeypatch.setenv("COLUMNS", "800")
    for line in barchan(name, "--help").out.splitlines():
        if line.startswith("│") and line.strip("│ "):
            assert len(line.strip("│ *").split("  ", 1)) == 2, line


def test_words_alone_are_answered_with_help(barchan):
    assert barchan().out == barchan("--help").out


def test_the_version_is_told(barchan):
    assert barchan("--version").out.strip() == __version__


def loaded_by_help_of(*words):
    """The packages that showing help loads."""
    run = subprocess.run([sys.executable, "-c", LIGHT, *words], check=True, capture_output=True, text=True)
    return set(run.stdout.split())


def test_help_loads_no_numerical_package():
    assert not loaded_by_help_of() & {"numba", "numpy", "scipy", "xarray", "zarr", "pydantic", "matplotlib"}


@pytest.mark.parametrize("name", ["run", "show", "check"])
def test_the_help_of_a_command_loads_no_compiler_and_no_painter(name):
    assert not loaded_by_help_of(name) & {"numba", "llvmlite", "matplotlib"}
