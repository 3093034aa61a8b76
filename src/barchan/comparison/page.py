"""Parts of a page in HTML that needs no other file: tables, pictures within the text, style for screen and print."""

import base64
from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path

STYLE = """
:root { --ink: #22201c; --pale: #6b645a; --line: #d8d0c2; --paper: #fffdf9; --sand: #f4ecdc; }
* { box-sizing: border-box; }
body { font: 15px/1.5 "Source Serif 4", Georgia, "Times New Roman", serif; color: var(--ink);
  background: var(--paper); margin: 0 auto; padding: 2.5rem 1.5rem 4rem; max-width: 66rem; }
h1, h2, h3, th, figcaption, .facts, nav { font-family: "Source Sans 3", "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 .6rem; padding-top: .5rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
p, li { max-width: 46rem; }
.lead { font-size: 1.08rem; color: var(--pale); margin-top: 0; }
nav { font-size: .9rem; margin: 1rem 0; } nav a { margin-right: 1.1em; } a { color: #35507a; }
table { border-collapse: collapse; font-size: .86rem; margin: .6rem 0 1rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .7rem; text-align: right; border-bottom: 1px solid var(--line); vertical-align: top; }
th { background: var(--sand); font-weight: 600; } th:first-child, td:first-child { text-align: left; padding-left: .3rem; }
td.text { text-align: left; } td.yes { font-weight: 700; } .scroll { overflow-x: auto; }
.unit, .quiet { color: var(--pale); font-size: .92em; }
figure { margin: .6rem 0; } figcaption { font-size: .82rem; color: var(--pale); }
img { max-width: 100%; height: auto; display: block; }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(19rem, 1fr)); gap: .8rem 1.2rem; align-items: end; }
code { font: .86em/1.4 "Source Code Pro", Menlo, Consolas, monospace; background: var(--sand); padding: .1em .3em; }
pre { background: var(--sand); padding: .7rem .9rem; overflow-x: auto; white-space: pre-wrap; } pre code { padding: 0; }
@page { size: A4; margin: 16mm 14mm; }
@media print {
  body { max-width: none; padding: 0; font-size: 10.5pt; background: white; }
  nav { display: none; } h2, h3 { break-after: avoid; } figure, tr { break-inside: avoid; }
  table { font-size: 8.5pt; } .scroll { overflow: visible; } th, td { padding: .2rem .4rem; }
  thead { display: table-header-group; } .variant { break-before: page; }
  .row { grid-template-columns: 1fr 1fr; } a { color: inherit; text-decoration: none; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
"""


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
    """A table; the cells of a ``wordy`` one stand to the left. A cell of ``Strong`` is set in bold."""
    head = "".join(f"<th>{text(cell)}</th>" for cell in heads)
    body = "".join(f"<tr>{''.join(_cell(cell, wordy) for cell in row)}</tr>" for row in rows)
    return f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


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


def page(title: str, *parts: str) -> str:
    """The whole page."""
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<style>{STYLE}</style></head>\n<body>{''.join(parts)}</body></html>\n"
    )
