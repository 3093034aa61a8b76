"""``barchan studio``: the live laboratory in the browser."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.cli.overrides import Tokens, pairs


def studio(
    scenario: str | None = None,
    /,
    *values: Tokens,
    folder: Path = Path(),
    host: str = "127.0.0.1",
    port: Annotated[int, Parameter(validator=Number(gte=0, lte=65535))] = 0,
    browser: bool = True,
) -> None:
    """Open the studio in the browser and watch a scenario run. Ctrl-C ends it.

    Parameters
    ----------
    scenario
        A preset's name, a scenario file, or the folder of a run to look at and go on with; without it the
        studio opens with its gallery of presets.
    folder
        Where runs are saved and opened; the current folder without it.
    host
        Address to serve at. Any other than this computer's own lets others in who have the address with its
        token.
    port
        Port to serve at; a free one without it.
    browser
        Open the browser.
    """
    from barchan.archive import source_at
    from barchan.archive.folder import CHECKPOINT
    from barchan.cli.terminal import console, print_note
    from barchan.scenario import load_scenario
    from barchan.studio.server.gallery import showpiece
    from barchan.studio.server.launch import Studio, serve
    from barchan.studio.server.security import LOOPBACK

    overrides = pairs(values, studio)
    source = source_at(scenario or showpiece())
    is_run = isinstance(source, Path) and (source.parent / CHECKPOINT).is_file() and not overrides
    chosen = None if is_run else load_scenario(source, overrides)
    archive = Path(scenario).resolve() if scenario and is_run else None
    if host not in LOOPBACK:
        print_note(f"others can reach the studio at {host}; whoever has the address below can use it")

    def ready(address: str) -> None:
        console.print(f"studio: {address}")
        console.print("Ctrl-C ends it")

    serve(Studio(folder, chosen, archive, host, port, gallery=scenario is None), ready, browser)
