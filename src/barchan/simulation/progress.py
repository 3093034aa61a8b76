"""How far a simulation is, in few words."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from barchan.simulation.core import Simulation


def progress(simulation: "Simulation") -> dict[str, str]:
    """The model, the steps done, the amounts on the bed and its relief."""
    bed, elevation = simulation.bed, simulation.elevation
    amounts = [f"{bed.arrays[layer.name].sum()} {layer.unit} of {layer.name}" for layer in bed.layers]
    relief = f"elevation {elevation.min():.3g} to {elevation.max():.3g} m"
    ended = "" if simulation.finished is None else f" ({simulation.finished})"
    return {
        "model": simulation.model.name,
        "step": f"step {simulation.steps_done} of {simulation.scenario.run.steps}{ended}",
        "bed": ", ".join([*amounts, relief]),
    }
