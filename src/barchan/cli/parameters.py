"""``barchan parameters``: every key of a scenario."""

from barchan.errors import BarchanError


def parameters(key: str = "", /) -> None:
    """List every key of a scenario, with unit, default, bounds, meaning and source.

    Parameters
    ----------
    key
        Only keys that begin like this, for instance model or run.until.
    """
    from rich.text import Text

    from barchan.cli.terminal import console
    from barchan.scenario.listing import all_keys

    listed = [d for d in all_keys() if d.key.startswith(key.replace("-", "_"))]
    if not listed:
        raise BarchanError(f"no key begins with '{key}'")
    group = None
    for declaration in listed:
        if declaration.heading != group:
            group = declaration.heading
            console.print(f"\n{group}", style="bold")
        unit = "" if declaration.unit == "-" else f" {declaration.unit}"
        live = ", may change during a run" if declaration.live else ""
        value = "null" if declaration.default is None else f"{declaration.default}{unit}"
        default = "required" if declaration.required else f"default {value}"
        only = declaration.bounds == f"'{declaration.default}'"
        facts = f"  {declaration.bounds}" if only else f"  {default}; {declaration.bounds}{live}"
        console.print(Text.assemble("  ", (declaration.key, "cyan"), facts))
        source = f" ({declaration.source})" if declaration.source else ""
        console.print(Text.assemble(f"      {declaration.meaning}", (source, "dim")))
