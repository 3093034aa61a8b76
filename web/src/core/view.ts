/** The settings of the view; kept in the browser from one visit to the next. */

import { Signal } from "./signal";
import { checked, keep, read } from "./stored";

export type Theme = "system" | "light" | "dark";

export interface Look {
  /** Which field colours the surface: natural (the material's own colour), elevation, depth, slope, or one that the model has. */
  field: string;
  map: "perceptual" | "grey" | "red-green";
  /** Fixed ends of the colour scale; null: those of the field as it is. */
  limits: [number, number] | null;
  /** Which sand: its colour where it is shown as it looks. */
  sand: "golden" | "white" | "red" | "dark";
  contours: "off" | "interval" | "count";
  interval: number;
  count: number;
  wireframe: boolean;
  /** Width of the smoothing (cells) of the surface as it is drawn; null: as suits the material. */
  smoothing: number | null;
  /** How much steeper heights are drawn; null: chosen from the relief. */
  exaggeration: number | null;
  bare: boolean;
  shadows: boolean;
  /** Degrees; null: across the crests that the wind makes, in the late afternoon. */
  sunAzimuth: number | null;
  sunHeight: number | null;
  /** Day or dusk; by the theme of the page unless one is chosen. */
  light: "theme" | "day" | "dusk";
  /** Whether colours of data are shaded by the relief. */
  shaded: boolean;
  /** Angle that the oblique view takes in from bottom to top (degrees): of a long lens it is small. */
  fieldOfView: number;
  /** Whether the view turns slowly while nobody moves it. */
  turning: boolean;
  /** Fine detail, or a plain scene; by itself where the graphics are slow. */
  quality: "automatic" | "full" | "plain";
  overlays: string[];
  /** Grains whose paths are shown. */
  paths: number;
  side: "surface" | "difference";
  theme: Theme;
}

const KEY = "barchan-look";
/** Of the kept settings: what a number in them means may change from one edition to the next. */
const EDITION = 2;

export const LOOK: Look = {
  field: "natural",
  map: "perceptual",
  limits: null,
  sand: "golden",
  contours: "off",
  interval: 1,
  count: 8,
  wireframe: false,
  smoothing: null,
  exaggeration: null,
  bare: true,
  shadows: true,
  sunAzimuth: null,
  sunHeight: null,
  light: "theme",
  shaded: true,
  fieldOfView: 21,
  turning: true,
  quality: "automatic",
  overlays: ["effectiveness"],
  paths: 20,
  side: "surface",
  theme: "system",
};

export const CHOICES = {
  map: ["perceptual", "grey", "red-green"],
  sand: ["golden", "white", "red", "dark"],
  contours: ["off", "interval", "count"],
  side: ["surface", "difference"],
  light: ["theme", "day", "dusk"],
  theme: ["system", "light", "dark"],
} as const;

export class View {
  readonly look: Look;
  readonly changed = new Signal<void>();
  /** Fields that other parts of the page need beside the coloured one. */
  readonly needed = new Set<string>();

  /** Settings that are kept in the browser from one visit to the next, or are those of `usual` each time. */
  constructor(private readonly usual?: Partial<Look>) {
    this.look = usual ? { ...LOOK, ...usual } : kept();
  }

  set(change: Partial<Look>): void {
    Object.assign(this.look, change);
    if (!this.usual) keep(KEY, { ...this.look, edition: EDITION });
    this.changed.send();
  }

  /** Show the surface as another window does; the browser does not keep that. */
  follow(look: Look): void {
    Object.assign(this.look, look);
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

/** The settings that the browser keeps. Those before edition 2 held the usual smoothing of all materials, 1, where nobody had chosen one. */
function kept(): Look {
  const found = read(KEY);
  const look = checked(found, LOOK, CHOICES);
  const early = (found as { edition?: unknown }).edition === undefined;
  return early && look.smoothing === 1 ? { ...look, smoothing: null } : look;
}
