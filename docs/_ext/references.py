"""The bibliography ``references.bib``: labels, the page that prints it, and links wherever a label stands.

A page of Markdown or a docstring says ``Werner 1995``, ``Werner (1995)`` or ``Werner, B. T. (1995)``; while
the documentation is built, such text becomes a link to the entry.
"""

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

BIB = Path(__file__).parents[1] / "references.bib"

_ENTRY = re.compile(r"^@(\w+)\{([\w-]+),\n(.*?)\n\}$", re.MULTILINE | re.DOTALL)
_FIELD = re.compile(r"^\s*(\w+) = \{(.*?)\},?$", re.MULTILINE)
_FENCE = re.compile(r"^(?P<fence>`{3,}|:{3,})(?P<what>.*)$")
_UNLINKED = r"(?P<unlinked>`+[^`]+`+|\$[^$\n]+\$|\[[^\]]*\]\([^)]*\)|^#.*$)"
"""Code, formulas, links and headings: labels in them stay as they are."""

_HEAD = """# References

The publications that the code, the presets and this documentation cite, by the labels that stand there. An
entry says where a rule or a number comes from, not that we could read the whole work; where we know only
a part of it, the entry says so. The same list as BibTeX: {download}`references.bib <../references.bib>`.

"""


@dataclass(frozen=True)
class Reference:
    """One publication."""

    key: str
    fields: dict[str, str]

    @property
    def authors(self) -> list[str]:
        """Authors as ``Family, I. N.``, in the order of the publication."""
        return [name for name in self.fields.get("author", "").split(" and ") if name]

    @property
    def names(self) -> str:
        """The names of its label: one, two, or the first of many."""
        families = [author.split(",")[0] for author in self.authors]
        return f"{families[0]} et al." if len(families) > 2 else " & ".join(families)

    @property
    def label(self) -> str:
        """The text by which code and documentation cite it."""
        return self.fields.get("label") or f"{self.names} {self.fields['year']}"

    def pattern(self) -> str:
        """A regular expression of the ways to cite it."""
        if "label" in self.fields:
            return _words(self.label)
        year = self.fields["year"]
        short = rf"{_words(self.names)}(?:'s)?,?\s+\(?{year}\b(?:(?<=\(\d{{4}})\))?"
        return rf"{short}|{_words(self.authors[0])}[^()]*?\({year}\)"

    def text(self) -> str:
        """The entry as Markdown."""
        f = self.fields
        authors = (
            ", ".join(self.authors[:-1]) + (" & " if self.authors[1:] else "") + "".join(self.authors[-1:])
        )
        parts = [f"{authors} ({f['year']})." if authors else "", f"{f['title']}."]
        parts += [f"({f['translation']}.)" if "translation" in f else "", f"{self.place()}."]
        parts += [f"[doi:{f['doi']}](https://doi.org/{f['doi']})." if "doi" in f else "", f.get("annote", "")]
        text = " ".join(filter(None, parts)).replace("--", "–").replace("``", "“").replace("''", "”")
        return f"({self.key})=\n**{self.label}**\n: {text}\n"

    def place(self) -> str:
        """Where it was published."""
        f = self.fields
        if "journal" in f:
            number = f"({f['number']})" if "number" in f else ""
            pages = f", {f['pages']}" if "pages" in f else ""
            return f"*{f['journal']}* {f['volume']}{number}{pages}"
        if "booktitle" in f:
            return f"In: {f['booktitle']}, {f['pages']}"
        stated = f.get("publisher") or f.get("howpublished") or f.get("institution")
        return stated or f"{f['type']}, {f['school']}"


@cache
def references() -> dict[str, Reference]:
    """All publications by label, in the order of their labels."""
    entries = [
        Reference(match[2], dict(_FIELD.findall(match[3])))
        for match in _ENTRY.finditer(BIB.read_text("utf-8"))
    ]
    return {entry.label: entry for entry in sorted(entries, key=_alphabetical)}


def cited(text: str) -> list[str]:
    """Labels of the publications that a text cites, in order."""
    return [entry.label for entry, _ in _found(text)]


def linked(text: str, form: str = "[{text}](#{key})") -> str:
    """The text with every citation made a link, in Markdown or as ``form`` says."""

    def link(match: re.Match[str]) -> str:
        entry = _entry(match)
        return form.format(text=match[0], key=entry.key) if entry else match[0]

    return _pattern().sub(link, text)


def linked_page(text: str) -> str:
    """A page of Markdown with its citations linked; code stays as it is."""
    return "".join(_linked_parts(text))


def references_page() -> str:
    """The bibliography as a page."""
    return _HEAD + "\n".join(entry.text() for entry in references().values())


def setup(app: Sphinx) -> dict[str, Any]:
    """Link citations of pages and docstrings while they are read."""
    app.connect("source-read", _link_source)
    app.connect("autodoc-process-docstring", _link_docstring)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _alphabetical(entry: Reference) -> str:
    return unicodedata.normalize("NFKD", entry.label).casefold()


def _words(text: str) -> str:
    return r"\s+".join(re.escape(word) for word in text.split())


@cache
def _pattern() -> re.Pattern[str]:
    ways = [f"(?P<e{at}>{entry.pattern()})" for at, entry in enumerate(references().values())]
    return re.compile("|".join([_UNLINKED, *(rf"\b{way}" for way in ways)]), re.MULTILINE)


def _entry(match: re.Match[str]) -> Reference | None:
    group = match.lastgroup or "unlinked"
    return None if group == "unlinked" else list(references().values())[int(group[1:])]


def _found(text: str) -> Iterator[tuple[Reference, str]]:
    for match in _pattern().finditer(text):
        if entry := _entry(match):
            yield entry, match[0]


def _linked_parts(text: str) -> Iterator[str]:
    prose: list[str] = []
    inside = opening = ""
    for line in text.splitlines(keepends=True):
        fence = _FENCE.match(line)
        if not fence:
            prose.append(line)
            continue
        yield _linked_part("".join(prose), opening)
        prose = []
        yield line
        closes = inside and fence["fence"].startswith(inside) and not fence["what"].strip()
        inside, opening = ("", "") if closes else (fence["fence"], fence["what"].strip())
    yield _linked_part("".join(prose), opening)


def _linked_part(text: str, opening: str) -> str:
    if opening == "{eval-rst}":
        return linked(text, ":ref:`{text} <{key}>`")
    prose = not opening or opening.split(" ", maxsplit=1)[0] in ("{list-table}", "{note}", "{tip}")
    return linked(text) if prose else text


def _link_source(_app: Sphinx, page: str, source: list[str]) -> None:
    if not page.endswith("references"):
        source[0] = linked_page(source[0])


def _link_docstring(
    _app: Sphinx, _kind: str, _name: str, _object: Any, _options: Any, lines: list[str]
) -> None:
    lines[:] = linked("\n".join(lines), ":ref:`{text} <{key}>`").split("\n")
