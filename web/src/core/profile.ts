/** The profile of a run along a section: surface, ground, shadow and slope along a line. */

import type { Run } from "./run";
import { type SectionLine, along, cellSamples, samples, within } from "./section";

export interface Profile {
  /** Metres from end to end of the line. */
  length: number;
  /** Whether each point stands for a whole cell, as the layers of a bed are drawn. */
  cells: boolean;
  distance: Float32Array;
  /** Metres from the south-west corner. */
  x: Float32Array;
  y: Float32Array;
  surface: Float32Array;
  ground: Float32Array;
  shadow: Float32Array | null;
  /** Degrees from each point to the next, rising positive. */
  slope: Float32Array;
}

/** Whether a run's section shows whole cells, as the layers of its bed are drawn. */
export const showsCells = (run: Run): boolean => run.description!.strata.length > 0;

/** The profile along a line, in `cells` or between them. */
export function profile(run: Run, line: SectionLine, cells = showsCells(run)): Profile {
  const lattice = run.description!.lattice;
  const places = (cells ? cellSamples : samples)(line, lattice);
  const at = (field: Float32Array) => (cells ? within : along)(field, places, lattice);
  const surface = at(run.surface);
  const shadow = run.fields.get("shadow");
  return {
    length: Math.hypot(line[2] - line[0], line[3] - line[1]),
    cells,
    distance: places.distance,
    x: places.x,
    y: places.y,
    surface,
    ground: at(run.ground),
    shadow: shadow ? at(shadow) : null,
    slope: slopeAlong(places.distance, surface),
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

/** The point of a profile nearest to a distance along it. */
export function nearest({ distance }: Profile, to: number): number {
  const step = distance[1]! - distance[0]! || 1;
  return Math.min(Math.max(Math.round((to - distance[0]!) / step), 0), distance.length - 1);
}

/** Slope (degrees, rising positive) from each point to the next; of the last one, that of the one before. */
function slopeAlong(distance: Float32Array, surface: Float32Array): Float32Array {
  return surface.map((_, i) => {
    const from = Math.min(i, surface.length - 2);
    return (Math.atan2(surface[from + 1]! - surface[from]!, distance[from + 1]! - distance[from]! || 1) * 180) / Math.PI;
  });
}
