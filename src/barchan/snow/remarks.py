"""What a user should know of a choice of snow's parameters before a run."""

from barchan.lattice import Lattice
from barchan.snow.conditions import Conditions, step_seconds
from barchan.snow.parameters import SnowParameters

WIDEST = 2.0
"""Width of a cell, in hops, beyond which most quanta land on the cell that they left."""

_HOUR = 3600.0


def remarks_on(parameters: SnowParameters, lattice: Lattice) -> list[str]:
    """Remarks on cells that are wide beside a hop, and on bonds that grow within a step."""
    found = []
    if lattice.cell_size > WIDEST * parameters.hop:
        found.append(
            f"cells of {lattice.cell_size:g} m are more than {WIDEST:g} hops of {parameters.hop:g} m wide: "
            "most quanta land on the cell that they left, and no form can grow"
        )
    seconds = step_seconds(parameters)
    rate = Conditions(parameters, 0.0, parameters.temperature).rate
    bonding = parameters.bonding.loose_hours * _HOUR / rate
    if parameters.bonding.grows and bonding <= seconds:
        found.append(
            f"snow bonds within {bonding:.3g} s at {parameters.temperature:g} °C, and a step lasts "
            f"{seconds:.3g} s: it locks at once"
        )
    return found
