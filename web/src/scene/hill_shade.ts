/** A shaded map of a surface, one pixel a cell, north at the top. */

import type { App } from "../core/app";
import type { Run } from "../core/run";
import { themeColour } from "../ui/dom";
import type { Colouring } from "./colouring";

type Colour = [number, number, number];

/** Light from the sky, which shadows keep. */
const SKY = 0.35;
/** How much brighter than level ground a slope towards the sun may be. */
const BRIGHTEST = 1.2;

export function hillShade(
  app: App,
  run: Run,
  surface: Float32Array,
  colours: Colouring,
  exaggeration: number,
  sun: { azimuth: number; height: number },
  host: Element,
): ImageData {
  const { rows, columns } = run;
  const cell = run.description!.lattice.cell_size;
  const image = new ImageData(columns, rows);
  const colour = colourOf(app, run, colours, host);
  const [azimuth, height] = [(sun.azimuth * Math.PI) / 180, (sun.height * Math.PI) / 180];
  const light = [Math.sin(azimuth) * Math.cos(height), Math.cos(azimuth) * Math.cos(height), Math.sin(height)] as const;
  for (let row = 0; row < rows; row++) {
    const [south, north] = [Math.max(row - 1, 0), Math.min(row + 1, rows - 1)];
    for (let column = 0; column < columns; column++) {
      const [west, east] = [Math.max(column - 1, 0), Math.min(column + 1, columns - 1)];
      const at = row * columns + column;
      const dx = ((surface[row * columns + east]! - surface[row * columns + west]!) * exaggeration) / ((east - west || 1) * cell);
      const dy = ((surface[north * columns + column]! - surface[south * columns + column]!) * exaggeration) / ((north - south || 1) * cell);
      const lit = Math.max((light[2] - dx * light[0] - dy * light[1]) / Math.hypot(dx, dy, 1), 0) / light[2];
      const shade = Math.min(SKY + (1 - SKY) * lit, BRIGHTEST);
      const [r, g, b] = colour(at);
      image.data.set([r * shade, g * shade, b * shade, 255], 4 * ((rows - 1 - row) * columns + column));
    }
  }
  return image;
}

/** The colour of a cell before it is lit: of the field that colours the surface, or of the material and what grows on it. */
function colourOf(app: App, run: Run, { values, limits: [low, high], map, natural }: Colouring, host: Element): (at: number) => Colour {
  const scale = app.colours[map] ?? [[128, 128, 128]];
  const along = (share: number): Colour => scale[Math.round(Math.min(Math.max(share, 0), 1) * (scale.length - 1))]!;
  if (!natural) return (at) => along((values[at]! - low) / (high - low));
  const [loose, rock] = [themed(run.material === "sand" ? "loose" : "snow", host), themed("rock", host)];
  const layers = run.description!.layers
    .filter(({ field }) => app.view.look.overlays.includes(field) && run.fields.has(field))
    .map(({ field, colours }) => ({ field: run.fields.get(field)!, colour: app.colours[colours]?.at(-1) ?? ([90, 110, 60] as Colour) }));
  return (at) => {
    const base = app.view.look.bare && run.depth[at] === 0 ? rock : loose;
    return layers.reduce<Colour>((under, { field, colour }) => mixed(under, colour, Math.min(Math.max(field[at]!, 0), 1)), base);
  };
}

function mixed(a: Colour, b: Colour, share: number): Colour {
  return [0, 1, 2].map((part) => a[part]! + (b[part]! - a[part]!) * share) as Colour;
}

/** A colour of the theme that is written as #rrggbb. */
function themed(name: string, host: Element): Colour {
  const number = Number.parseInt(themeColour(name, host).slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}
