"""Measure everything and print it; with ``--write`` also into ``docs/benchmarks.md``."""

import argparse
import platform
import statistics
from collections.abc import Iterator
from pathlib import Path

from benchmarks import (
    exports,
    grains,
    kernel,
    lattices,
    measures,
    plain,
    program,
    shown,
    threads,
    trials,
    watched,
)

PAGE = Path(__file__).parents[1] / "docs" / "benchmarks.md"
NOTES = Path(__file__).with_name("notes.md")
"""Remarks that no case measures; the page ends with them."""

INTRODUCTION = """# How fast it is

Measured by `python -m benchmarks --write` on one core; millions a second, the median of five repetitions
with the slowest and the fastest in brackets (one repetition at 4096²). Each case starts from
a flat bed; unless it says otherwise it is Werner's model with three slabs a cell and hops of five cells, the
field has 256 × 256 cells for 400 steps, the wind blows from the west along the rows, the neighbourhood is von
Neumann's with two slabs of repose, and erosion in shadow is forbidden.
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="write docs/benchmarks.md")
    parser.add_argument("--only", default="", help="only cases whose name contains this")
    options = parser.parse_args()
    lines = []
    for line in report(options.only):
        print(line, flush=True)
        lines.append(line)
    if options.write:
        PAGE.write_text("\n".join([INTRODUCTION, *lines, "", NOTES.read_text()]))


def report(only: str) -> Iterator[str]:
    """The tables, line by line."""
    yield f"Machine: {_processor()}, Python {platform.python_version()}."
    yield ""
    yield "| case | polls | moved slabs | ns a poll |"
    yield "|---|---|---|---|"
    speeds = {}
    for case in kernel.CASES:
        if only in case.name:
            speeds[case.name] = speed = kernel.measure(case)
            cells = [case.name, _spread(speed.polls), _spread(speed.moves), f"{speed.nanoseconds_a_poll:.1f}"]
            yield f"| {' | '.join(cells)} |"
    if "256², 25 steps" in speeds and "4096², 25 steps" in speeds:
        yield ""
        for what in ("", ", no erosion in shadow"):
            large, small = speeds[f"4096², 25 steps{what}"], speeds[f"256², 25 steps{what}"]
            ratio = large.nanoseconds_a_poll / small.nanoseconds_a_poll
            yield f"A poll at 4096² costs {ratio:.2f} times one at 256²{what} (the same 25 steps from flat)."
    if not only or "threads".startswith(only):
        yield from _threads()
    for name, tables in {"lattices": lattices, "plain": plain, "trials": trials}.items():
        if not only or name.startswith(only):
            yield ""
            yield from tables.report()
    if not only or "grains".startswith(only):
        yield ""
        yield "| grains in flight | million updates/s, one thread | two | same bits |"
        yield "|---|---|---|---|"
        for name, preset, changes in grains.CASES:
            one, two, same = grains.updates(preset, changes)
            yield f"| {name} | {one:.0f} | {two:.0f} ({two / one:.2f} times) | {'yes' if same else 'no'} |"
        yield ""
        about = f"advances of some {grains.ITERATIONS} iterations, on one thread and on two in turns"
        yield f"Rates are the best of spells, {about}."
        yield ""
        seconds = grains.published_case_seconds()
        published = grains.PUBLISHED_SECONDS
        yield f"The 3000 iterations of Szabó 2019: {seconds:.1f} s, against {published:.0f} s there."
    yield from _of_frames(only)
    if not only:
        yield ""
        yield "| program | seconds |"
        yield "|---|---|"
        for name, seconds in program.measure().items():
            yield f"| {name} | {seconds:.2f} |"


def _of_frames(only: str) -> Iterator[str]:
    """Tables of what is done with single frames, and of a run that is watched and shown."""
    cases = {"export": exports, "measures": measures, "watched": watched, "shown": shown}
    for name, case in cases.items():
        if not only or name.startswith(only):
            yield from case.report()


def _threads() -> Iterator[str]:
    """Slabs on one thread and on two, and how many threads could be busy."""
    yield ""
    yield "| slabs on several threads | ns a poll, one thread | two | same bits |"
    yield "|---|---|---|---|"
    for case in threads.CASES:
        found = threads.measure(case)
        two = f"{found.two:.1f} ({found.one / found.two:.2f} times)"
        yield f"| {case.name} | {found.one:.1f} | {two} | {'yes' if found.same else 'no'} |"
    yield ""
    yield "| field, bands of 32 rows | bands | threads busy of 2 | of 8 | of 16 | of 64 |"
    yield "|---|---|---|---|---|---|"
    for size in (256, 1024, 4096, 8192):
        bands = size // 32
        of = [f"{threads.busy(bands, count, serial=0.012):.1f}" for count in (2, 8, 16, 64)]
        yield f"| {size}² | {bands} | {' | '.join(of)} |"
    yield ""
    yield "The last table is played through, not measured: bands of equal work, 1.2 % of it on one thread."


def _spread(values: list[float]) -> str:
    middle = statistics.median(values)
    return f"{middle:.1f}" if len(values) == 1 else f"{middle:.1f} ({min(values):.1f}–{max(values):.1f})"


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.is_file():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


if __name__ == "__main__":
    main()
