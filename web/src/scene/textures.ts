/** A field's heights, values and layers as textures on the graphics card. */

import * as THREE from "three";
import type { Run } from "../core/run";

export class FieldTextures {
  readonly heights: THREE.DataTexture;
  readonly values: THREE.DataTexture;
  readonly overlay: THREE.DataTexture;

  constructor(rows: number, columns: number, linear: boolean) {
    const count = rows * columns;
    const filter = linear ? THREE.LinearFilter : THREE.NearestFilter;
    const make = (data: Float32Array | Uint8Array, format: THREE.PixelFormat, type: THREE.TextureDataType) => {
      const texture = new THREE.DataTexture(data as never, columns, rows, format, type);
      texture.minFilter = texture.magFilter = type === THREE.UnsignedByteType ? THREE.LinearFilter : filter;
      return texture;
    };
    this.heights = make(new Float32Array(2 * count), THREE.RGFormat, THREE.FloatType);
    this.values = make(new Float32Array(count), THREE.RedFormat, THREE.FloatType);
    this.overlay = make(new Uint8Array(4 * count), THREE.RGBAFormat, THREE.UnsignedByteType);
  }

  fillHeights(surface: Float32Array, ground: Float32Array): void {
    const data = this.heights.image.data as Float32Array;
    for (let i = 0; i < surface.length; i++) {
      data[2 * i] = surface[i]!;
      data[2 * i + 1] = ground[i]!;
    }
    this.heights.needsUpdate = true;
  }

  fillValues(values: Float32Array): void {
    (this.values.image.data as Float32Array).set(values);
    this.values.needsUpdate = true;
  }

  /** The layers that are shown, four at most; returns how many. */
  fillOverlay(run: Run, names: string[]): number {
    const shown = names.filter((name) => run.fields.has(name)).slice(0, 4);
    const data = this.overlay.image.data as Uint8Array;
    data.fill(0);
    shown.forEach((name, layer) => {
      const field = run.fields.get(name)!;
      for (let i = 0; i < field.length; i++) data[4 * i + layer] = 255 * Math.min(Math.max(field[i]!, 0), 1);
    });
    this.overlay.needsUpdate = true;
    return shown.length;
  }

  dispose(): void {
    for (const texture of [this.heights, this.values, this.overlay]) texture.dispose();
  }
}

/** A colour map as a texture. */
export function mapTexture(colours: [number, number, number][]): THREE.DataTexture {
  const texture = new THREE.DataTexture(new Uint8Array(colours.flatMap((colour) => [...colour, 255])), colours.length, 1);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
