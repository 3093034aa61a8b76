"""``barchan studio``: the live laboratory in the browser."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.cli.overrides import Tokens, pairs

if TYPE_CHECKING:
    from barchan.studio.server.unfinished import Found


def studio(
    scenario: str | None = None,
    /,
    *values: Tokens,
    folder: Path = Path(),
    host: str = "127.0.0.1",
    port: Annotated[int | None, Parameter(validator=Number(gte=0, lte=65535))] = None,
    browser: bool = True,
) -> None:
    """Open the studio in the browser and watch a scenario run. Ctrl-C ends it.

    Parameters
    ----------
    scenario
        A preset's name, a scenario file, or the folder of a run, or of two that were saved together, to look
        at and go on with; without it the studio opens with its gallery of presets.
    folder
        Where runs are saved and opened; the current folder without it.
    host
        Address to serve at, 0.0.0.0 for all of this computer. Any other than its own lets others in who have
        the address with its token, or the link to watch that the studio shows; nothing is encrypted.
    port
        Port to serve at, 0 for any free one. Without it 8127, under which the browser finds preferences and
        bookmarks again, or a free one where that is taken.
    browser
        Open the browser.
    """
    from barchan.cli.terminal import console, print_note
    from barchan.scenario import load_scenario, preset_names
    from barchan.studio.server.gallery import showpiece
    from barchan.studio.server.launch import Studio, serve
    from barchan.studio.server.security import LOOPBACK
    from barchan.studio.server.together import moment

    overrides = pairs(values, studio)
    named = scenario or showpiece()
    folder_named = named not in preset_names() and Path(named).is_dir()
    source, is_run = _run_at(named) if folder_named else (named, False)
    is_run = is_run and not overrides
    chosen = None if is_run else load_scenario(source, overrides)
    archive = Path(scenario).resolve() if scenario and is_run else None
    if host not in LOOPBACK:
        print_note(
            f"others can reach the studio at {host}, and nothing is encrypted; whoever has the address below "
            "commands it: give others the link of File, Let others watch"
        )

    def ready(address: str) -> None:
        console.print(f"studio: {address}")
        console.print("Ctrl-C ends it")

    def left(found: "Found") -> None:
        for runs in found.runs.values():
            stopped = " and ".join(f"'{run.title or run.model}'" for run in runs.members)
            step = f"step {runs.members[0].step} on {moment(runs.saved)}"
            print_note(f"a run of {stopped} stopped unexpectedly at {step}; the studio's first page opens it")
        for text in found.broken:
            print_note(f"a run that the studio kept cannot be read and is left as it is: {text}")

    first = Studio(
        folder,
        chosen,
        archive,
        host,
        port,
        gallery=scenario is None,
        asked=scenario is not None or bool(overrides),
    )
    serve(first, ready, browser, left)


def _run_at(folder: str) -> tuple[str | Path, bool]:
    """Where the scenario in a folder stands, and whether there is a run to go on with."""
    from barchan.archive import source_at  # brings zarr, which a preset does without
    from barchan.archive.folder import CHECKPOINT
    from barchan.studio.server.together import is_together

    if is_together(Path(folder)):
        return folder, True
    source = source_at(folder)
    return source, isinstance(source, Path) and (source.parent / CHECKPOINT).is_file()
