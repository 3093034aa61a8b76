"""Every code block of the documentation runs: Python as it stands, console blocks by their commands."""

import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "_ext"))

from code_blocks import blocks, commands, run_page  # noqa: E402
from tutorials import pictures  # noqa: E402

TUTORIALS = sorted((ROOT / "docs" / "tutorials").glob("*.md"))
BUILT = os.environ.get("BARCHAN_DOCS") == "built"
"""Whether the documentation is built too, which runs the tutorials and wants their pictures."""

PAGES = [*sorted((ROOT / "docs").glob("*.md")), *([] if BUILT else TUTORIALS), ROOT / "README.md"]


LONG = ("directions", "grains", "pictures")
"""Pages whose blocks take long: they compile rules, or a whole model, of their own."""


def of_page(page):
    """A page as a case of its name."""
    return pytest.param(page, id=page.stem, marks=[pytest.mark.extended] if page.stem in LONG else [])


@pytest.mark.parametrize("page", [of_page(page) for page in PAGES])
def test_code_blocks_run(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    run_page(page, tmp_path)
    missing = [name for name in pictures(page) if not (tmp_path / name).is_file()]
    assert missing == []


def test_blocks_are_found_and_distinguished(tmp_path):
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
