"""Run the studies and write docs/validation.md: ``python -m validation [STUDY ...]``."""

import argparse
import importlib
import pkgutil
import sys
import time
from pathlib import Path

import validation
from validation.study import table

PAGE = Path(__file__).parents[1] / "docs" / "validation.md"
PARTS = Path(__file__).parent / "results"
PICTURES = Path(__file__).parent / "pictures.md"
"""What was seen in the pictures of presets, written by hand."""

INTRODUCTION = """# Validation

What the sources report beside what Barchan does. `python -m validation` runs every study with 5 seeds (unless
it says otherwise) and writes this page: mean ± standard deviation over the seeds. A published number *agrees*
when it lies within two standard deviations of our runs; a published order is put to the vote of the seeds.
Nothing is tuned to agree.
"""

STUDIES = [
    name for _, name, _ in pkgutil.iter_modules(validation.__path__) if name not in ("study", "__main__")
]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "studies", nargs="*", choices=[[], *STUDIES], metavar="STUDY", help=", ".join(STUDIES)
    )
    asked = parser.parse_args().studies or STUDIES
    PARTS.mkdir(exist_ok=True)
    for name in asked:
        started = time.perf_counter()
        study = importlib.import_module(f"validation.{name}")
        parts = [f"## {study.TITLE}", study.__doc__.strip(), table(study.rows()), study.READING.strip()]
        text = "\n\n".join(filter(None, parts)) + "\n"
        (PARTS / f"{name}.md").write_text(text)
        print(text, f"({time.perf_counter() - started:.0f} s)\n", file=sys.stdout, flush=True)
    parts = [path.read_text() for name in STUDIES if (path := PARTS / f"{name}.md").exists()]
    PAGE.write_text("\n".join([INTRODUCTION, *parts, PICTURES.read_text()]))


if __name__ == "__main__":
    main()
