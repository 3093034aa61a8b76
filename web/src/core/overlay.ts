/** What is draped over the surface to compare it with: a photograph, or another terrain as a shaded map. */

import { Signal } from "./signal";

/** Fields that a run with a terrain over it has: the terrain's elevation, and that of the surface less it. */
export const OVERLAY = "overlay";
export const ABOVE = "above_overlay";

export class Overlay {
  /** The name of its file; empty where there is none. */
  name = "";
  /** Whether it has heights. */
  terrain = false;
  /** The picture, north at the top, over the whole field; null while the heights of a terrain are on their way. */
  image: HTMLCanvasElement | null = null;
  /** The lowest and the highest height (m) of a terrain, between which the colours of its map lie; null while they are on their way. */
  limits: [number, number] | null = null;
  /** From 0, nothing of it is seen, to 1. */
  opacity = 0.6;
  readonly changed = new Signal<void>();

  set(change: Partial<Pick<Overlay, "name" | "terrain" | "image" | "limits" | "opacity">>): void {
    Object.assign(this, change);
    this.changed.send();
  }
}
