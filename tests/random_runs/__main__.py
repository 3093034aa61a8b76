"""``python -m tests.random_runs FIRST [COUNT] [narrow] [every]``: run scenarios, print what happened.

``every`` asks for every combination of rules, each of which is compiled by itself.
"""

import faulthandler
import json
import sys
import time
from collections import Counter

from tests.random_runs.drawing import scenario
from tests.random_runs.holding import check

SLOW = 10.0
"""Seconds from which on a scenario is printed as slow."""

TOLD = 500
"""Scenarios after which the outcomes so far are printed, so that a run that is broken off has counts."""


def tell(text: str) -> None:
    """Print a line at once."""
    sys.stdout.write(f"{text}\n")
    sys.stdout.flush()


def main() -> int:
    """Run the scenarios; the number of failures."""
    faulthandler.enable()
    first, count = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    few = "every" not in sys.argv
    outcomes: Counter[str] = Counter()
    for number in range(first, first + count):
        data = scenario(number, "narrow" in sys.argv, few)
        sys.stderr.write(f"scenario {number}\n")
        began = time.monotonic()
        try:
            outcomes[check(data, number, few)] += 1
        except Exception as error:
            outcomes["failed"] += 1
            tell(f"scenario {number} failed: {type(error).__name__}: {error}\n{json.dumps(data)}")
        if number % TOLD == TOLD - 1:
            tell(f"up to scenario {number}: {json.dumps(outcomes)}")
        if time.monotonic() - began > SLOW:
            tell(f"scenario {number} took {time.monotonic() - began:.0f} s")
    tell(json.dumps(outcomes))
    return min(outcomes["failed"], 1)


sys.exit(main())
