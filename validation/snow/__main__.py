"""Run studies of snow and print their rows: ``python -m validation.snow [ranges] [arrest] [diagram]``."""

import sys

from validation.snow import arrest, diagram, ranges
from validation.study import table

STUDIES = {"ranges": ranges, "arrest": arrest, "diagram": diagram}

if __name__ == "__main__":
    for name in sys.argv[1:] or STUDIES:
        study = STUDIES[name]
        print(f"## {study.TITLE}\n\n{(study.__doc__ or '').strip()}\n\n{table(study.rows())}\n", flush=True)
