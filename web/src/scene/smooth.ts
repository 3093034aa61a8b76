/** Smoothing of fields for display only, and the slope of a surface. */

type Joined = [boolean, boolean];

/** A field smoothed like a Gaussian of a standard deviation of `width` cells. */
export function smoothed(field: Float32Array, rows: number, columns: number, width: number, joined: Joined) {
  // Each pass with weights s, 1 - 2 s, s adds a variance of 2 s.
  const passes = Math.ceil((width * width) / 0.5);
  if (passes < 1) return field;
  const side = (width * width) / passes / 2;
  let from = field;
  const spare = [new Float32Array(field.length), new Float32Array(field.length)];
  for (let pass = 0; pass < passes; pass++) {
    blurColumns(from, spare[0]!, rows, columns, side, joined[1]);
    blurRows(spare[0]!, spare[1]!, rows, columns, side, joined[0]);
    from = spare[1]!;
  }
  return from;
}

/**
 * A surface without the noise of single units, crests and slip faces as sharp as they are.
 *
 * Where a wide mean (a standard deviation of 2.6 `width` cells) is less than two units or so away from a narrow one
 * (0.7 `width`), what differs is noise, and the wide mean is drawn; where it is further away, there is a form.
 */
export function settled(field: Float32Array, rows: number, columns: number, width: number, unit: number, joined: Joined): Float32Array {
  if (width <= 0) return field;
  const narrow = smoothed(field, rows, columns, 0.7 * width, joined);
  let wide = narrow;
  const spare = [new Float32Array(field.length), new Float32Array(field.length), new Float32Array(field.length)];
  // Weights 1/4, 1/2, 1/4 at distances of 2 and 3 cells: variances of 2 and 4.5 beside the narrow one.
  [2, 3].forEach((distance, at) => {
    const reach = Math.max(1, Math.round(distance * width));
    spread(wide, spare[0]!, columns, 1, rows, columns, reach, joined[1]);
    spread(spare[0]!, spare[1 + at]!, rows, columns, columns, 1, reach, joined[0]);
    wide = spare[1 + at]!;
  });
  for (let i = 0; i < wide.length; i++) {
    const off = Math.abs(wide[i]! - narrow[i]!) / (2 * unit);
    const sharp = Math.min(off * off, 1);
    wide[i] = wide[i]! + sharp * (narrow[i]! - wide[i]!);
  }
  return wide;
}

/** Weights of 1/4, 1/2 and 1/4 at a distance, along lines of `count` cells that are `step` apart in memory. */
function spread(from: Float32Array, to: Float32Array, count: number, step: number, lines: number, between: number, reach: number, joined: boolean) {
  for (let line = 0; line < lines; line++) {
    const start = line * between;
    for (let i = 0; i < count; i++) {
      const back = i >= reach ? i - reach : joined ? (i - reach + count) % count : 0;
      const on = i + reach < count ? i + reach : joined ? (i + reach) % count : count - 1;
      to[start + i * step] = 0.5 * from[start + i * step]! + 0.25 * (from[start + back * step]! + from[start + on * step]!);
    }
  }
}

function blurColumns(from: Float32Array, to: Float32Array, rows: number, columns: number, side: number, joined: boolean) {
  const middle = 1 - 2 * side;
  for (let r = 0; r < rows; r++) {
    const row = r * columns;
    for (let c = 1; c < columns - 1; c++) {
      to[row + c] = middle * from[row + c]! + side * (from[row + c - 1]! + from[row + c + 1]!);
    }
    const first = from[row]!;
    const last = from[row + columns - 1]!;
    to[row] = middle * first + side * ((joined ? last : first) + from[row + 1]!);
    to[row + columns - 1] = middle * last + side * ((joined ? first : last) + from[row + columns - 2]!);
  }
}

function blurRows(from: Float32Array, to: Float32Array, rows: number, columns: number, side: number, joined: boolean) {
  const middle = 1 - 2 * side;
  for (let r = 0; r < rows; r++) {
    const below = (r > 0 ? r - 1 : joined ? rows - 1 : 0) * columns;
    const above = (r < rows - 1 ? r + 1 : joined ? 0 : rows - 1) * columns;
    const here = r * columns;
    for (let c = 0; c < columns; c++) {
      to[here + c] = middle * from[here + c]! + side * (from[below + c]! + from[above + c]!);
    }
  }
}

/** Slope of a surface (degrees) by central differences. */
export function slopes(surface: Float32Array, rows: number, columns: number, cell: number, joined: Joined): Float32Array {
  const found = new Float32Array(surface.length);
  const step = (at: number, by: number, size: number, closed: boolean) =>
    closed ? (at + by + size) % size : Math.min(Math.max(at + by, 0), size - 1);
  for (let r = 0; r < rows; r++) {
    const south = step(r, -1, rows, joined[0]);
    const north = step(r, 1, rows, joined[0]);
    const high = joined[0] || (r > 0 && r < rows - 1) ? 2 : 1;
    for (let c = 0; c < columns; c++) {
      const west = step(c, -1, columns, joined[1]);
      const east = step(c, 1, columns, joined[1]);
      const wide = joined[1] || (c > 0 && c < columns - 1) ? 2 : 1;
      const dx = (surface[r * columns + east]! - surface[r * columns + west]!) / (wide * cell);
      const dy = (surface[north * columns + c]! - surface[south * columns + c]!) / (high * cell);
      found[r * columns + c] = (Math.atan(Math.hypot(dx, dy)) * 180) / Math.PI;
    }
  }
  return found;
}
