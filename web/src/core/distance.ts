/** From one place of a surface to another: how far, how high, how steep, which way. */

import type { Run } from "./run";
import { type SectionLine, along, samples } from "./section";

export interface Distance {
  /** Metres on a map. */
  horizontal: number;
  /** Metres that the surface is higher at the second place; negative where it is lower. */
  rise: number;
  /** Metres along the profile of the surface. */
  surface: number;
  /** Degrees of the straight line between both places, rising positive; null for one place only. */
  slope: number | null;
  /** Degrees clockwise from north of the way from the first to the second; null for one place only. */
  azimuth: number | null;
}

/** Between the ends of a line over the surface itself, without smoothing or exaggeration. */
export function distance(run: Run, line: SectionLine): Distance {
  const { lattice } = run.description!;
  const places = samples(line, lattice);
  const heights = along(run.surface, places, lattice);
  const [east, north] = [line[2] - line[0], line[3] - line[1]];
  const horizontal = Math.hypot(east, north);
  const rise = heights.at(-1)! - heights[0]!;
  let surface = 0;
  for (let i = 1; i < heights.length; i++) surface += Math.hypot(places.distance[i]! - places.distance[i - 1]!, heights[i]! - heights[i - 1]!);
  const degrees = (radians: number) => (radians * 180) / Math.PI;
  return {
    horizontal,
    rise,
    surface,
    slope: horizontal > 0 ? degrees(Math.atan2(rise, horizontal)) : null,
    azimuth: horizontal > 0 ? (degrees(Math.atan2(east, north)) + 360) % 360 : null,
  };
}
