"""``barchan presets``: the scenarios that ship with Barchan."""


def presets(name: str | None = None, /) -> None:
    """List the scenarios that ship with Barchan by their models, or print one as a scenario file.

    Sizes are columns × rows of cells; the time is what a run is expected to take on one core.

    Parameters
    ----------
    name
        A preset to print, to be saved and changed.
    """
    from rich.table import Table
    from rich.text import Text

    from barchan.cli.terminal import console
    from barchan.models import models
    from barchan.scenario import load_scenario, preset_names
    from barchan.scenario.cost import expected_seconds, spoken_estimate

    if name is not None:
        console.out(load_scenario(name).text(), end="", highlight=False)
        return
    scenarios = {preset: load_scenario(preset) for preset in preset_names()}
    width = max(map(len, scenarios))
    for name, model in models().items():
        of_model = {preset: s for preset, s in scenarios.items() if s.model.name == name}
        if not of_model:
            continue
        console.print(Text.assemble((model.title, "bold"), f", model {name}"))
        table = Table(box=None, pad_edge=False)
        table.add_column("  name", no_wrap=True, min_width=width + 2)
        table.add_column("size", no_wrap=True, min_width=11)
        table.add_column("steps", justify="right", min_width=5)
        table.add_column("expected time", no_wrap=True, min_width=16)
        table.add_column("title, source")
        for preset, scenario in of_model.items():
            lattice = scenario.lattice
            table.add_row(
                f"  {preset}",
                f"{lattice.columns} × {lattice.rows}",
                str(scenario.run.steps),
                spoken_estimate(expected_seconds(scenario)),
                f"{scenario.title} ({scenario.citation})" if scenario.citation else scenario.title,
            )
        console.print(table)
        console.print()
