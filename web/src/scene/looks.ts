/** How materials, ground and plants look, in linear colours. */

import type { Look } from "../core/view";

type Colour = [number, number, number];

export interface MaterialLook {
  light: Colour;
  dark: Colour;
  /** The plain that the block stands on. */
  plain: Colour;
  /** Whether the wind draws ripples on it that are finer than a cell of a dune. */
  ripples: boolean;
}

/** Widths (cells) of the usual smoothing: single slabs of sand are not to be seen, but the edges of snow are as sharp as they are drawn. */
const SMOOTHING = { sand: 1, snow: 0 };

/** Sands: of quartz, of gypsum (White Sands), of quartz under iron oxide (Simpson Desert), of basalt (Iceland, Mars). */
const SANDS: Record<Look["sand"], MaterialLook> = {
  golden: { light: [0.71, 0.475, 0.255], dark: [0.55, 0.325, 0.155], plain: [0.43, 0.325, 0.225], ripples: true },
  white: { light: [0.83, 0.79, 0.71], dark: [0.67, 0.63, 0.56], plain: [0.55, 0.50, 0.43], ripples: true },
  red: { light: [0.60, 0.235, 0.09], dark: [0.42, 0.135, 0.05], plain: [0.37, 0.19, 0.115], ripples: true },
  dark: { light: [0.165, 0.155, 0.15], dark: [0.085, 0.08, 0.082], plain: [0.20, 0.18, 0.165], ripples: true },
};
const SNOW: MaterialLook = { light: [0.86, 0.885, 0.92], dark: [0.76, 0.80, 0.86], plain: [0.60, 0.63, 0.68], ripples: false };

/** The look of a material, of one of the sands; any that is not sand is nearly white. */
export const lookOf = (material: string, sand: Look["sand"]): MaterialLook => (material === "sand" ? SANDS[sand] : SNOW);

/** The smoothing (cells) with which a material is drawn: the chosen one, or the usual one of the material. */
export const smoothingOf = (material: string, chosen: Look["smoothing"]): number => chosen ?? (material === "sand" ? SMOOTHING.sand : SMOOTHING.snow);

/** Plants of up to four species. */
export const TINTS: Colour[] = [
  [0.105, 0.125, 0.05],
  [0.23, 0.245, 0.065],
  [0.055, 0.135, 0.075],
  [0.20, 0.165, 0.055],
];

/** Cells below this (m) are of a size with the ripples themselves. */
export const RIPPLE_CELL = 0.1;
