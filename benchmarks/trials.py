"""What might make one thread faster, tried in the plain loop in C: each trial is a change of ``plain.c``.

A trial that gains nothing there cannot be expected to gain anything in the kernel, whose loop is the same.
"""

import statistics
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from barchan.lattice import Lattice
from barchan.models.werner import Werner
from benchmarks.plain import SOURCE, Case, by_loop, compiled, shadow_line

CASES = (Case(256, 100, True, 9), Case(256, 400, False, 9), Case(1024, 10, True, 9), Case(4096, 1, True, 5))

DRAW = (
    "  int64_t cols = f->cols, col = below(state >> 32, cols), "
    "row = first_row + below(state & 0xFFFFFFFF, rows);\n"
)
GIVEN = "uint64_t state, int32_t *peak) {\n"
LOOP = (
    "  for (int64_t k = 0; k < count; k++) "
    "moved += run_poll(f, first_row, rows, derive(key, poll + k), peak);\n"
)
AHEAD = """  enum { BLOCK = 256 };
  uint64_t states[BLOCK];
  int32_t own_rows[BLOCK], own_cols[BLOCK];
  int64_t cols = f->cols;
  for (int64_t k = 0; k < count; k++) {
    int64_t at = k % BLOCK;
    if (at == 0)
      for (int64_t n = 0; n < BLOCK; n++) {
        uint64_t drawn = derive(key, poll + k + n);
        states[n] = drawn;
        own_cols[n] = below(drawn >> 32, cols), own_rows[n] = first_row + below(drawn & 0xFFFFFFFF, rows);
      }
"""
RUN_DRAWN = "    moved += run_poll(f, own_rows[at], own_cols[at], states[at], peak);\n  }\n"
TAKE_DRAWN = (
    (
        "Field *f, int64_t first_row, int64_t rows, " + GIVEN + DRAW,
        "Field *f, int64_t row, int64_t col, " + GIVEN,
    ),
    (
        "  if (f->bed[row * cols + col] == 0) return 0;",
        "  int64_t cols = f->cols;\n  if (f->bed[row * cols + col] == 0) return 0;",
    ),
)
FETCH = """    if (at + 6 < BLOCK) {
      const int32_t *next = f->bed + own_rows[at + 6] * cols + own_cols[at + 6];
      __builtin_prefetch(next), __builtin_prefetch(next + cols), __builtin_prefetch(next - cols);
    }
"""
SHADOW_BY_SEARCH = (
    SOURCE.read_text().partition("static int in_shadow")[2].partition("/* The cell that changes")[0]
)
SHADOW_BY_LINE = """(const Field *f, int64_t row, int64_t col, int32_t peak) {
  return f->line[row * f->cols + col] > (int64_t)f->bed[row * f->cols + col] << 32;
}

/* Renew the height of the shadow line downwind of a cell, until it is what it was. */
static void renew(const Field *f, int64_t cell) {
  int64_t row = cell / f->cols * f->cols, col = cell - row;
  for (;;) {
    int64_t top = ((int64_t)f->bed[row + col] << 32) - f->first_fall, above = f->line[row + col] - f->fall;
    int64_t next = top > above ? top : above;
    col = col + 1 == f->cols ? 0 : col + 1;
    if (f->line[row + col] == next) return;
    f->line[row + col] = next;
  }
}

"""
FIELDS = "  int lee_erosion;\n} Field;"
GIVE, RECEIVE = (
    "  f->bed[end_of_slope(f, row, col, 1)]--;",
    "  if (++f->bed[cell] > *peak) *peak = f->bed[cell];",
)
BANDS = SOURCE.read_text().partition("    int64_t poll = 0;\n")[2].partition("  }\n  free(")[0]
TOGETHER = """    enum { MOST = MOST_BANDS };
    for (int64_t b = 0; b < bands;) {
      int64_t first[MOST], size[MOST], count[MOST], longest = 0;
      int n = 0;
      for (; n < MOST && b + n < bands; n++) {
        int far = 1;
        for (int m = 0; m < n; m++) {
          int64_t apart = llabs(order[b + n] - order[b + m]);
          far &= apart > 2 && bands - apart > 2;
        }
        if (!far) break;
        first[n] = order[b + n] * band_rows, count[n] = 0;
        size[n] = first[n] + band_rows < rows ? band_rows : rows - first[n];
        for (int64_t row = first[n]; row < first[n] + size[n]; row++) count[n] += row_polls[row];
        longest = count[n] > longest ? count[n] : longest;
      }
      int64_t polls[MOST];
      for (int m = 0; m < n; m++) polls[m] = poll, poll += count[m];
      uint64_t poll_key = derive(step_key, 0);
      for (int64_t k = 0; k < longest; k++) {
        RUN_TOGETHER
      }
      b += n;
    }
"""
IN_TURN = """for (int m = 0; m < n; m++)
          if (k < count[m])
            moved += run_poll(&f, first[m], size[m], derive(poll_key, polls[m] + k), &peak);"""
STAGES = """int64_t row[MOST], col[MOST];
        uint64_t state[MOST];
        int at_work[MOST];
        for (int m = 0; m < n; m++) {
          state[m] = derive(poll_key, polls[m] + k);
          col[m] = below(state[m] >> 32, cols), row[m] = first[m] + below(state[m] & 0xFFFFFFFF, size[m]);
        }
        for (int m = 0; m < n; m++) {
          at_work[m] = k < count[m] && f.bed[row[m] * cols + col[m]] > 0;
          if (at_work[m] && !f.lee_erosion) at_work[m] = !in_shadow(&f, row[m], col[m], peak);
        }
        for (int m = 0; m < n; m++)
          if (at_work[m]) f.bed[end_of_slope(&f, row[m], col[m], 1)]--, moved++;
        for (int hopping = 1; hopping;) {
          hopping = 0;
          for (int m = 0; m < n; m++)
            if (at_work[m] == 1) {
              col[m] += f.hop;
              if (col[m] >= cols) col[m] -= cols;
              state[m] += GOLDEN;
              uint64_t stays = f.bed[row[m] * cols + col[m]] > 0 ? f.on_sand : f.on_ground;
              if ((mix(state[m]) >> 32) < stays || in_shadow(&f, row[m], col[m], peak)) at_work[m] = 2;
              hopping |= at_work[m] == 1;
            }
        }
        for (int m = 0; m < n; m++)
          if (at_work[m]) {
            int64_t cell = end_of_slope(&f, row[m], col[m], -1);
            if (++f.bed[cell] > peak) peak = f.bed[cell];
          }"""
SETTLE = "(mix(state) >> 32) < stays || in_shadow(f, row, col, *peak)"
MADE = "on_sand, on_ground, lee_erosion};"
LINES = """on_sand, on_ground, lee_erosion, malloc(rows * cols * 8)};
  f.fall = FALL, f.first_fall = FIRST_FALL;
  for (int64_t c = 0; c < rows * cols; c++) f.line[c] = -((int64_t)1 << 60);
  for (int64_t c = 0; c < rows * cols; c++) renew(&f, c);"""


@dataclass(frozen=True)
class Trial:
    """A change of the loop: what is replaced by what."""

    name: str
    changes: tuple[tuple[str, str], ...]

    def source(self, fall: float, start: float) -> str:
        """The changed loop, for shadow lines that fall so many slabs a cell from their ``start``."""
        text = SOURCE.read_text()
        for old, new in self.changes:
            if old not in text:
                raise ValueError(f"{SOURCE.name} does not hold what the trial {self.name!r} changes: {old}")
            text = text.replace(old, new)
        numbers = {"FIRST_FALL": (1.0 - start) * fall, "FALL": fall}
        for name, number in numbers.items():
            text = text.replace(name, str(round(number * 2**32)))
        return text


def together(most: int, run: str) -> tuple[tuple[str, str], ...]:
    """The change that runs polls of up to ``most`` bands together that follow on each other, far apart."""
    return ((BANDS, TOGETHER.replace("RUN_TOGETHER", run).replace("MOST_BANDS", str(most))),)


TRIALS = (
    Trial("as it is", ()),
    Trial("random numbers of 256 polls drawn at once", ((LOOP, AHEAD + RUN_DRAWN), *TAKE_DRAWN)),
    Trial(
        "the same, cells of the sixth poll ahead fetched", ((LOOP, AHEAD + FETCH + RUN_DRAWN), *TAKE_DRAWN)
    ),
    Trial("polls of two bands in turn", together(2, IN_TURN)),
    Trial("polls of four bands in turn", together(4, IN_TURN)),
    Trial("polls of four bands at once, stage by stage", together(4, STAGES)),
    Trial("polls of eight bands at once, stage by stage", together(8, STAGES)),
    Trial("shadow tested also where chance holds the slab", ((SETTLE, SETTLE.replace("||", "|")),)),
    Trial(
        "stacks of 16 bits",
        (
            ("int32_t *bed", "int16_t *bed"),
            ("const int32_t *line", "const int16_t *line"),
        ),
    ),
    Trial(
        "a shadow line for each row, renewed with each slab",
        (
            (FIELDS, FIELDS.replace("} ", "  int64_t *line, fall, first_fall;\n} ")),
            (SHADOW_BY_SEARCH, SHADOW_BY_LINE),
            (
                GIVE,
                "  int64_t from = end_of_slope(f, row, col, 1);\n  f->bed[from]--;\n  renew(f, from);",
            ),
            (RECEIVE, RECEIVE + "\n  renew(f, cell);"),
            (MADE, LINES),
        ),
    ),
)


def report() -> Iterator[str]:
    """The table, line by line."""
    with tempfile.TemporaryDirectory() as folder:
        libraries = {}
        for number, trial in enumerate(TRIALS):
            place = Path(folder) / str(number)
            place.mkdir()
            source = place / SOURCE.name
            source.write_text(trial.source(*shadow_line(_model(CASES[0]))))
            libraries[trial] = compiled(str(place), source)
        if None in libraries.values():
            return
        yield f"| the plain loop in C, ns a poll | {' | '.join(case.name for case in CASES)} | same bits |"
        yield "|---" * (len(CASES) + 2) + "|"
        found = [_of_case(case, libraries) for case in CASES]
        for trial in TRIALS:
            times = [f"{of_case[trial][0]:.1f}" for of_case in found]
            same = all(of_case[trial][1] for of_case in found)
            yield f"| {trial.name} | {' | '.join(times)} | {'yes' if same else 'no'} |"


def _model(case: Case) -> Werner:
    lattice = Lattice(rows=case.size, columns=case.size)
    rules = Werner.Parameters(lee_erosion=case.lee_erosion, repose_angle=33.7, repose_test="after")
    return Werner(rules, lattice)


def _of_case(case: Case, libraries: dict) -> dict:
    """Of each trial the median of nanoseconds a poll, all in turns, and whether the bed is the usual one."""
    model, polls = _model(case), case.steps * case.size**2 / 1e9
    times, same = {trial: [] for trial in libraries}, dict.fromkeys(libraries, True)
    for _ in range(case.repetitions):
        usual = None
        for trial, library in libraries.items():
            kind = np.int16 if "16 bits" in trial.name else np.int32
            bed, seconds = by_loop(library, model, np.full(model.lattice.shape, 3, kind), case.steps)
            usual = bed if usual is None else usual
            same[trial] &= np.array_equal(bed, usual)
            times[trial].append(seconds / polls)
    return {trial: (statistics.median(of), same[trial]) for trial, of in times.items()}
