/** Which values colour a surface, between which ends, with which colours. */

import type { App } from "../core/app";
import type { Field } from "../core/protocol";
import type { Run } from "../core/run";
import { slopes } from "./smooth";

export interface Colouring {
  values: Float32Array;
  limits: [number, number];
  map: string;
  title: string;
  unit: string;
  natural: boolean;
  choice: boolean;
}

/** The choice that shows a surface in its material's own colour. */
const NATURAL = "natural";

/** Fields that every run has, which the page computes itself. */
export const plainFields = (material: string): Field[] => [
  { name: NATURAL, unit: "", meaning: `${material}, as it looks`, centre: null, choice: false, of_layers: false },
  { name: "elevation", unit: "m", meaning: "elevation of the surface", centre: null, choice: false, of_layers: false },
  { name: "depth", unit: "m", meaning: `depth of the ${material}`, centre: null, choice: false, of_layers: false },
  { name: "slope", unit: "degrees", meaning: "slope of the surface", centre: null, choice: false, of_layers: false },
];

const OUTLIERS = 0.005;

export function colouring(app: App, run: Run, surface: Float32Array): Colouring {
  const look = app.view.look;
  const { lattice, fields, layers } = run.description!;
  const other = app.runs.find((one) => one !== run);
  if (look.side === "difference" && other?.ready && other.surface.length === surface.length) {
    return difference(run, other, app);
  }
  const plain = plainFields(run.material);
  const field = [...plain, ...fields].find((one) => one.name === look.field) ?? plain[0]!;
  const values = valuesOf(field.name, run, surface) ?? surface;
  const layer = layers.find((one) => one.field === field.name);
  const usual = field.centre !== null || field.choice || layer !== undefined;
  const own = field.choice ? "choice" : field.centre !== null ? "centred" : (layer?.colours ?? "perceptual");
  return {
    values,
    limits: look.limits ?? (field.choice ? [0, 1] : layer ? [0, 1] : endsOf(field.of_layers ? held(values, run.depth) : values, field)),
    map: look.map === "perceptual" || (usual && look.map !== "grey") ? own : look.map,
    title: field.meaning,
    unit: field.unit === "1" || field.unit === "-" ? "" : field.unit,
    natural: field.name === NATURAL,
    choice: field.choice,
  };

  function valuesOf(name: string, of: Run, height: Float32Array): Float32Array | undefined {
    if (name === NATURAL || name === "elevation") return height;
    if (name === "depth") return of.depth;
    if (name === "slope") return slopes(height, of.rows, of.columns, lattice.cell_size, lattice.periodic);
    return of.fields.get(name);
  }
}

function difference(run: Run, other: Run, app: App): Colouring {
  const [first, second] = run.name === "a" ? [run, other] : [other, run];
  const values = new Float32Array(run.surface.length);
  for (let i = 0; i < values.length; i++) values[i] = second.surface[i]! - first.surface[i]!;
    return {
    values,
    limits: app.view.look.limits ?? endsOf(values, { centre: 0 }),
    map: "centred",
    title: "elevation, right less left",
    unit: "m",
    natural: false,
    choice: false,
  };
}

/** Ends of a scale for nearly all values: elevations and depths as they are, others but for outliers. */
function endsOf(values: Float32Array, field: { name?: string; centre: number | null }): [number, number] {
  let [low, high] = extremes(values);
  if (field.centre !== null) {
    const sorted = sample(values);
    const at = (share: number) => sorted[Math.round(share * (sorted.length - 1))]!;
    const reach = Math.max(at(1 - OUTLIERS) - field.centre, field.centre - at(OUTLIERS));
    [low, high] = [field.centre - reach, field.centre + reach];
  }
  return high > low ? [low, high] : [low - 0.5, high + 0.5];
}

/** The values of cells that hold something; all where none does. */
function held(values: Float32Array, depth: Float32Array): Float32Array {
  const found = values.filter((_, i) => depth[i]! > 0);
  return found.length ? found : values;
}

function extremes(values: Float32Array): [number, number] {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}

function sample(values: Float32Array): Float32Array {
  const step = Math.max(1, Math.floor(values.length / 8192));
  const some = new Float32Array(Math.ceil(values.length / step));
  for (let i = 0; i < some.length; i++) some[i] = values[i * step]!;
  return some.sort();
}
