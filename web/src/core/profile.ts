/** The profile of a run along a section: surface, ground, shadow and slope along a line. */

import type { Run } from "./run";
import { type SectionLine, along, samples } from "./section";

/** Cells over which the slope is averaged: single slabs are steps. */
const SLOPE_CELLS = 2;

export interface Profile {
  distance: Float32Array;
  /** Metres from the south-west corner. */
  x: Float32Array;
  y: Float32Array;
  surface: Float32Array;
  ground: Float32Array;
  shadow: Float32Array | null;
  slope: Float32Array;
}

export function profile(run: Run, line: SectionLine): Profile {
  const lattice = run.description!.lattice;
  const places = samples(line, lattice);
  const surface = along(run.surface, places, lattice);
  const shadow = run.fields.get("shadow");
  return {
    distance: places.distance,
    x: places.x,
    y: places.y,
    surface,
    ground: along(run.ground, places, lattice),
    shadow: shadow ? along(shadow, places, lattice) : null,
    slope: slopeAlong(places.distance, surface, SLOPE_CELLS * lattice.cell_size),
  };
}

export function ends(values: Float32Array): [number, number] {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (const value of values) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return [low, high];
}

/** Slope along a profile (degrees, rising positive), over a length. */
function slopeAlong(distance: Float32Array, surface: Float32Array, over: number): Float32Array {
  const step = distance[1]! - distance[0]! || 1;
  const reach = Math.max(1, Math.round(over / 2 / step));
  return surface.map((_, i) => {
    const [a, b] = [Math.max(i - reach, 0), Math.min(i + reach, surface.length - 1)];
    return (Math.atan2(surface[b]! - surface[a]!, distance[b]! - distance[a]!) * 180) / Math.PI;
  });
}
