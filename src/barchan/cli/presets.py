"""``barchan presets``: the scenarios that ship with Barchan."""

from barchan.words import counted


def presets(name: str | None = None, /) -> None:
    """List the scenarios that ship with Barchan by their models, or print one as a scenario file.

    Sizes are columns × rows of cells; the time is what a run is expected to take on one core,
    compilation left out.

    Parameters
    ----------
    name
        A preset to print, to be saved and changed.
    """
    from rich.text import Text

    from barchan.cli.terminal import console
    from barchan.models import models
    from barchan.scenario import load_scenario, preset_names
    from barchan.scenario.cost import COMPILED, expected_seconds, spoken_estimate

    if name is not None:
        console.out(load_scenario(name).text(), end="", highlight=False)
        return
    scenarios = {preset: load_scenario(preset) for preset in preset_names()}
    width = max(map(len, scenarios))
    for known, model in models().items():
        of_model = {preset: s for preset, s in scenarios.items() if s.model.name == known}
        if not of_model:
            continue
        console.print(Text.assemble((model.title, "bold"), f", model {known}"))
        for preset, scenario in of_model.items():
            lattice, steps = scenario.lattice, scenario.run.steps
            time = spoken_estimate(expected_seconds(scenario))
            facts = f"{lattice.columns} × {lattice.rows} cells, {counted(steps, 'step')}, {time}"
            source = f"; {scenario.citation}" if scenario.citation else ""
            console.print(Text.assemble("  ", (f"{preset:{width}}", "cyan"), f"  {scenario.title}"))
            console.print(Text.assemble(f"      {facts}", (source, "dim")))
        console.print()
    console.print(f"A preset runs for the time given, and {COMPILED}.")
