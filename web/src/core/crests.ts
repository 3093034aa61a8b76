/** Directions of crests, which have no beginning and no end: 179° and 1° are two degrees apart. */

/** Degrees that crests may be away from where they are expected before the plot is centred elsewhere. */
const AWAY = 55;

/** A direction (degrees) as that of its line which is nearest to a centre. */
export function nearest(direction: number, centre: number): number {
  return centre + ((((direction - centre + 90) % 180) + 180) % 180) - 90;
}

/** A direction as it is named: from 0 to 180. */
export function named(direction: number): number {
  return ((direction % 180) + 180) % 180;
}

/** Mean of directions of lines (degrees): the direction of the sum of unit vectors at twice the angle. */
export function meanOfLines(directions: number[]): number {
  const twice = directions.map((direction) => (direction * Math.PI) / 90);
  const [x, y] = [Math.cos, Math.sin].map((part) => twice.reduce((sum, angle) => sum + part(angle), 0)) as [number, number];
  return named((Math.atan2(y, x) * 90) / Math.PI);
}

/** The middle of a plot of crests: across the wind, or their mean where they lie elsewhere. */
export function centreOf(directions: number[], wind: number): number {
  const expected = named(wind + 90);
  if (!directions.length) return expected;
  const mean = meanOfLines(directions);
  return Math.abs(nearest(mean, expected) - expected) <= AWAY ? expected : Math.round(mean / 15) * 15;
}
