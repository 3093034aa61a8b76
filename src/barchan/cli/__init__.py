"""The command line: one command a file, each loaded only when it is used."""

import sys

from cyclopts import App

from barchan.errors import BarchanError

COMMANDS = {
    "run": "Run a preset or a scenario, save it, and draw the last frame.",
    "studio": "Open the live laboratory in the browser.",
    "resume": "Go on with a run: after an interruption, beyond its last step, or into a branch.",
    "info": "Print the contents of a run, its progress, and the measures of its last frame.",
    "show": "Draw a frame of a run, a section, or its measures over time.",
    "film": "Write an animated picture of a run.",
    "export": "Write frames of a run for another program: GIS, ParaView, Blender, engines, printers, tables.",
    "measure": "Measure any surface: heights, crests, dunes; or the change between two dates of a place.",
    "sweep": "Run a scenario many times with values varied, on all cores or a cluster.",
    "compare": "Run models side by side on the same ground, wind and random numbers, and report on them.",
    "presets": "List the scenarios that ship with Barchan.",
    "parameters": "List every key of a scenario, with unit, default, bounds, meaning and source.",
    "wind": "Print and draw the effect of a wind on sand: roses, drift, the crests and dunes to expect.",
    "curves": "Draw the curves of a scenario's model, such as the winds that snow withstands.",
    "check": "Check a scenario without running it.",
    "schema": "Print the JSON schema of scenarios.",
}
"""Commands in the order in which ``--help`` lists them; each is the function of its name in its file."""

FAILED, INTERRUPTED = 1, 130


def app() -> App:
    """The command line, with commands that load when they are used."""
    from importlib.metadata import version

    root = App(
        name="barchan",
        help="Surfaces that wind shapes: dunes, ripples and snow bedforms, simulated.\n\n"
        "Start with **barchan run barchans**.",
        help_format="markdown",
        version=lambda: version("barchan"),
        default_parameter=None,
    )
    for place, (name, text) in enumerate(COMMANDS.items()):
        root.command(f"barchan.cli.{name}:{name}", name=name, help=text, sort_key=place)
    return root


def main() -> None:
    """Run the command line; an error that the user can mend is printed without a traceback."""
    try:
        code = app()(result_action="return_value")
    except BarchanError as error:
        print(f"barchan: {error}", file=sys.stderr)  # noqa: T201
        code = FAILED
    except BrokenPipeError:
        code = FAILED
    except KeyboardInterrupt:
        code = INTERRUPTED
    sys.exit(code if isinstance(code, int) else 0)
