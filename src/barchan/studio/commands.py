"""The table of commands: the name of each, who carries it out, and whether it needs a run.

Server and worker register their functions against this table; the names that the client uses are written
from it by ``python -m barchan.studio.commands``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, Literal, TypeVar

from barchan.errors import BarchanError
from barchan.studio.protocol import MESSAGES, PROTOCOL

CLIENT_FILE = Path(__file__).parents[3] / "web" / "src" / "core" / "commands.ts"
"""Where the client's names are written, in a checkout of the sources."""

Owner = Literal["worker", "session", "query"]

Pair = Literal["any time", "meeting", "pause"]
"""When two runs that are compared carry a command out: at any time, where they meet next, or paused there."""


@dataclass(frozen=True)
class Command:
    """A row of the table."""

    name: str
    owner: Owner
    """Who carries it out: a worker, the session, or a question that needs neither."""
    meaning: str
    needs_run: bool = True
    internal: bool = False
    """Whether only the server gives it, never the browser."""
    pair: Pair = "any time"


def _table(*commands: Command) -> dict[str, Command]:
    return {command.name: command for command in commands}


COMMANDS = _table(
    Command("attach", "worker", "A browser came; send it everything.", needs_run=False, internal=True),
    Command("start", "worker", "Start a scenario.", needs_run=False, internal=True),
    Command("open_folder", "worker", "Continue the run in a folder.", needs_run=False, internal=True),
    Command("resume", "worker", "Continue from a kept state.", needs_run=False, internal=True),
    Command("take_back", "worker", "Return to the run that was set aside for a pair.", internal=True),
    Command("keep", "worker", "Let the server keep the newest state.", internal=True),
    Command("keep_in", "worker", "Keep the newest state in a folder.", internal=True),
    Command("keep_aside_in", "worker", "Keep the state of the run set aside in a folder.", internal=True),
    Command("save_folder", "worker", "Save the run into a folder.", internal=True),
    Command("export_to", "worker", "Write kept states for another program.", internal=True),
    Command("space_time_to", "worker", "Write the section over time into a file.", internal=True),
    Command("report_to", "worker", "Write the comparison report of two saved runs.", internal=True),
    Command(
        "break_off", "worker", "Give up the work on the answer to a request.", needs_run=False, internal=True
    ),
    Command("confirm", "worker", "A frame was drawn; another one may follow.", needs_run=False),
    Command("view", "worker", "Choose the fields that frames carry beside the surface.", needs_run=False),
    Command("paths", "worker", "Choose how many paths of grains frames carry.", needs_run=False),
    Command("run", "worker", "Run: on and on, some steps, or up to a step."),
    Command("pause", "worker", "Pause."),
    Command("limit", "worker", "Limit the steps per second; null for no limit."),
    Command("restart", "worker", "Start again with the same scenario and seed.", pair="pause"),
    Command("set", "worker", "Give a live parameter a new value.", pair="meeting"),
    Command("wind", "worker", "Replace the wind.", pair="meeting"),
    Command("rose", "worker", "Ask for the roses of the wind."),
    Command("stroke", "worker", "Paint with a brush.", pair="meeting"),
    Command("undo", "worker", "Undo the last gesture of the brush.", pair="meeting"),
    Command("redo", "worker", "Repeat the gesture that was undone last.", pair="meeting"),
    Command("look", "worker", "Look back at a step; null for the newest state.", pair="pause"),
    Command("branch", "worker", "Continue from the state that is looked at.", pair="pause"),
    Command("switch", "worker", "Return to another branch.", pair="pause"),
    Command("bookmark", "worker", "Set bookmarks, or name known ones otherwise.", pair="meeting"),
    Command("unbookmark", "worker", "Remove a bookmark."),
    Command("visit", "worker", "Look at a bookmark's moment, on the branch that holds it.", pair="pause"),
    Command("measured", "worker", "Ask for the measures at every fixed step, and where the run rests."),
    Command("space_time", "worker", "Ask for the section along a line over the whole run."),
    Command("overlay", "worker", "Compare the surface with the terrain in a file; without a path with none."),
    Command("inspect", "worker", "Ask what a file of the session's folder holds: heights, or a record."),
    Command("strata", "worker", "Ask for the layers of the bed along a line, as it is looked at."),
    Command("create", "session", "Start a scenario, in both runs where two are compared.", needs_run=False),
    Command("compare", "session", "Set the run aside; start it and another model, or value, beside."),
    Command("alone", "session", "End the second run; return to the run as it was.", needs_run=False),
    Command("share_look", "session", "Show those who watch the surface in the same way.", needs_run=False),
    Command(
        "revive",
        "session",
        "Start lost runs again, at their beginning or from the kept state.",
        needs_run=False,
    ),
    Command("save", "session", "Save a run in the session's folder; of two that are compared one or both."),
    Command("export", "session", "Write a run for another program, as a file for the page to fetch."),
    Command("space_time_file", "session", "Write the section over time, as a file for the page to fetch."),
    Command("report", "session", "Write the comparison report of two runs, as a file for the page to fetch."),
    Command("cancel", "session", "Break off the answer to another request.", needs_run=False),
    Command(
        "open", "session", "Continue a run, or two saved together, of the session's folder.", needs_run=False
    ),
    Command(
        "open_unfinished",
        "session",
        "Go on with a run that the studio kept when it ended unexpectedly.",
        needs_run=False,
    ),
    Command("discard_unfinished", "session", "Delete such a run.", needs_run=False),
    Command("check", "query", "Ask what is wrong with a scenario's text.", needs_run=False),
    Command("preset", "query", "Ask for a preset's scenario.", needs_run=False),
    Command("variant", "query", "Ask for a group of a scenario with all its defaults.", needs_run=False),
    Command("saved", "query", "Ask for the names of the runs that can be opened.", needs_run=False),
)
"""Every command by its name."""

Function = TypeVar("Function", bound=Callable[..., object])


class Handlers(Generic[Function]):
    """The functions of one owner, by the names of their commands."""

    def __init__(self, owner: Owner) -> None:
        """Begin without any."""
        self.owner = owner
        self.functions: dict[str, Function] = {}

    def handles(self, name: str) -> Callable[[Function], Function]:
        """Register the decorated function; raises ValueError for a command of another owner, or one twice."""
        if COMMANDS[name].owner != self.owner or name in self.functions:
            raise ValueError(f"command '{name}' is not one of the {self.owner}, or has a function already")

        def register(function: Function) -> Function:
            self.functions[name] = function
            return function

        return register

    def __getitem__(self, name: str) -> Function:
        return self.functions[name]


def command_of(name: object, has_run: bool = True) -> Command:
    """The command of a name; raises BarchanError where there is none, or no run that it needs."""
    command = COMMANDS.get(name) if isinstance(name, str) else None
    if command is None:
        raise BarchanError(f"unknown command '{name}'")
    if command.needs_run and not has_run:
        raise BarchanError("there is no run yet")
    return command


def client_names() -> str:
    """The text of ``commands.ts``: version, names of commands, types of messages."""
    commands = {c.name: c.meaning for c in COMMANDS.values() if not c.internal}
    head = "/** Names that server and client share; written by `python -m barchan.studio.commands`. */"
    return "\n".join(
        (
            f"{head}\n\nexport const PROTOCOL = {PROTOCOL};\n",
            *_union("CommandName", commands),
            *_union("MessageType", MESSAGES),
        )
    )


def _union(name: str, members: dict[str, str]) -> list[str]:
    rows = [f'  /** {meaning} */\n  | "{member}"' for member, meaning in members.items()]
    return [f"export type {name} =", *rows[:-1], f"{rows[-1]};\n"]


if __name__ == "__main__":
    CLIENT_FILE.write_text(client_names(), "utf-8")
