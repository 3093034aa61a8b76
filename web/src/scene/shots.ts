/** Pictures larger than a graphics card draws at once: in tiles, put together on a canvas. */

import type * as THREE from "three";
import type { Status } from "../core/protocol";
import type { Run } from "../core/run";
import { breath } from "./breath";

/** Pixels of a tile along a side, at most: every graphics card can do it, and even without one a page answers after some seconds. */
const TILE = 512;

/** What a picture shows and how large it is (pixels). */
export interface ShotOptions {
  width: number;
  height: number;
  /** Whether sky and plain are left out. */
  transparent?: boolean;
  /** Whether the lines of section and ruler are drawn. */
  lines?: boolean;
  /** Dusk or day; where it is missing, as the page. */
  dark?: boolean;
  /** Called after every tile with how many are done, and of how many; what it throws ends the picture. */
  progress?: (done: number, of: number) => void;
}

/** A picture, and what a scale bar and a compass on it need. */
export interface Shot {
  canvas: HTMLCanvasElement;
  /** Metres of the field that a pixel covers where the camera looks. */
  metresPerPixel: number;
  /** Direction the camera looks at, clockwise from north (radians). */
  heading: number;
  /** The status of each run as it was drawn; a run may have gone on since. */
  statuses: Map<Run, Status>;
}

type Viewport = [number, number, number, number];

export class Tiles {
  readonly canvas = document.createElement("canvas");

  /** Of `count` views side by side under one camera. */
  constructor(
    private readonly renderer: THREE.WebGLRenderer,
    private readonly camera: THREE.PerspectiveCamera | THREE.OrthographicCamera,
    private readonly width: number,
    private readonly height: number,
    private readonly count: number,
  ) {
    [this.canvas.width, this.canvas.height] = [width, height];
  }

  /** Draw all tiles with `paint`, which gets the number of the view; the page can answer between two of them. */
  async draw(paint: (view: number, viewport: Viewport) => void, progress?: (done: number, of: number) => void): Promise<void> {
    const context = this.canvas.getContext("2d")!;
    const tiles = this.tiles();
    const breathe = breath();
    const wide = Math.round(this.width / this.count);
    for (const [at, [view, x, y, w, h]] of tiles.entries()) {
      this.renderer.setPixelRatio(1);
      this.renderer.setSize(w, h, false);
      this.renderer.setScissorTest(false);
      this.renderer.setClearColor(0x000000, 0);
      this.renderer.clear();
      this.camera.setViewOffset(wide, this.height, x, y, w, h);
      paint(view, [0, 0, w, h]);
      context.drawImage(this.renderer.domElement, 0, 0, w, h, view * wide + x, y, w, h);
      await breathe();
      progress?.(at + 1, tiles.length);
    }
  }

  /** View, left, top, width and height of every tile. */
  private tiles(): [number, number, number, number, number][] {
    const wide = Math.round(this.width / this.count);
    const starts = (length: number) => Array.from({ length: Math.ceil(length / TILE) }, (_, at) => at * TILE);
    return Array.from({ length: this.count }, (_, view) => view).flatMap((view) =>
      starts(this.height).flatMap((y) => starts(wide).map((x): [number, number, number, number, number] => [view, x, y, Math.min(TILE, wide - x), Math.min(TILE, this.height - y)])),
    );
  }
}

/** A canvas as a PNG, or as a picture of another type. */
export function blobOf(canvas: HTMLCanvasElement, type = "image/png", quality = 1): Promise<Blob> {
  return new Promise((done, failed) => canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("The browser cannot make a picture of this size."))), type, quality));
}

/** A canvas as a JPEG, for a picture of a film: a tenth of a PNG, and made as much faster. */
export const jpegOf = (canvas: HTMLCanvasElement): Promise<Blob> => blobOf(canvas, "image/jpeg", 0.95);
