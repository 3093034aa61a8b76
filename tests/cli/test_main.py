"""An error that a user can mend is printed on stderr, with exit code 1 and without a traceback."""

import subprocess
import sys

import pytest

from barchan.version import __version__

BAD = {"wrong value": ["--run.steps", "-3"], "unknown key": ["--run.stpes", "3"], "no key": ["5"]}


@pytest.mark.parametrize("command", ["run", "check"])
@pytest.mark.parametrize("words", BAD.values(), ids=list(BAD))
def test_mistakes_in_a_scenario_are_told_on_stderr(here, barchan, command, words):
    result = barchan(command, "tiny.json", *words)
    assert result.code == 1
    assert result.out == ""
    assert result.err.startswith("barchan: ")
    assert "1 problem" in result.err
    assert "(command line)" in result.err
    assert "Traceback" not in result.err
    assert [path.name for path in here.iterdir()] == ["tiny.json"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["run", "nonesuch"], "no preset and no file of this name"),
        (["check", "nonesuch"], "no preset and no file of this name"),
        (["presets", "nonesuch"], "no preset and no file of this name"),
        (["resume", "nonesuch"], "not a run (it has no scenario.json)"),
        (["info", "nonesuch"], "not a run (it has no scenario.json)"),
        (["parameters", "nonesuch"], "no key begins with 'nonesuch'"),
        (["run", "tiny.json", "--out", "tiny.json"], "tiny.json is a file, not a folder"),
    ],
)
def test_what_is_not_there_is_told_on_stderr(here, barchan, words, said):
    result = barchan(*words)
    assert (result.code, result.out) == (1, "")
    assert said in result.err


@pytest.mark.parametrize("command", ["show", "film"])
def test_a_folder_that_is_no_run_is_called_so(here, barchan, command):
    assert "not a run" in barchan(command, "nonesuch").err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["dance"], 'Unknown command "dance"'),
        (["run"], "requires an argument"),
        (["show"], "requires an argument"),
        (["show", "tiny", "--view", "dream"], "dream"),
        (["info", "tiny", "--loud"], "--loud"),
    ],
)
def test_words_that_make_no_command_are_told_on_stderr(here, barchan, words, said):
    result = barchan(*words)
    assert result.code not in (0, 130)
    assert result.out == ""
    assert said in result.err
    assert "Traceback" not in result.err


def test_the_package_run_as_a_module_is_the_command():
    command = [sys.executable, "-m", "barchan", "--version"]
    found = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (found.returncode, found.stdout.strip(), found.stderr) == (0, __version__, "")
