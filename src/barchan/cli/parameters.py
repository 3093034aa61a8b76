"""``barchan parameters``: every key of a scenario."""

from typing import TYPE_CHECKING

from barchan.errors import BarchanError

if TYPE_CHECKING:
    from barchan.scenario.listing import Key


def parameters(word: str = "", /) -> None:
    """List every key of a scenario, with unit, default, bounds, meaning and source.

    Parameters
    ----------
    word
        Only keys that begin like this, for instance model or run.until; or those of a model or another kind,
        for instance momiji or storms; or else keys whose name or meaning has this word in it, for instance
        shadow or seed.
    """
    from rich.text import Text

    from barchan.cli.terminal import console
    from barchan.scenario.listing import all_keys

    listed = _found(list(all_keys()), word)
    if not listed:
        raise BarchanError(f"no key begins with '{word}', and no name or meaning has it")
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


def _found(keys: "list[Key]", word: str) -> "list[Key]":
    """The keys that begin with a word, or of the kind that it names, or that have it in name or meaning."""
    name, plain = word.replace("-", "_"), word.casefold()
    begin = [key for key in keys if key.key.startswith(name)]
    of_kind = [key for key in keys if f'"{name.casefold()}"' in key.heading]
    return (
        begin
        or of_kind
        or [key for key in keys if name.casefold() in key.key.casefold() or plain in key.meaning.casefold()]
    )
