"""The pages that the documentation makes from the code's declarations are kept as they are made today."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "_ext"))

from generate import all_pages  # noqa: E402

KEPT = ROOT / "docs" / "_generated"
COMMANDS = "commands.md"
"""Its layout is the command line library's, and may differ between versions of it."""


def test_kept_pages_are_those_of_the_code():
    pages = dict(all_pages())
    assert {str(path.relative_to(KEPT)) for path in KEPT.rglob("*.md")} == set(pages)
    for name, text in pages.items():
        kept = (KEPT / name).read_text("utf-8")
        if name == COMMANDS:
            assert re.findall(r"^## .*", kept, re.M) == re.findall(r"^## .*", text, re.M), name
        else:
            assert kept == text, f"{name}: build the documentation, which writes it anew"


def test_links_between_kept_pages_and_pictures_lead_to_files():
    for page in (*KEPT.rglob("*.md"), ROOT / "docs" / "index.md", ROOT / "README.md"):
        if "parts" in page.parts:
            continue
        text = re.sub(r"^```.*?^```", "", page.read_text("utf-8"), flags=re.M | re.S)
        for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text):
            if "://" not in target:
                assert (page.parent / target).exists(), f"{page.name}: {target}"
