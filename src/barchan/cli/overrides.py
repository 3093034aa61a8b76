"""Values of a scenario given on the command line: ``--model.hop-length 7``."""

from typing import Annotated

from cyclopts import Parameter

from barchan.errors import Problem, ScenarioError
from barchan.scenario.files import Override

Tokens = Annotated[
    str,
    Parameter(
        show=True,
        allow_leading_hyphen=True,
        help="Any value of the scenario by its key, as in --model.hop-length 7 --run.seed 3; "
        "'barchan parameters' lists the keys.",
    ),
]
"""What is left of the command line after its own options."""


def pairs(tokens: tuple[str, ...]) -> list[Override]:
    """Keys and values from ``--key value`` and ``--key=value``.

    Raises ScenarioError for what is neither.
    """
    found: list[Override] = []
    problems = []
    rest = list(tokens)
    while rest:
        token = rest.pop(0)
        key, equals, value = token.removeprefix("--").partition("=")
        if not token.startswith("--") or not key:
            problems.append(Problem(token, "is not a key; write --key value", "command line"))
        elif equals:
            found.append((key, value))
        elif rest and not rest[0].startswith("--"):
            found.append((key, rest.pop(0)))
        else:
            problems.append(Problem(key, "has no value; write --key value", "command line"))
    if problems:
        raise ScenarioError(problems, "command line")
    return found
