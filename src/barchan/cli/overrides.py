"""Values of a scenario given on the command line: ``--model.hop-length 7``."""

import inspect
from collections.abc import Callable, Iterator
from typing import Annotated, Any

from cyclopts import Parameter

from barchan.errors import Problem, ScenarioError
from barchan.parameters import NOTE
from barchan.scenario import Scenario
from barchan.scenario.definition import without_empty_notes
from barchan.scenario.messages import value_text
from barchan.scenario.overrides import (
    COMMAND_LINE,
    Given,
    Override,
    full_path,
    given_values,
    hint_for,
    set_value,
    switches,
)
from barchan.scenario.source_map import Path as KeyPath
from barchan.scenario.source_map import dotted
from barchan.simulation import AnyEvent, SetParameter, event_from

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


def changes(found: list[Override], now: Scenario) -> Iterator[AnyEvent]:
    """The events that values given for keys of the model and of the wind come to, over a scenario in force.

    A whole group, ``--wind '{…}'`` or ``--model '{…}'``, stands for its keys. Raises ScenarioError for keys
    that cannot change during a run.
    """
    given, problems = given_values(found, COMMAND_LINE)
    wrong = [one.path for one in given if one.path[0] not in ("model", "wind")]
    message = "cannot change during a run; these can: keys of the wind, and live ones of the model"
    problems += [Problem(dotted(path), message, COMMAND_LINE.word) for path in wrong]
    whole = [one for one in given if len(one.path) == 1 and not isinstance(one.value, dict)]
    problems += [
        Problem(dotted(one.path), f"is {value_text(one.value)}; allowed: a group {{ … }}", COMMAND_LINE.word)
        for one in whole
        if one.path not in wrong
    ]
    if problems:
        raise ScenarioError(problems, COMMAND_LINE.word)
    name = ("model", "name")
    for path, value in (leaf for one in given if one.path[0] == "model" for leaf in _leaves(one)):
        if path != name or value != now.model.name:
            yield SetParameter(key=dotted(path), value=value)
    winds = [one for one in given if one.path[0] == "wind"]
    if winds:
        yield event_from({"kind": "wind", "wind": _changed_wind(winds, now)})


def _leaves(given: Given) -> Iterator[tuple[KeyPath, Any]]:
    """The single values of what is given for a key or a group."""
    if not isinstance(given.value, dict):
        yield given.path, given.value
        return
    for key, value in given.value.items():
        if key != NOTE:
            yield from _leaves(Given((*given.path, key), value))


def _changed_wind(given: list[Given], now: Scenario) -> Any:
    """The wind with values set; of another kind it holds no more than what is given."""
    data = {"wind": without_empty_notes(now.wind.model_dump(mode="json"))}
    if list(switches({"wind": dict(data["wind"])}, given)):
        data = {"wind": {}}
    for one in given:
        problems = set_value(data, one, COMMAND_LINE)
        if problems:
            raise ScenarioError(problems, COMMAND_LINE.word)
    return data["wind"]


def _options(command: Callable[..., Any] | None) -> list[str]:
    """The names of a command's own options."""
    given = inspect.signature(command).parameters.values() if command else ()
    return [option.name for option in given if option.kind is option.KEYWORD_ONLY]
