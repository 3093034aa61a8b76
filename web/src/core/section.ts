/** A straight section through a field: places along a line, and values there. */

import type { Lattice } from "./protocol";

/** From and to, in metres from the south-west corner. */
export type SectionLine = [number, number, number, number];

export interface Samples {
  /** Metres from the line's beginning. */
  distance: Float32Array;
  x: Float32Array;
  y: Float32Array;
}

/** Places along a line, about two to a cell. */
export function samples(line: SectionLine, lattice: Lattice): Samples {
  const [x0, y0, x1, y1] = line;
  const length = Math.hypot(x1 - x0, y1 - y0);
  const count = Math.min(Math.max(Math.round((2 * length) / lattice.cell_size), 2), 8192);
  const distance = new Float32Array(count);
  const x = new Float32Array(count);
  const y = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    const t = i / (count - 1);
    distance[i] = t * length;
    x[i] = x0 + t * (x1 - x0);
    y[i] = y0 + t * (y1 - y0);
  }
  return { distance, x, y };
}

/** Places along a line, one to a cell and half a cell from either end, for what is shown cell by cell. */
export function cellSamples([x0, y0, x1, y1]: SectionLine, lattice: Lattice): Samples {
  const length = Math.hypot(x1 - x0, y1 - y0);
  const count = Math.min(Math.max(Math.round(length / lattice.cell_size), 2), 8192);
  const shares = Array.from({ length: count }, (_, i) => (i + 0.5) / count);
  return {
    distance: Float32Array.from(shares, (t) => t * length),
    x: Float32Array.from(shares, (t) => x0 + t * (x1 - x0)),
    y: Float32Array.from(shares, (t) => y0 + t * (y1 - y0)),
  };
}

/** Values of a field in the cells that hold places. */
export function within(field: Float32Array, at: Samples, { rows, columns, cell_size: cell }: Lattice): Float32Array {
  const index = (place: number, count: number) => Math.min(Math.max(Math.floor(place / cell), 0), count - 1);
  return at.distance.map((_, i) => field[index(at.y[i]!, rows) * columns + index(at.x[i]!, columns)]!);
}

/** Values of a field at places, between cells in proportion. */
export function along(field: Float32Array, at: Samples, lattice: Lattice): Float32Array {
  const { rows, columns, cell_size: cell } = lattice;
  const values = new Float32Array(at.x.length);
  for (let i = 0; i < values.length; i++) {
    const c = Math.min(Math.max(at.x[i]! / cell - 0.5, 0), columns - 1);
    const r = Math.min(Math.max(at.y[i]! / cell - 0.5, 0), rows - 1);
    const c0 = Math.min(Math.floor(c), Math.max(columns - 2, 0));
    const r0 = Math.min(Math.floor(r), Math.max(rows - 2, 0));
    const [u, v] = [c - c0, r - r0];
    const c1 = Math.min(c0 + 1, columns - 1);
    const r1 = Math.min(r0 + 1, rows - 1);
    const south = field[r0 * columns + c0]! * (1 - u) + field[r0 * columns + c1]! * u;
    const north = field[r1 * columns + c0]! * (1 - u) + field[r1 * columns + c1]! * u;
    values[i] = south * (1 - v) + north * v;
  }
  return values;
}

/** The line along the wind through the centre of the field's middle cell, from edge to edge. */
export function alongWind(direction: number, { rows, columns, cell_size: cell }: Lattice): SectionLine {
  const angle = (direction * Math.PI) / 180;
  const steps = [-Math.sin(angle), -Math.cos(angle)].map((step) => (Math.abs(step) > 1e-9 ? step : 0));
  const middle = [columns, rows].map((count) => (Math.floor(count / 2) + 0.5) * cell);
  const sides = [columns * cell, rows * cell];
  const end = (sign: number): [number, number] => {
    const ways = steps.map((step, axis) => (step ? ((sign * step > 0 ? sides[axis]! : 0) - middle[axis]!) / (sign * step) : Number.POSITIVE_INFINITY));
    const reach = Math.min(...ways);
    return [middle[0]! + sign * steps[0]! * reach, middle[1]! + sign * steps[1]! * reach];
  };
  return [...end(-1), ...end(1)];
}
