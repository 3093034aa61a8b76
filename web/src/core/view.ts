/** The settings of the view; kept in the browser from one visit to the next. */

import { Signal } from "./signal";
import { keep, stored } from "./stored";

export type Theme = "system" | "light" | "dark";

export interface Look {
  /** Which field colours the surface: natural (the material's own colour), elevation, depth, slope, or one that the model has. */
  field: string;
  map: "perceptual" | "grey" | "red-green";
  /** Fixed ends of the colour scale; null: those of the field as it is. */
  limits: [number, number] | null;
  contours: "off" | "interval" | "count";
  interval: number;
  count: number;
  wireframe: boolean;
  smoothing: number;
  /** How much steeper heights are drawn; null: as the slabs of the lattice ask for. */
  exaggeration: number | null;
  bare: boolean;
  shadows: boolean;
  sunAzimuth: number;
  sunHeight: number;
  overlays: string[];
  /** Grains whose paths are shown. */
  paths: number;
  side: "surface" | "difference";
  theme: Theme;
}

const KEY = "barchan-look";

export const LOOK: Look = {
  field: "natural",
  map: "perceptual",
  limits: null,
  contours: "off",
  interval: 1,
  count: 8,
  wireframe: false,
  smoothing: 0.8,
  exaggeration: null,
  bare: true,
  shadows: true,
  sunAzimuth: 315,
  sunHeight: 32,
  overlays: ["effectiveness"],
  paths: 20,
  side: "surface",
  theme: "system",
};

const CHOICES = {
  map: ["perceptual", "grey", "red-green"],
  contours: ["off", "interval", "count"],
  side: ["surface", "difference"],
  theme: ["system", "light", "dark"],
} as const;

export class View {
  readonly look: Look;
  readonly changed = new Signal<void>();
  /** Fields that other parts of the page need beside the coloured one. */
  readonly needed = new Set<string>();

  constructor() {
    this.look = stored(KEY, LOOK, CHOICES);
  }

  set(change: Partial<Look>): void {
    Object.assign(this.look, change);
    keep(KEY, this.look);
    this.changed.send();
  }

  /** Let a field be sent, or not any more. */
  need(name: string, wanted: boolean): void {
    if (this.needed.has(name) === wanted) return;
    if (wanted) this.needed.add(name);
    else this.needed.delete(name);
    this.changed.send();
  }

  fields(): string[] {
    return [...new Set([this.look.field, ...this.look.overlays, ...this.needed])].sort();
  }
}
