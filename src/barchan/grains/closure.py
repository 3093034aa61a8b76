"""Closures: the parts that a model of grains is composed of.

A closure is a group of parameters, under a key of its own, beside the code that turns them into what kernels
take. A model names its closures; a process without a closure does not happen.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, Self, TypeVar

from pydantic import Field, ValidationError, create_model, model_validator
from pydantic_core import InitErrorDetails

from barchan.lattice import Lattice
from barchan.parameters import Parameters

if TYPE_CHECKING:
    from barchan.grains.parameters import GrainFlight

Group = TypeVar("Group", bound=Parameters)


class Closure(Parameters):
    """A part of a model of grains."""

    key: ClassVar[str]
    """The key of its parameters in a scenario."""

    def mistakes(self, rules: "GrainFlight") -> list[InitErrorDetails]:
        """Mistakes that show only beside the other parameters."""
        return []


Part = TypeVar("Part", bound=Closure)


@cache
def _key_of(composition: type[Parameters], kind: type[Closure]) -> str | None:
    """The key of the closure of a kind among composed parameters; None where there is none."""
    for key, field in composition.model_fields.items():
        if isinstance(field.annotation, type) and issubclass(field.annotation, kind):
            return key
    return None


class Composition(Parameters):
    """Parameters of which some are closures."""

    def closures(self) -> Iterator[Closure]:
        """The closures, in the order in which the model names them."""
        return (value for _, value in self if isinstance(value, Closure))

    def part(self, kind: type[Part]) -> Part | None:
        """The closure of a kind; None where the model has none."""
        key = _key_of(type(self), kind)
        found: Part | None = None if key is None else getattr(self, key)
        return found

    @model_validator(mode="after")
    def _closures_fit(self) -> Self:
        found = [
            InitErrorDetails(type=error["type"], loc=(one.key, *error["loc"]), input=None)
            for one in self.closures()
            for error in one.mistakes(self)  # type: ignore[arg-type]
        ]
        if found:
            raise ValidationError.from_exception_data(type(self).__name__, found)
        return self


def composed(base: type[Group], closures: Iterable[type[Closure]]) -> type[Group]:
    """The parameters of ``base`` and those of closures, each group of these under its key."""
    groups: dict[str, Any] = {
        one.key: (one, Field(default_factory=one, description=(one.__doc__ or "").splitlines()[0]))
        for one in closures
    }
    return create_model(
        base.__name__, __base__=base, __module__=base.__module__, __doc__=base.__doc__, **groups
    )


@dataclass(frozen=True)
class Setting:
    """The parameters, lattice and wind that kernel structs are built for."""

    rules: "GrainFlight"
    lattice: Lattice
    direction: float
    """Direction that the wind comes from (degrees)."""
    ustar: float
    """Friction velocity (m/s) of the wind above the grains."""
