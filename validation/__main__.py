"""Run the studies and write their pages: ``python -m validation [--pages] [STUDY ...]``."""

import argparse
import importlib
import sys
import time

from validation import figures, pages
from validation.study import table

STUDIES = sorted(name for theme in pages.THEMES for name in theme.studies)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--pages", action="store_true", help="run nothing, write pages and figures from results"
    )
    parser.add_argument(
        "studies", nargs="*", choices=[[], *STUDIES], metavar="STUDY", help=", ".join(STUDIES)
    )
    arguments = parser.parse_args()
    if not arguments.pages:
        for name in arguments.studies or STUDIES:
            run(name)
    figures.write(pages.studies())
    pages.write()


def run(name: str) -> None:
    """Run a study and keep its result."""
    pages.RESULTS.mkdir(exist_ok=True)
    started = time.perf_counter()
    study = importlib.import_module(f"validation.{name}")
    parts = [f"## {study.TITLE}", study.__doc__.strip(), table(study.rows()), study.READING.strip()]
    text = "\n\n".join(filter(None, parts)) + "\n"
    (pages.RESULTS / f"{name}.md").write_text(text, "utf-8")
    print(text, f"({time.perf_counter() - started:.0f} s)\n", file=sys.stdout, flush=True)


if __name__ == "__main__":
    main()
