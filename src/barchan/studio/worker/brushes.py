"""The brushes that the browser offers for a simulation."""

from typing import Any

from barchan.simulation import Simulation

USUAL_SHARE = 0.1
"""Strength of a brush for plants at first, as a share of the field's upper bound."""


def brushes(simulation: Simulation) -> list[dict[str, Any]]:
    """Sand, ground and the fields that the model lets paint: data of a stroke, unit, strengths."""
    slab = {"unit": simulation.bed.layers[-1].unit, "least": 1.0, "most": 1000.0, "whole": True}
    return [
        {"title": simulation.model.material, "stroke": {"kind": "stroke"}, "usual": 2.0, **slab},
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
