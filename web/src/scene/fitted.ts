/** How far away a camera must be so that what it shows is in its view. */

import { narrowness } from "./narrow";

/** To the right of what a camera looks at, above it, and further away. */
export type Point = readonly [number, number, number];

/** Share of the view that the field may fill; the rest is for compass, scale bar and air. */
const FILLED = { across: 0.94, up: 0.86 };
/** Where there is room above and below, the field lies this share of it lower than the middle: there is more sky. */
const LOWER = 0.4;

/**
 * How far aside, up and away a camera must be so that all points (right, up, ahead) are just in view.
 *
 * A point at x and z ahead is in view from a distance d and a place s aside if |x - s| <= t (d + z), t being the
 * tangent of half the view's angle (degrees). The least d over all s is (A + B) / 2t, at s = (A - B) / 2, with A and B the
 * greatest x - t z and -x - t z.
 */
export function fitted(points: Point[], aspect: number, angle: number): { across: number; up: number; distance: number } {
  const tangent = Math.tan((angle * Math.PI) / 360);
  const along = (at: 0 | 1, t: number) => {
    const most = Math.max(...points.map((point) => point[at] - t * point[2]));
    const least = Math.max(...points.map((point) => -point[at] - t * point[2]));
    return { aside: (most - least) / 2, distance: (most + least) / (2 * t) };
  };
  const across = along(0, tangent * aspect * FILLED.across);
  const up = along(1, tangent * FILLED.up);
  const distance = Math.max(across.distance, up.distance);
  const spare = tangent * FILLED.up * (distance - up.distance);
  return { across: across.aside, up: up.aside + LOWER * narrowness(aspect) ** 2 * spare, distance };
}

/** The distance from which all points are in view of a camera that looks at their origin; of `filled` 1 they may reach its edges. */
export function distanceFor(points: Point[], aspect: number, angle: number, filled?: number): number {
  const tangent = Math.tan((angle * Math.PI) / 360);
  const [across, up] = [tangent * aspect * (filled ?? FILLED.across), tangent * (filled ?? FILLED.up)];
  return Math.max(...points.map(([x, y, z]) => Math.max(Math.abs(x) / across, Math.abs(y) / up) - z));
}

/** Half the height of a parallel view in which all points are seen around its middle. */
export function halfHeightFor(points: Point[], aspect: number, filled?: number): number {
  return Math.max(...points.map(([x, y]) => Math.max(Math.abs(y) / (filled ?? FILLED.up), Math.abs(x) / (filled ?? FILLED.across) / aspect)));
}
