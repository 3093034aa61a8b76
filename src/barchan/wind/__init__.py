"""The forcing: direction and speed of the wind at any moment. It knows nothing of models."""

from typing import Annotated

from pydantic import Field

from barchan.wind.regimes import Regime, Regimes
from barchan.wind.saltation import Saltation
from barchan.wind.segment import Segment
from barchan.wind.steady import Steady

Wind = Annotated[Steady | Regimes, Field(discriminator="kind")]

__all__ = ["Regime", "Regimes", "Saltation", "Segment", "Steady", "Wind"]
