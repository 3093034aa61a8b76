"""Influx: what the wind brings in across open edges, where it blows into the field."""

from collections.abc import Callable
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from barchan.parameters import Parameters, parameter


class Influx(Parameters):
    """Sand that enters across open edges from upwind, even along them or by a profile."""

    kind_key: ClassVar[str] = "kind"
    amount: ClassVar[str]
    """The parameter that factors of the profile multiply."""
    greatest: ClassVar[int]
    """What it may be at most, with the factor."""

    kind: str
    profile: list[float] | None = parameter(
        None,
        unit="-",
        min_length=1,
        max_length=65536,
        meaning="Factors, 0 or more, on the influx at equal distances along each edge, from its south or "
        "west end, with straight lines between; 1 everywhere where not given.",
        source="ours",
    )

    @property
    def factors(self) -> list[float]:
        """The profile, 1 everywhere where none is given."""
        return [1.0] if self.profile is None else self.profile

    @model_validator(mode="after")
    def _bounded(self) -> Self:
        """The profile takes nothing out, and does not lift the amount over its bound."""
        least, most = min(self.factors), max(self.factors)
        if least < 0.0:
            raise ValueError(f"profile has a factor of {least:g}; allowed: 0 and more")
        amount = getattr(self, self.amount)
        if amount * most > self.greatest:
            raise ValueError(
                f"{self.amount} {amount:g} times the greatest factor of profile, {most:g}, is "
                f"{amount * most:g}; allowed: up to {self.greatest}"
            )
        return self

    def slabs_per_row(self, saturated: Callable[[], float], share: float) -> float:
        """Slabs that enter across each cell of an edge square to a wind that blows for a share of a step.

        ``saturated`` gives the number that this wind takes across it on a wide flat bed of sand, and is
        asked only where that counts: not every model's parameters tell it.
        """
        raise NotImplementedError

    def along_edge(self, cells: int) -> NDArray[np.float64]:
        """The factor on the influx at each cell of an edge, from its south or west end."""
        count = len(self.factors)
        places = np.linspace(0.0, 1.0, count) if count > 1 else np.zeros(1)
        return np.interp((np.arange(cells) + 0.5) / cells, places, self.factors)


class SaturatedInflux(Influx):
    """A share of the flux that a wide flat bed of sand upwind would send."""

    amount = "share"
    greatest = 10

    kind: Literal["saturation"] = parameter(
        "saturation", unit="-", meaning="A share of the flux over a wide flat bed of sand.", source="ours"
    )
    share: float = parameter(
        1.0,
        unit="-",
        ge=0,
        le=greatest,
        meaning="Influx over the saturated flux of the wind that blows.",
        source="ours: AeoLiS states the flux at its upwind edge in the same way",
    )

    def slabs_per_row(self, saturated: Callable[[], float], share: float) -> float:  # noqa: ARG002
        """The stated share of the saturated flux."""
        return self.share * saturated()


class CountedInflux(Influx):
    """A stated number of slabs."""

    amount = "slabs_per_step"
    greatest = 1000

    kind: Literal["slabs"] = parameter("slabs", unit="-", meaning="A stated number of slabs.", source="ours")
    slabs_per_step: float = parameter(
        unit="slabs",
        ge=0,
        le=greatest,
        scale="log",
        meaning="Slabs that enter in a step across each cell of an edge that lies square to the wind.",
        source="ours",
    )

    def slabs_per_row(self, saturated: Callable[[], float], share: float) -> float:  # noqa: ARG002
        """The stated number, in proportion to the share of the step."""
        return self.slabs_per_step * share


AnyInflux = Annotated[SaturatedInflux | CountedInflux, Field(discriminator="kind")]
