"""The description of a run that the browser needs beside its frames."""

import math
from typing import Any

from barchan.analysis.grain_paths import follows_grains
from barchan.models import models
from barchan.scenario import Scenario
from barchan.scenario.changes import changed_from
from barchan.simulation import Simulation
from barchan.squares import Squares
from barchan.studio.worker.bookmarks import identity
from barchan.studio.worker.brushes import brushes
from barchan.studio.worker.changes import changes_of
from barchan.studio.worker.frame_fields import exported_fields, fields_of
from barchan.studio.worker.live_measures import FINEST, ROWS, declared_measures
from barchan.studio.worker.strata import declared_strata


def named(simulation: Simulation, origin: Scenario) -> Scenario:
    """The scenario as changes have left it; its words name the values in which it differs from ``origin``."""
    return changed_from(simulation.scenario_as_run, origin)


def description(simulation: Simulation, origin: Scenario) -> dict[str, Any]:
    """The scenario as changes have left it, lattice, fields, measures, facts and remarks.

    Title and citation name every value in which it differs from its ``origin``.
    """
    lattice, model = Squares(simulation.lattice).lattice, simulation.model
    scenario = named(simulation, origin)
    place = scenario.ground.georeference()
    limits = model.slope_limits().get("bare", ())
    return {
        "scenario": scenario.data(),
        "lattice": {
            "rows": lattice.rows,
            "columns": lattice.columns,
            "cell_size": lattice.cell_size,
            "thickness": lattice.thickness,
            "periodic": lattice.periodic,
        },
        "place": place and {"west": place.west, "south": place.south, "crs": place.crs},
        "model": {"name": model.name, "title": model.title, "citation": model.citation},
        "models": {name: known.title for name, known in models().items()},
        "materials": {name: known.material for name, known in models().items()},
        "fields": fields_of(simulation),
        "exported": exported_fields(simulation),
        "layers": [
            {"field": name, "title": layer.title if name == layer.field else name, "colours": layer.colours}
            for layer in model.overlays
            for name in (layer.field, *layer.parts)
        ],
        "brushes": brushes(simulation),
        "strata": declared_strata(simulation),
        "paths": follows_grains(model),
        "measures": declared_measures(simulation),
        "step_seconds": simulation.scenario.step_seconds,
        "measured_every": min(simulation.scenario.run.save_every, FINEST),
        "measured_rows": ROWS,
        "repose": math.degrees(math.atan(limits[0] * lattice.aspect)) if limits else None,
        "repose_slabs": float(limits[0]) if limits else None,
        "facts": {**scenario.facts(), **scenario.forecast()},
        "remarks": scenario.remarks(simulation.bed.ground),
        "events": len(simulation.events),
        "identity": identity(simulation),
        "changes": changes_of(simulation),
    }
