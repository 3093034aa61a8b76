"""``barchan presets``: the scenarios that ship with Barchan."""


def presets(name: str | None = None, /) -> None:
    """List the scenarios that ship with Barchan, or print one as a scenario file.

    Parameters
    ----------
    name
        A preset to print, to be saved and changed.
    """
    from rich.table import Table

    from barchan.cli.terminal import console
    from barchan.scenario import load_scenario, preset_names

    if name is not None:
        console.out(load_scenario(name).text(), end="", highlight=False)
        return
    table = Table(box=None, pad_edge=False)
    table.add_column("name", no_wrap=True, min_width=max(map(len, preset_names())))
    for column in ("title", "source"):
        table.add_column(column)
    for preset in preset_names():
        scenario = load_scenario(preset)
        table.add_row(preset, scenario.title, scenario.citation)
    console.print(table)
