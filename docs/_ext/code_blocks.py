"""The code blocks of a page of Markdown, and how tests and tutorials run them."""

import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

_FENCE = re.compile(r"^(?P<fence>`{3,})(?P<language>[^`]*)$")
_MARK = re.compile(r"^<!--\s*(?P<text>not run|file:\s*(?P<name>\S+))\s*-->\s*$")


@dataclass(frozen=True)
class Block:
    """A fenced block and the remark in the comment before it, if any."""

    language: str
    text: str
    line: int
    """Number of its first line on the page."""
    run: bool
    file: str
    """Name of the file that the block is written to instead of being run."""


def blocks(page: Path) -> Iterator[Block]:
    """Fenced blocks of a page, in order; ``<!-- not run -->`` or ``<!-- file: x -->`` may precede one."""
    run, file, language, fence = True, "", "", ""
    inside: list[str] = []
    first = 0
    for number, line in enumerate(page.read_text("utf-8").splitlines(), start=1):
        opened, mark = _FENCE.match(line), _MARK.match(line)
        if fence:
            if line.strip() == fence:
                yield Block(language, "\n".join(inside) + "\n", first, run, file)
                run, file, fence = True, "", ""
            else:
                inside.append(line)
        elif mark:
            run, file = bool(mark["name"]), mark["name"] or ""
        elif opened:
            fence, language, inside, first = opened["fence"], opened["language"].strip(), [], number + 1
        elif line.strip():
            run, file = True, ""


def commands(block: Block) -> Iterator[str]:
    """The command after each ``$`` of a console block; a backslash at the end of a line continues it."""
    whole = block.text.replace("\\\n", " ")
    yield from (line[2:].strip() for line in whole.splitlines() if line.startswith("$ "))


def run_page(page: Path, folder: Path) -> None:
    """Run the blocks of a page one after the other in ``folder``, which is the working directory."""
    names: dict[str, Any] = {"__name__": "__main__"}
    for block in blocks(page):
        if block.file:
            (folder / block.file).write_text(block.text, "utf-8")
        elif block.run and block.language == "python":
            run_python(block, page, names)
        elif block.run and block.language == "console":
            run_console(block, page)


def run_python(block: Block, page: Path, names: dict[str, Any]) -> None:
    """Run a block so that errors name its page and line."""
    text = "\n" * (block.line - 1) + block.text
    exec(compile(text, str(page), "exec"), names)  # noqa: S102


def run_console(block: Block, page: Path) -> None:
    """Run the ``barchan`` commands of a block; others are left alone."""
    from barchan.cli import app

    for command in commands(block):
        program, *words = shlex.split(command, comments=True)
        if program == "barchan":
            code = app()(words, result_action="return_value")
            assert code in (None, 0), f"{page.name}:{block.line}: '{command}' returned {code}"
