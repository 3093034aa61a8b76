"""What a brush can paint on a simulation, as the browser offers it."""

from typing import Any

from barchan.simulation import Simulation

USUAL_SHARE = 0.1
"""Strength of a brush for plants at first, as a share of what they can come to."""


def brushes(simulation: Simulation) -> list[dict[str, Any]]:
    """Sand, ground and what the model lets paint: what a stroke says of it, unit, strengths."""
    slab = {"unit": "slabs", "least": 1.0, "most": 1000.0, "whole": True}
    return [
        {"title": "sand", "stroke": {"kind": "stroke"}, "usual": 2.0, **slab},
        {"title": "rock", "stroke": {"kind": "rock"}, "usual": 2.0, **slab},
        *(
            {
                "title": field,
                "stroke": {"kind": "plants", "field": field},
                "unit": simulation.bed.declared[field].unit.removeprefix("1"),
                "least": 0.01,
                "most": high,
                "usual": USUAL_SHARE * high,
                "whole": False,
            }
            for field, (_, high) in simulation.model.paintable().items()
        ),
    ]
