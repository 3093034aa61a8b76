"""Options of a command made from declared parameters, so that no parameter is declared twice."""

from dataclasses import field, fields, make_dataclass
from typing import Annotated, Any, TypeVar

from cyclopts import Parameter
from cyclopts.validators import Number
from pydantic import ValidationError

from barchan.errors import ScenarioError
from barchan.parameters import Parameters, declarations

Threads = Annotated[int | None, Parameter(validator=Number(gte=1, lte=1024))]
"""The option that states the number of threads."""


def option(text: str, name: str | None = None) -> Parameter:
    """An option with its help, of a group of options; ``name`` where it is not that of the field."""
    return Parameter(name=name, help=text, negative=())


Group = TypeVar("Group", bound=Parameters)


def options_of(group: type[Parameters], without: tuple[str, ...] = ()) -> Any:
    """A class whose fields are the parameters of a group, all optional, with help from their declarations.

    ``without`` names parameters that are no options of the command, as another option gives them.
    """
    made = []
    for declared in (d for d in declarations(group) if d.key not in without):
        annotation = group.model_fields[declared.key].annotation
        text = declared.meaning
        if declared.unit != "-":
            text = f"{text} [unit: {declared.unit}]"
        if declared.default is not None and not isinstance(declared.default, list):
            text = f"{text} [default: {declared.default}]"
        kind: Any = Annotated[annotation | None, Parameter(help=text, negative=())]  # type: ignore[operator]
        made.append((declared.key, kind, field(default=None)))
    name = f"{group.__name__}Options"
    return make_dataclass(name, made, frozen=True, namespace={"__module__": __name__})


def group_from(group: type[Group], options: Any) -> Group:
    """The group of parameters that the options of ``options_of`` come to.

    Raises ScenarioError with every value that is not allowed.
    """
    values = {} if options is None else {item.name: getattr(options, item.name) for item in fields(options)}
    return group_of(group, {name: value for name, value in values.items() if value is not None})


def group_of(group: type[Group], given: dict[str, Any]) -> Group:
    """The group of parameters of some values; raises ScenarioError with every value that is not allowed."""
    from barchan.scenario.messages import problems_of

    try:
        return group.model_validate(given)
    except ValidationError as error:
        raise ScenarioError(
            problems_of(error, group, given, lambda _: "command line"), "command line"
        ) from None
