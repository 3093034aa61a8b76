"""Every code block of the documentation runs: Python as it stands, console blocks by their commands."""

import shlex
from pathlib import Path
from typing import Any

import pytest

from barchan.cli import app
from tests.docs.blocks import Block, blocks, commands

ROOT = Path(__file__).resolve().parents[2]
PAGES = [*sorted((ROOT / "docs").glob("*.md")), ROOT / "README.md"]
RUNNABLE = ("python", "console")


def run_python(block: Block, page: Path, names: dict[str, Any]) -> None:
    """Run a block so that errors name its page and line."""
    text = "\n" * (block.line - 1) + block.text
    exec(compile(text, str(page), "exec"), names)


def run_console(block: Block, page: Path) -> None:
    """Run the ``barchan`` commands of a block; others are left alone."""
    for command in commands(block):
        program, *words = shlex.split(command, comments=True)
        if program == "barchan":
            code = app()(words, result_action="return_value")
            assert code in (None, 0), f"{page.name}:{block.line}: '{command}' returned {code}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_code_blocks_run(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    names: dict[str, Any] = {"__name__": "__main__"}
    for block in blocks(page):
        if block.file:
            (tmp_path / block.file).write_text(block.text, "utf-8")
        elif block.run and block.language == "python":
            run_python(block, page, names)
        elif block.run and block.language == "console":
            run_console(block, page)


def test_blocks_are_found_and_told_apart(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "```python\none = 1\n```\n\n<!-- not run -->\n```python\nno\n```\n\n"
        "<!-- file: a.json -->\n\n```json\n{}\n```\ntext\n\n"
        "```{note}\na note\n```\n\n```console\n$ barchan run \\\n  x\noutput\n$ ls\n```\n",
        "utf-8",
    )
    found = list(blocks(page))
    assert [(b.language, b.run, b.file, b.line) for b in found] == [
        ("python", True, "", 2),
        ("python", False, "", 7),
        ("json", True, "a.json", 13),
        ("{note}", True, "", 18),
        ("console", True, "", 22),
    ]
    assert list(commands(found[-1])) == ["barchan run    x", "ls"]
