"""Parts of a page in HTML that needs no other file: tables, pictures within the text, its style."""

import base64
from collections.abc import Iterable, Sequence
from html import escape
from importlib.resources import files
from pathlib import Path


class Markup(str):
    """Text that is HTML already."""

    __slots__ = ()


def text(content: object) -> str:
    """Content as HTML: escaped, unless it is ``Markup``."""
    return content if isinstance(content, Markup) else escape(str(content))


def paragraph(content: object, kind: str = "") -> str:
    """A paragraph, of a class where stated."""
    return f"<p{_class(kind)}>{text(content)}</p>"


def table(heads: Sequence[object], rows: Iterable[Sequence[object]], wordy: bool = False) -> str:
    """A table; cells and headings of a ``wordy`` one stand to the left. A cell of ``Strong`` is in bold."""
    head = "".join(f"<th>{text(cell)}</th>" for cell in heads)
    body = "".join(f"<tr>{''.join(_cell(cell, wordy) for cell in row)}</tr>" for row in rows)
    kind = _class("wordy" * wordy)
    return (
        f'<div class="scroll"><table{kind}><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'
    )


class Strong(str):
    """The text of a cell to be set in bold."""

    __slots__ = ()


def _cell(cell: object, wordy: bool) -> str:
    kinds = " ".join(["text"] * wordy + ["yes"] * isinstance(cell, Strong))
    return f"<td{_class(kinds)}>{text(cell)}</td>"


def _class(kind: str) -> str:
    return f' class="{kind}"' if kind else ""


def figure(path: Path, caption: str) -> str:
    """A picture from a file, within the page."""
    content = base64.b64encode(path.read_bytes()).decode("ascii")
    picture = f'<img alt="{escape(caption, quote=True)}" src="data:image/png;base64,{content}">'
    return f"<figure>{picture}<figcaption>{escape(caption)}</figcaption></figure>"


def section(name: str, heading: str, *parts: str) -> str:
    """A section that links can lead to."""
    return f'<section id="{name}"><h2>{escape(heading)}</h2>{"".join(parts)}</section>'


def points(paragraphs: str) -> str:
    """Paragraphs with empty lines between, as a list."""
    return "<ul>" + "".join(f"<li>{text(one)}</li>" for one in paragraphs.strip().split("\n\n")) + "</ul>"


def page(title: str, *parts: str) -> str:
    """The whole page, with its style for screen and print."""
    style = files("barchan.comparison").joinpath("report.css").read_text("utf-8")
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<style>{style}</style></head>\n<body>{''.join(parts)}</body></html>\n"
    )
