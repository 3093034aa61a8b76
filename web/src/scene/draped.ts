/** Pictures that are draped over a surface. */

import * as THREE from "three";
import type { App } from "../core/app";
import { ends } from "../core/profile";
import type { Run } from "../core/run";
import { hillShade } from "./hill_shade";

/** Pixels of a photograph along its longer side, at most; and of one that is read. */
const FINEST = 4096;
const MOST = 8192 * 8192;
/** Where the sun stands over the shaded map of a terrain (degrees), as on printed maps. */
const SUN = { azimuth: 315, height: 40 };
/** The relief of a terrain is drawn as steep as if it were this share of its length. */
const STEEP = 0.12;

const textures = new WeakMap<HTMLCanvasElement, THREE.CanvasTexture>();

/** A picture as a texture, made once. */
export function textureOf(image: HTMLCanvasElement): THREE.CanvasTexture {
  const known = textures.get(image);
  if (known) return known;
  const texture = new THREE.CanvasTexture(image);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.anisotropy = 4;
  textures.set(image, texture);
  return texture;
}

/** A photograph from a file, made smaller where it is larger than can be seen. Throws where the browser cannot read it. */
export async function photograph(file: Blob): Promise<HTMLCanvasElement> {
  const bitmap = await createImageBitmap(file).catch(() => {
    throw new Error("The browser cannot read this file as a photograph. Allowed: PNG, JPEG, WebP.");
  });
  const { width, height } = bitmap;
  if (width * height > MOST) throw new Error(`The photograph has ${width} × ${height} pixels. Allowed: at most 8192 × 8192.`);
  const share = Math.min(FINEST / Math.max(width, height), 1);
  const image = document.createElement("canvas");
  [image.width, image.height] = [Math.max(Math.round(width * share), 1), Math.max(Math.round(height * share), 1)];
  image.getContext("2d")!.drawImage(bitmap, 0, 0, image.width, image.height);
  bitmap.close();
  return image;
}

/** Heights (m) of a run's lattice as a shaded map in the colours of elevation. */
export function shadedMap(app: App, run: Run, heights: Float32Array): HTMLCanvasElement {
  const limits = ends(heights);
  const colours = { values: heights, limits, map: "perceptual", title: "", unit: "m", natural: false, choice: false, everywhere: true };
  const across = Math.max(run.columns, run.rows) * run.description!.lattice.cell_size;
  const steep = Math.max((STEEP * across) / Math.max(limits[1] - limits[0], 1e-9) / 4, 1);
  const image = document.createElement("canvas");
  [image.width, image.height] = [run.columns, run.rows];
  image.getContext("2d")!.putImageData(hillShade(app, run, heights, colours, steep, SUN, document.documentElement), 0, 0);
  return image;
}
