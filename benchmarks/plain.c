/* Werner's model (1995) on a flat periodic field with the wind along the rows, as a plain loop: the same rules and
   random numbers as Barchan's kernel, so the beds can be compared, and nothing but these rules. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define GOLDEN 0x9E3779B97F4A7C15ull

static uint64_t mix(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}
static uint64_t derive(uint64_t key, int64_t number) { return mix(key + GOLDEN * (uint64_t)(number + 1)); }
static int64_t below(uint64_t half, int64_t count) { return (int64_t)((half * (uint64_t)count) >> 32); }

typedef struct {
  int32_t *bed;
  const int32_t *falls; /* how far the shadow line has fallen d cells downwind, at d - 1 */
  int64_t rows, cols, band_rows, hop, limit;
  uint64_t on_sand, on_ground;
  int lee_erosion;
} Field;

static int in_shadow(const Field *f, int64_t row, int64_t col, int32_t peak) {
  const int32_t *line = f->bed + row * f->cols;
  int32_t here = line[col], rise = peak - here;
  for (int64_t d = 1; d <= f->cols && f->falls[d - 1] < rise; d++) {
    int64_t c = col - d;
    if (line[c < 0 ? c + f->cols : c] > f->falls[d - 1] + here) return 1;
  }
  return 0;
}

/* The cell that changes when a slab is taken (sign 1) or laid down (-1): up or down the steepest slope. */
static int64_t end_of_slope(const Field *f, int64_t row, int64_t col, int sign) {
  for (;;) {
    int64_t cols = f->cols, cell = row * cols + col;
    int32_t here = f->bed[cell] - sign, best = f->limit;
    int64_t north = row + 1 == f->rows ? 0 : row + 1, south = row == 0 ? f->rows - 1 : row - 1;
    int64_t east = col + 1 == cols ? 0 : col + 1, west = col == 0 ? cols - 1 : col - 1;
    int64_t first_row = row, first_col = sign > 0 ? west : east, last_col = sign > 0 ? east : west;
    int64_t next_rows[4] = {first_row, north, south, row}, next_cols[4] = {first_col, col, col, last_col};
    int found = -1;
    for (int k = 0; k < 4; k++) {
      int32_t step = (f->bed[next_rows[k] * cols + next_cols[k]] - here) * sign;
      if (step > best) best = step, found = k;
    }
    if (found < 0) return cell;
    row = next_rows[found], col = next_cols[found];
  }
}

/* One poll of a band; returns the number of slabs moved. */
static inline int64_t run_poll(Field *f, int64_t first_row, int64_t rows, uint64_t state, int32_t *peak) {
  int64_t cols = f->cols, col = below(state >> 32, cols), row = first_row + below(state & 0xFFFFFFFF, rows);
  if (f->bed[row * cols + col] == 0) return 0;
  if (!f->lee_erosion && in_shadow(f, row, col, *peak)) return 0;
  f->bed[end_of_slope(f, row, col, 1)]--;
  for (;;) {
    col += f->hop;
    if (col >= cols) col -= cols;
    state += GOLDEN;
    uint64_t stays = f->bed[row * cols + col] > 0 ? f->on_sand : f->on_ground;
    if ((mix(state) >> 32) < stays || in_shadow(f, row, col, *peak)) break;
  }
  int64_t cell = end_of_slope(f, row, col, -1);
  if (++f->bed[cell] > *peak) *peak = f->bed[cell];
  return 1;
}

/* Polls of a band; returns the number of slabs moved. */
static int64_t run_band(Field *f, int64_t first_row, int64_t rows, int64_t poll, int64_t count, uint64_t key,
                        int32_t *peak) {
  int64_t moved = 0;
  for (int64_t k = 0; k < count; k++) moved += run_poll(f, first_row, rows, derive(key, poll + k), peak);
  return moved;
}

int64_t run_steps(int32_t *bed, const int32_t *falls, int64_t rows, int64_t cols, int64_t band_rows, int64_t hop,
                  int64_t limit, uint64_t on_sand, uint64_t on_ground, int lee_erosion, uint64_t key, int64_t step,
                  int64_t steps) {
  Field f = {bed, falls, rows, cols, band_rows, hop, limit, on_sand, on_ground, lee_erosion};
  int64_t bands = (rows + band_rows - 1) / band_rows, cells = rows * cols, moved = 0;
  int64_t *row_polls = malloc(rows * sizeof *row_polls), *order = malloc(bands * sizeof *order);
  for (int64_t s = step; s < step + steps; s++) {
    uint64_t step_key = derive(key, s), row_key = derive(step_key, 1), order_key = derive(step_key, 2);
    memset(row_polls, 0, rows * sizeof *row_polls);
    for (int64_t pair = 0; pair < (cells + 1) / 2; pair++) {
      uint64_t draw = derive(row_key, pair);
      row_polls[below(draw >> 32, rows)]++;
      if (2 * pair + 1 < cells) row_polls[below(draw & 0xFFFFFFFF, rows)]++;
    }
    for (int64_t b = 0; b < bands; b++) order[b] = b;
    for (int64_t last = bands - 1; last > 0; last--) {
      int64_t other = below(derive(order_key, last) >> 32, last + 1), mine = order[last];
      order[last] = order[other], order[other] = mine;
    }
    int32_t peak = 0;
    for (int64_t c = 0; c < cells; c++) peak = bed[c] > peak ? bed[c] : peak;
    int64_t poll = 0;
    for (int64_t b = 0; b < bands; b++) {
      int64_t first = order[b] * band_rows, last = first + band_rows < rows ? first + band_rows : rows, count = 0;
      for (int64_t row = first; row < last; row++) count += row_polls[row];
      moved += run_band(&f, first, last - first, poll, count, derive(step_key, 0), &peak);
      poll += count;
    }
  }
  free(row_polls), free(order);
  return moved;
}
