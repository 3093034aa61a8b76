"""``barchan curves``: the curves of a scenario's model."""

from pathlib import Path

from barchan.cli.overrides import Tokens, pairs
from barchan.errors import BarchanError


def curves(scenario: str, /, *values: Tokens, out: Path = Path("curves.png")) -> None:
    """Draw the curves of a scenario's model, with their sources.

    Of snow: what wind it withstands by age and temperature, how fast it bonds, how dense it falls, drifts and
    packs, how much of it a wind carries. Of snow_werner: its assumed densities. Of momiji and bishop: the hop
    by height. Of nield_baas: the growth of plants.

    Parameters
    ----------
    scenario
        A scenario file, a preset's name, or a run's folder.
    out
        The picture's file (PNG, PDF or SVG by its ending); curves.png in the current folder without it.
    """
    from barchan.archive import source_at
    from barchan.cli.terminal import save_picture
    from barchan.figures.curves import curves_of
    from barchan.models import models
    from barchan.scenario.files import load_scenario

    chosen = load_scenario(source_at(scenario), pairs(values, curves))
    model = models()[chosen.model.name]
    found = model.curves(chosen.model)
    if not found:
        raise BarchanError(f"{scenario}: its model, {model.name}, has no curves")
    save_picture(curves_of(found, chosen), out)
