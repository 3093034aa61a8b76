"""The code blocks of a page of Markdown."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

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
    """What stands after each ``$`` of a console block; a line that ends in ``\\`` goes on in the next."""
    whole = block.text.replace("\\\n", " ")
    yield from (line[2:].strip() for line in whole.splitlines() if line.startswith("$ "))
