/** Directions of crests, which have no beginning and no end: 179° and 1° are two degrees apart. */

/** Degrees that the mean of crests may be away from the middle of their plot before that is moved. */
const AWAY = 45;
/** The middle of a plot is a multiple of these degrees, so that its marks are round. */
const ROUND = 15;
/** Degrees that such a plot reaches to either side: half a turn in all, or less where all crests are well within that. */
const WHOLE = 90;
const NARROW = 45;
const WELL = 40;

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

/**
 * The middle of a plot of crests: as it was `before` for as long as their mean is not far from it.
 *
 * At first it is across the wind. A wind that comes from several sides in turn does not move it, nor does a crest.
 */
export function centreOf(directions: number[], wind: number, before: number | null): number {
  const centre = before ?? Math.round(named(wind + 90) / ROUND) * ROUND;
  if (!directions.length) return centre;
  const mean = meanOfLines(directions);
  return Math.abs(nearest(mean, centre) - centre) <= AWAY ? centre : Math.round(mean / ROUND) * ROUND;
}

/** How far a plot of these crests reaches to either side of its middle. */
export function reachOf(directions: number[], centre: number): number {
  return directions.every((direction) => Math.abs(nearest(direction, centre) - centre) <= WELL) ? NARROW : WHOLE;
}

/** The marks of a plot around a middle; those at both ends of half a turn are the same direction. */
export function crestMarks(centre: number, reach: number): number[] {
  const step = reach === WHOLE ? 45 : 30;
  const first = Math.ceil((centre - reach) / step) * step;
  return Array.from({ length: 5 }, (_, at) => first + at * step).filter((mark) => mark <= centre + reach);
}
