/** Which values colour a surface, between which ends, with which colours. */

import type { App } from "../core/app";
import { ABOVE, OVERLAY } from "../core/overlay";
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
  /** Whether bare ground has its value as well, so that it must not be greyed. */
  everywhere: boolean;
}

/** The choice that shows a surface in its material's own colour. */
export const NATURAL = "natural";

/** Fields that every run has, which the page computes itself. */
export const plainFields = (material: string): Field[] => [
  { name: NATURAL, unit: "", meaning: `${material}, as it looks`, centre: null, choice: false, of_layers: false },
  { name: "elevation", unit: "m", meaning: "elevation", centre: null, choice: false, of_layers: false },
  { name: "depth", unit: "m", meaning: `depth of the ${material}`, centre: null, choice: false, of_layers: false },
  { name: "slope", unit: "degrees", meaning: "slope", centre: null, choice: false, of_layers: false },
];

const OUTLIERS = 0.005;

/** How a run is coloured. Two that show the same quantity have one scale, so that a colour means the same in both. */
export function colouring(app: App, run: Run): Colouring {
  const { side, limits } = app.view.look;
  const other = app.runs.find((one) => one !== run && one.ready);
  if (side === "difference" && other?.surface.length === run.surface.length) return difference(run, other, app);
  const own = alone(app, run);
  if (!other || limits || own.natural) return own;
  const second = alone(app, other);
  return sameQuantity(own, second) ? { ...own, limits: spanning(own.limits, second.limits) } : own;
}

/** Whether two surfaces are coloured by the same quantity, with the same colours. */
export function sameQuantity(one: Colouring, other: Colouring): boolean {
  return one.title === other.title && one.unit === other.unit && one.map === other.map;
}

function spanning([low, high]: [number, number], [least, most]: [number, number]): [number, number] {
  return [Math.min(low, least), Math.max(high, most)];
}

/** How a run is coloured that no other one stands beside. */
function alone(app: App, run: Run): Colouring {
  const look = app.view.look;
  const { lattice, fields, layers } = run.description!;
  const plain = plainFields(run.material);
  const field = [...plain, ...fields].find((one) => one.name === look.field) ?? plain[0]!;
  const values = valuesOf(field.name) ?? run.surface;
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
    everywhere: field.name === OVERLAY || field.name === ABOVE,
  };

  function valuesOf(name: string): Float32Array | undefined {
    if (name === NATURAL || name === "elevation") return run.surface;
    if (name === "depth") return run.depth;
    if (name === "slope") return slopes(run.surface, run.rows, run.columns, lattice.cell_size, lattice.periodic);
    return run.fields.get(name);
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
    everywhere: true,
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
