/** How many times steeper than they are heights are drawn, where nobody has chosen it. */

/** Steepness (height over wavelength) of forms as they should be drawn, and the least that still shows them. */
const USUAL = 0.11;
const LEAST = 0.045;
/** No more than this, but for forms so flat that they would not be seen. */
const MOST = 4;
const FLATTEST = 20;
/** Relief (in units of the material) below which there is only noise. */
const NOISE = 3;
/** Relief as it is drawn, of the field's longer side, that is not gone beyond. */
const MOST_RELIEF = 0.2;

/**
 * Height over wavelength of a surface, from the spread of its slopes.
 *
 * A sine of height H and wavelength L has slopes of the standard deviation pi H / (sqrt(2) L).
 */
export function steepness(surface: Float32Array, rows: number, columns: number, cell: number): number {
  let sum = 0;
  let count = 0;
  const every = Math.max(1, Math.floor(Math.sqrt((rows * columns) / 65_536)));
  for (let r = 1; r < rows - 1; r += every) {
    for (let c = 1; c < columns - 1; c += every) {
      const at = r * columns + c;
      const dx = surface[at + 1]! - surface[at - 1]!;
      const dy = surface[at + columns]! - surface[at - columns]!;
      sum += dx * dx + dy * dy;
      count++;
    }
  }
  return (Math.SQRT2 / Math.PI) * (Math.sqrt(sum / Math.max(count, 1)) / (2 * cell));
}

/** The exaggeration for forms of a steepness and a relief (m), of a material that comes in units (m), on a field (m). */
export function usualExaggeration(steep: number, relief: number, unit: number, longer: number): number {
  const flat = Math.max(steep, 1e-6);
  const shows = relief < NOISE * unit ? MOST : Math.min(Math.max(MOST, LEAST / flat), FLATTEST);
  const fits = (MOST_RELIEF * longer) / Math.max(relief, 1e-9);
  const wanted = Math.min(Math.max(USUAL / flat, 1), shows, Math.max(fits, 1));
  return wanted < 3 ? Math.round(2 * wanted) / 2 : Math.round(wanted);
}
