/** Images as terrain: what they do not say themselves of heights and of the shape of the field. */

import type { JsonObject, Lattice } from "./protocol";
import type { Run } from "./run";

/** Suffixes of images that give heights. */
export const IMAGES = [".png", ".jpg", ".jpeg"];
/** Height of white over black at first, as a share of the field from west to east. */
const RISE = 0.08;
/** Relative difference of proportions that nobody sees. */
const UNSEEN = 0.02;
/** Distance of two rows of hexagons, in widths of a cell. */
const HEX_ROWS = Math.sqrt(0.75);
const LEAST_COLUMNS = 8;

export interface Heights {
  lowest: number;
  highest: number;
}

/** Columns and rows: of the pixels of an image, or of cells. */
export interface Size {
  columns: number;
  rows: number;
}

export const isImage = (name: string): boolean => IMAGES.some((suffix) => name.toLowerCase().endsWith(suffix));

/** Heights (m) of black and white at first: those of the image that the run lies on, so that both can be compared. */
export function usualHeights(run: Run): Heights {
  const { scenario, lattice } = run.description!;
  const { lowest, highest } = (scenario.ground ?? {}) as JsonObject;
  if (typeof lowest === "number" && typeof highest === "number") return { lowest, highest };
  return { lowest: 0, highest: Number((lattice.columns * lattice.cell_size * RISE).toPrecision(2)) };
}

/** Whether an image that is stretched over a field is seen to be. */
export function distorts(image: Size, field: Size, hexagons: boolean): boolean {
  const across = (image.columns / image.rows / field.columns) * field.rows * spacing(hexagons);
  return Math.abs(Math.log(across)) > UNSEEN;
}

/** A field in the proportions of an image, of about as many cells as there are. */
export function inProportion(image: Size, { rows, columns }: Pick<Lattice, "rows" | "columns">, hexagons: boolean): Size {
  const high = spacing(hexagons);
  const cells = Math.sqrt((columns * rows * high) / (image.columns * image.rows));
  const together = hexagons ? 2 : 1; // every second row of hexagons is shifted
  return {
    columns: Math.max(Math.round(image.columns * cells), LEAST_COLUMNS),
    rows: Math.max(Math.round((image.rows * cells) / high / together), 1) * together,
  };
}

const spacing = (hexagons: boolean): number => (hexagons ? HEX_ROWS : 1);

/** Columns and rows of an image's pixels; null where the browser cannot read it. */
export async function sizeOf(file: Blob): Promise<Size | null> {
  const address = URL.createObjectURL(file);
  const image = new Image();
  const read = new Promise<Size | null>((done) => {
    image.onload = () => done({ columns: image.naturalWidth, rows: image.naturalHeight });
    image.onerror = () => done(null);
  });
  image.src = address;
  return read.finally(() => URL.revokeObjectURL(address));
}
