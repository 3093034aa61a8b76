"""Pages of the documentation from the results of studies: a scorecard, and one page a theme."""

import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

DOCS = Path(__file__).parents[1] / "docs"
RESULTS = Path(__file__).parent / "results"
FIGURES = DOCS / "_static" / "validation"
"""Figures of studies, drawn by ``figures``."""
PICTURES = Path(__file__).parent / "pictures.md"
"""Pictures of presets beside their sources, described by hand."""


@dataclass(frozen=True)
class Theme:
    """Studies that stand on one page."""

    name: str
    title: str
    about: str
    studies: tuple[str, ...]


THEMES = (
    Theme(
        "slab-rules",
        "Rules of slab transport",
        "Single rules of slab models, on and off: polling, erosion in shadow, hops, avalanches, rocks.",
        (
            *(
                "highest_stacks",
                "polling",
                "interdunes",
                "profiles",
                "hop_length",
                "hop_range",
                "sand_supply",
            ),
            *("coalescence", "first_surfaces", "rocks"),
        ),
    ),
    Theme(
        "models",
        "Models of slabs",
        "Models beyond Werner's: wind that speeds up, plants, shear stress, and the speed of their dunes.",
        (
            *(
                "speedup_stacks",
                "speedup_slopes",
                "stages",
                "tops",
                "saturation",
                "forced_bishop",
                "celerity",
            ),
            *("plants", "stress"),
        ),
    ),
    Theme(
        "winds",
        "Winds",
        "Winds that change: stars, crests under two winds, directions that spread, mixed axes.",
        ("stars", "star_windows", "orientation", "alternation", "spread", "mixed_axes"),
    ),
    Theme(
        "grains",
        "Grains in flight",
        "Ripples out of single grains: speed, growth and spacing, over terrain, with several sizes.",
        ("grown_ripples", "grain_drift", "grain_terrains", "grain_sizes"),
    ),
    Theme(
        "snow",
        "Snow",
        "Waves and dunes of snow, the greatest dune that moves, forms over wind and age, arrest and wear.",
        (
            *("snow_ranges", "snow_arrest", "snow_diagram", "snow_falling_wind", "snow_rest", "snow_retreat"),
            *("snow_order", "snow_sintering"),
        ),
    ),
    Theme(
        "nature",
        "Against nature",
        "Ratios and angles of simulated dunes beside those of dunes in the field.",
        ("against_nature",),
    ),
    Theme(
        "lattice",
        "Artefacts of the lattice",
        "Effects of the lattice: its axes, its neighbourhoods, and the order in which cells are polled.",
        (
            *("isotropy", "isotropy_hexagons", "isotropy_pairs", "isotropy_pairs_hexagons", "isotropy_wide"),
            "direction_quality",
            *("horn_symmetry", "heap_horns", "heap_horns_hexagons", "bands"),
        ),
    ),
)

INTRODUCTION = """# Validation

Published results beside Barchan's own. `python -m validation` runs every study, with 5 seeds unless the study
says otherwise; `python -m validation --pages` writes these pages from the results at hand. Numbers are mean ±
standard deviation over the seeds. Nothing is tuned to agree.

* A published number **agrees** when it lies within two standard deviations of our runs. A published order
  agrees when it holds in the runs of every seed.
* It **differs** when a number lies farther off, or when an order holds in no more than half of the seeds.
* All other published statements are **open**: most are in words or read from pictures, so they stand beside
  our numbers without a verdict. The text of the study says how they compare.
"""

VERDICTS = ("agrees", "differs", "open")

_NONE = ("", "-", "–")


@dataclass(frozen=True)
class Result:
    """A row of a study's table."""

    what: str
    published: str
    found: str
    verdict: str

    @property
    def judged(self) -> str:
        """``agrees``, ``differs``, ``open``, or nothing where nothing was published."""
        if self.published in _NONE:
            return ""
        if self.verdict.startswith(("agrees", "differs")):
            return self.verdict.split()[0]
        if apart := re.match(r"([\d.]+) standard errors apart", self.verdict):
            return "agrees" if float(apart[1]) < 2 else "differs"
        votes = re.match(r"(\d+) of (\d+) seeds", self.verdict)
        if not votes:
            return "open"
        if votes[1] == votes[2]:
            return "agrees"
        return "differs" if 2 * int(votes[1]) <= int(votes[2]) else "open"


@dataclass(frozen=True)
class Study:
    """A study as it was run."""

    name: str
    theme: Theme
    text: str

    @property
    def title(self) -> str:
        return self.text.splitlines()[0].removeprefix("## ")

    @property
    def illustrated(self) -> str:
        """The text with the figure of its table after that, where there is one."""
        path = FIGURES / f"{self.name}.svg"
        if not path.is_file():
            return self.text
        table = self.text.rindex("\n| ")
        end = self.text.find("\n", table + 1) + 1 or len(self.text)
        figure = f"\n![{self.title}: the numbers of the table](_static/validation/{path.name})\n"
        return self.text[:end] + figure + self.text[end:]

    @property
    def link(self) -> str:
        slug = re.sub(r"[^\w\- ]", "", self.title.lower()).replace(" ", "-")
        return f"{self.theme.name}.md#{slug}"

    @property
    def results(self) -> list[Result]:
        lines = [line for line in self.text.splitlines() if line.startswith("| ")][1:]
        return [Result(*(cell.strip() for cell in line[1:-1].split("|"))) for line in lines]


def studies() -> list[Study]:
    """All studies with results, in the order of the pages."""
    return [
        Study(name, theme, path.read_text("utf-8"))
        for theme in THEMES
        for name in theme.studies
        if (path := RESULTS / f"{name}.md").exists()
    ]


def write() -> None:
    """Write all pages."""
    for name, text in pages().items():
        path = DOCS / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, "utf-8")


def pages() -> dict[str, str]:
    """The scorecard and the page of each theme, by their names in the documentation."""
    known = studies()
    made = {"validation.md": scorecard(known)}
    for theme in THEMES:
        parts = [study.illustrated for study in known if study.theme == theme]
        text = "\n".join([f"# {theme.title}\n\n{theme.about}\n", *parts])
        made[f"validation/{theme.name}.md"] = _relinked(text, known)
    made["validation/pictures.md"] = _relinked(PICTURES.read_text("utf-8"), known)
    return made


def scorecard(known: list[Study]) -> str:
    """The first page: how many statements agree in each study, and every published number."""
    total = Counter(result.judged for study in known for result in study.results)
    count = (
        f"Of {sum(total[verdict] for verdict in VERDICTS)} comparisons {total['agrees']} agree, "
        f"{total['differs']} differ and {total['open']} are open; a statement counts once for each case that "
        "tests it.\n"
    )
    parts = [INTRODUCTION, count, "## Scorecard\n"]
    for theme in THEMES:
        own = [study for study in known if study.theme == theme]
        parts += [f"### {theme.title}\n", theme.about + "\n", _counts(own)]
    parts += [
        "## Published numbers\n",
        "Numbers that a source states for a run that Barchan repeats.\n",
        _numbers(known),
    ]
    parts += ["## Statements that differ\n", _differing(known)]
    names = "\n".join(f"validation/{name}" for name in (*(theme.name for theme in THEMES), "pictures"))
    parts += [f"```{{toctree}}\n:hidden:\n\n{names}\n```\n"]
    return "\n".join(parts)


def _counts(own: list[Study]) -> str:
    lines = ["| study | agrees | differs | open |", "|---|---:|---:|---:|"]
    for study in own:
        count = Counter(result.judged for result in study.results)
        cells = (str(count[verdict] or "") for verdict in VERDICTS)
        lines.append(f"| [{study.title}](validation/{study.link}) | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def _numbers(known: list[Study]) -> str:
    rows = [
        (result, study)
        for study in known
        for result in study.results
        if result.verdict.startswith(("agrees", "differs"))
    ]
    return _listed(rows)


def _differing(known: list[Study]) -> str:
    rows = [
        (result, study)
        for study in known
        for result in study.results
        if result.judged == "differs" and not result.verdict.startswith("differs")
    ]
    return _listed(rows)


def _listed(rows: list[tuple[Result, Study]]) -> str:
    lines = ["| statement | published | found | comes out | study |", "|---|---|---|---|---|"]
    lines += [
        f"| {r.what} | {r.published} | {r.found} | {r.verdict} | [{s.title}](validation/{s.link}) |"
        for r, s in rows
    ]
    return "\n".join(lines) + "\n"


def _relinked(text: str, known: list[Study]) -> str:
    """Links to studies by their heading, and to other pages, as seen from the folder of themes."""
    links = {study.link.split("#")[1]: study.link for study in known}
    text = re.sub(r"\]\(#([\w-]+)\)", lambda match: f"]({links[match[1]]})", text)
    themes = "|".join(theme.name for theme in THEMES)
    return re.sub(rf"\]\((?=\w+[./])(?!({themes})\.md)", "](../", text)
