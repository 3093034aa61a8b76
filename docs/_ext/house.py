"""Draws the rooms of src/barchan from the contract of imports: ``python docs/_ext/house.py``."""

import tomllib
from html import escape
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1]
PICTURE = DOCS / "_static" / "house.svg"

ABOUT = {
    "cli": "command line",
    "notebook": "live view in a cell",
    "studio": "browser laboratory: server, workers, protocol",
    "accessor": "run.barchan",
    "bmi": "Basic Model Interface",
    "comparison": "models side by side, reports",
    "ensembles": "sweeps of runs",
    "survey": "any surface measured",
    "export": "files for other programs",
    "figures": "maps, sections, films",
    "entry": "load, simulate",
    "archive": "runs on disk",
    "analysis": "of runs",
    "theory": "expected of a wind",
    "simulation": "steps, events, ledger, state",
    "scenario": "a run as validated data",
    "models": "one published model a file",
    "snow": "layers that bond and pack",
    "slabs": "engine: slabs that hop",
    "grains": "engine: grains in flight",
    "plants": "species, layouts",
    "model": "contract of all models",
    "wind": "regimes, records, clock",
    "ground": "terrain, first sand",
    "aeolian": "physics of wind and sand",
    "heights": "surfaces in whole numbers",
    "squares": "hexagons on squares",
    "bed": "ground, layers, fields on a lattice",
    "streams": "random streams",
    "lattice": "cells and edges",
    "fields": "fields and layers declared",
    "checked": "arrays of models checked",
    "missing": "marks of no value",
    "measures": "spacing, crests, slopes",
    "parameters": "declared once",
    "kernels": "compiled loops, by subject",
    "image_files": "images, judged before they are unpacked",
    "udunits": "units in the words of CF",
    "words": "counts and names",
    "directions": "",
    "version": "",
    "errors": "",
    "replacing": "",
    "holding": "",
}

HOT = {"simulation", "models", "kernels"}
"""Rooms that are drawn darker."""

STYLE = """
  .room { fill: #f3ead8; stroke: #a9793a; } .hot { fill: #e9d3a8; }
  .name { fill: #3a2a12; font-size: 14px; font-weight: 600; }
  .about { fill: #5d4a2c; font-size: 12px; } .note { fill: #7a6a50; font-size: 12px; }
  .roof { fill: #d9b87a; stroke: #a9793a; }
  .arrow { stroke: #7a6a50; fill: none; stroke-width: 1.5; } .tip { fill: #7a6a50; }
  @media (prefers-color-scheme: dark) {
    .room { fill: #33291a; stroke: #b98d4e; } .hot { fill: #4a3817; } .name { fill: #f5e7cc; }
    .about { fill: #d8c6a3; } .note { fill: #bdae92; } .roof { fill: #6b5128; stroke: #b98d4e; }
    .arrow { stroke: #bdae92; } .tip { fill: #bdae92; }
  }
"""

LEFT, WIDTH, TOP, FLOOR, HEIGHT, GAP = 20, 650, 86, 35, 30, 5


def floors() -> list[list[str]]:
    """The rooms of each floor, from the top."""
    contracts = tomllib.loads((DOCS.parent / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"][
        "contracts"
    ]
    layers = next(one["layers"] for one in contracts if one["type"] == "layers" and "containers" not in one)
    return [[room.strip().removeprefix("barchan.") for room in layer.split("|")] for layer in layers]


def drawing() -> str:
    """The picture as SVG."""
    rooms = floors()
    bottom = TOP + FLOOR * len(rooms)
    label = "The rooms of src/barchan, one above the other: each imports only from the rooms below it"
    middle = LEFT + WIDTH / 2
    size = f'viewBox="0 0 760 {bottom + 34}" role="img" aria-label="{label}"'
    roof = f"M{LEFT} 80 L{middle} 14 L{LEFT + WIDTH} 80 Z"
    welcome = "import barchan: load, simulate, open_run …"
    turned = f"translate(716 {(90 + bottom) / 2}) rotate(90)"
    rule = "Rooms on one floor do not import each other."
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="system-ui, sans-serif">',
        f"<style>{STYLE}</style>",
        f'<path class="roof" d="{roof}"/>',
        f'<text class="name" x="{middle}" y="50" text-anchor="middle">src/barchan</text>',
        f'<text class="about" x="{middle}" y="68" text-anchor="middle">{welcome}</text>',
    ]
    for number, names in enumerate(rooms):
        wide = (WIDTH - GAP * (len(names) - 1)) / len(names)
        lines += [
            _room(name, LEFT + (wide + GAP) * k, TOP + FLOOR * number, wide) for k, name in enumerate(names)
        ]
    lines += [
        f'<path class="arrow" d="M696 90 V{bottom - 10}"/>',
        f'<path class="tip" d="M691 {bottom - 12} h10 l-5 10 z"/>',
        f'<text class="note" transform="{turned}" text-anchor="middle">imports point down</text>',
        f'<text class="note" x="{LEFT}" y="{bottom + 22}">{rule}</text>',
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def _room(name: str, x: float, y: float, wide: float) -> str:
    kind = "room hot" if name in HOT else "room"
    about = f'<tspan class="about" dx="10">{escape(ABOUT[name])}</tspan>' if ABOUT[name] else ""
    return (
        f'<rect class="{kind}" x="{x:g}" y="{y}" width="{wide:g}" height="{HEIGHT}" rx="3"/>\n'
        f'<text x="{x + 12:g}" y="{y + 20}"><tspan class="name">{name}</tspan>{about}</text>'
    )


if __name__ == "__main__":
    PICTURE.write_text(drawing(), "utf-8")
