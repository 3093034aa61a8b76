/** Views that are narrower than usual ones, as those of two runs side by side: the field is seen from farther away in them. */

/** Width over height of a view beside the panel on a usual screen. */
const USUAL = 1.6;

/** How wide a view is of a usual one, 1 at most: as much nearer the camera stands there to a field that fills the width. */
export function narrowness(aspect: number): number {
  return Math.min(aspect / USUAL, 1);
}
