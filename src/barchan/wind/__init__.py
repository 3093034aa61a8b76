"""The forcing: direction and speed of the wind at any moment. It knows nothing of models."""

from typing import Annotated

from pydantic import Field

from barchan.wind.segment import Segment
from barchan.wind.steady import Steady

Wind = Annotated[Steady, Field(discriminator=None)]

__all__ = ["Segment", "Steady", "Wind"]
