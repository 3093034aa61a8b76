"""Values of a scenario given on the command line: ``--model.hop-length 7``."""

import inspect
from collections.abc import Callable, Iterator
from typing import Annotated, Any

from cyclopts import Parameter

from barchan.errors import Problem, ScenarioError
from barchan.scenario.overrides import COMMAND_LINE, Override, full_path, hint_for, value_of
from barchan.simulation import AnyEvent, SetParameter, event_from
from barchan.wind import Wind

Tokens = Annotated[
    str,
    Parameter(
        show=True,
        allow_leading_hyphen=True,
        help="Any value of the scenario by its key, as in --model.hop-length 7 --run.seed 3; "
        "'barchan parameters' lists the keys.",
    ),
]
"""The rest of the command line after its own options."""


def pairs(tokens: tuple[str, ...], command: Callable[..., Any] | None = None) -> list[Override]:
    """Keys and values from ``--key value`` and ``--key=value``.

    Raises ScenarioError for anything else, with the option of ``command`` that may have been meant.
    """
    options = _options(command)
    found: list[Override] = []
    problems = []
    rest = list(tokens)
    while rest:
        token = rest.pop(0)
        option, equals, value = token.partition("=")
        key = option.removeprefix("--")
        if not token.startswith("--") or not key:
            problems.append(Problem(token, "is not a key; write --key value", "command line"))
            continue
        given = bool(equals)
        if not given and rest and not rest[0].startswith("--"):
            given, value = True, rest.pop(0)
        if full_path(key) is None:
            message = f"is no option and no key{hint_for(key, COMMAND_LINE, options)}"
            problems.append(Problem(option, message, "command line"))
        elif given:
            found.append((key, value))
        else:
            problems.append(Problem(key, "has no value; write --key value", "command line"))
    if problems:
        raise ScenarioError(problems, "command line")
    return found


def changes(found: list[Override], wind: Wind) -> Iterator[AnyEvent]:
    """The events that values given for keys of the model, and of the ``wind`` as it blows, come to.

    Raises ScenarioError for keys that cannot change during a run.
    """
    keys = [(key.replace("-", "_"), value_of(text)) for key, text in found]
    wrong = [key for key, _ in keys if key.partition(".")[0] not in ("model", "wind")]
    if wrong:
        message = "cannot change during a run; these can: keys of the wind, and live ones of the model"
        raise ScenarioError([Problem(key, message, "command line") for key in wrong], "command line")
    yield from (SetParameter(key=key, value=value) for key, value in keys if key.startswith("model."))
    blows = {key.removeprefix("wind."): value for key, value in keys if key.startswith("wind.")}
    if blows:
        now = wind.model_dump(mode="json", exclude_none=True)
        same_kind = blows.get("kind", now["kind"]) == now["kind"]
        yield event_from({"kind": "wind", "wind": {**now, **blows} if same_kind else blows})


def _options(command: Callable[..., Any] | None) -> list[str]:
    """The names of a command's own options."""
    given = inspect.signature(command).parameters.values() if command else ()
    return [option.name for option in given if option.kind is option.KEYWORD_ONLY]
