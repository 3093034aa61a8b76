/** How materials, ground and plants look, in linear colours. */

type Colour = [number, number, number];

export interface MaterialLook {
  light: Colour;
  dark: Colour;
  /** The plain that the block stands on. */
  plain: Colour;
  /** Whether the wind draws ripples on it that are finer than a cell of a dune. */
  ripples: boolean;
}

const SAND: MaterialLook = { light: [0.71, 0.475, 0.255], dark: [0.55, 0.325, 0.155], plain: [0.43, 0.325, 0.225], ripples: true };
const SNOW: MaterialLook = { light: [0.86, 0.885, 0.92], dark: [0.76, 0.80, 0.86], plain: [0.60, 0.63, 0.68], ripples: false };

/** The look of a material; any that is not sand is nearly white. */
export const lookOf = (material: string): MaterialLook => (material === "sand" ? SAND : SNOW);

/** Plants of up to four species. */
export const TINTS: Colour[] = [
  [0.105, 0.125, 0.05],
  [0.23, 0.245, 0.065],
  [0.055, 0.135, 0.075],
  [0.20, 0.165, 0.055],
];

/** Cells below this (m) are of a size with the ripples themselves. */
export const RIPPLE_CELL = 0.1;
