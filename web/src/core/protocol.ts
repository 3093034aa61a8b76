/** The messages of the server, and how frames are read. */

import type { Bookmark } from "./bookmarks";
import type { CommandName, MessageType } from "./commands";

const MAGIC = 0x48435242; // "BRCH"

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type JsonObject = { [key: string]: Json };
export type RunName = "a" | "b";

export interface Status {
  step: number;
  live: number;
  /** The step at which the run stops by itself. */
  end: number;
  running: boolean;
  finished: string | null;
  looking: boolean;
  can_branch: boolean;
  rate: number;
  /** Most steps per second; null where there is no limit. */
  limit: number | null;
  highest: number;
  /** Depth (m) of all layers where they are deepest. */
  deepest: number;
  volume: number;
  wind: number;
  /** Directions from which winds blew in the step. */
  winds: number;
  time: number | null;
  undo: number;
  redo: number;
  /** What was, came, went and is on the field, in whole units. */
  balance: Balance;
}

export interface Balance {
  unit: string;
  /** Mass of a unit (kg/m²), of layers that count masses. */
  mass: number | null;
  parts: Record<string, number>;
}

export interface Field {
  name: string;
  unit: string;
  meaning: string;
  centre: number | null;
  choice: boolean;
  /** Whether it has no value on bare ground. */
  of_layers: boolean;
}

export interface Lattice {
  rows: number;
  columns: number;
  cell_size: number;
  thickness: number;
  periodic: [boolean, boolean];
}

/** Where on Earth a field lies: easting and northing (m) of its south-west corner, and the reference system where it is known. */
export interface Place {
  west: number;
  south: number;
  crs: string | null;
}

export interface Measure {
  name: string;
  title: string;
  unit: string;
  /** What an angle is counted from. */
  reference: string;
}

/** Something that a brush paints: the keys of its strokes, and how strong it may be. */
export interface Brush {
  title: string;
  stroke: JsonObject;
  unit: string;
  least: number;
  most: number;
  usual: number;
  whole: boolean;
  /** What its user should know of it; empty where there is nothing. */
  note: string;
  /** Further numbers that its strokes take, such as a density. */
  numbers: BrushNumber[];
}

export interface BrushNumber {
  key: string;
  title: string;
  unit: string;
  least: number;
  most: number;
  usual: number;
}

/** Something that a section can show of the layers of a bed. */
export interface Strata {
  name: string;
  title: string;
  unit: string;
  /** Words for the values 0, 1 and so on. */
  states: string[];
}

export interface Description {
  scenario: JsonObject;
  lattice: Lattice;
  /** Null where the ground has no coordinates. */
  place: Place | null;
  model: { name: string; title: string; citation: string };
  models: Record<string, string>;
  /** The material that each model moves, by the model's name: sand, for instance. */
  materials: Record<string, string>;
  fields: Field[];
  /** What files for other programs may hold. */
  exported: { name: string; meaning: string }[];
  layers: { field: string; title: string; colours: string }[];
  brushes: Brush[];
  /** What a section can show of the layers; empty for a model that keeps none. */
  strata: Strata[];
  measures: Measure[];
  /** How long a step lasts (s); null where steps have no duration. */
  step_seconds: number | null;
  /** Steps from one measurement to the next at first, and rows until that doubles. */
  measured_every: number;
  measured_rows: number;
  /** Whether the model follows grains, whose paths can be shown. */
  paths: boolean;
  repose: number | null;
  /** The same as a difference of two neighbouring cells, in slabs. */
  repose_slabs: number | null;
  facts: Record<string, string>;
  remarks: string[];
  /** The branches of the run; the step where each began, and its last one. */
  branches: { number: number; began: number; step: number }[];
  /** The number of the present branch. */
  branch: number;
  events: number;
  /** The same for every run of the same scenario and seed. */
  identity: string;
  bookmarks: Bookmark[];
  /** The number of the start that loaded the scenario. */
  loaded: number;
  /** What was changed of the parameters and the wind during the run. */
  changes: Change[];
}

export interface Change {
  step: number;
  key: string;
  before: Json;
  value: Json;
  /** Whether it is the newest one of its key, and so can be undone. */
  undo: boolean;
  /** A wind in few words; empty for parameters. */
  summary: string;
}

/** The measures after a step, by name, and why some of them should not be quoted. */
export interface Row {
  step: number;
  values: Record<string, number | null>;
  doubts: Record<string, string>;
  /** Why nothing could be measured. */
  failed?: string;
  /** Whether the run was paused there, at no step of the fixed ones. */
  extra?: boolean;
}

export interface Problem {
  key: string;
  message: string;
  place: string;
}

export interface Message extends JsonObject {
  type: MessageType;
}

export interface Command extends JsonObject {
  command: CommandName;
}

interface EncodedField {
  name: string;
  dtype: "uint8" | "uint16" | "int32" | "float32";
  scale: number;
  offset: number;
}

export interface Frame {
  run: RunName;
  /** As of the description of the run that it shows. */
  loaded: number;
  rows: number;
  columns: number;
  status: Status;
  /** Beside the surface these are shown; those that a frame lacks are as they were. */
  shown: string[];
  history?: number[];
  measures?: Row[];
  /** Whether these measures replace all that came before. */
  measures_replaced?: boolean;
  /** Paths of grains: x, y and z (m) of each point after the other. */
  paths?: number[][];
  fields: Map<string, Float32Array>;
}

const ARRAYS = { uint8: Uint8Array, uint16: Uint16Array, int32: Int32Array, float32: Float32Array };

/** The fields of a binary frame as numbers in their units. */
export function readFrame(data: ArrayBuffer): Frame {
  const view = new DataView(data);
  if (view.getUint32(0, true) !== MAGIC) throw new Error("not a frame");
  const length = view.getUint32(4, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 8, length)));
  const count = header.rows * header.columns;
  const fields = new Map<string, Float32Array>();
  let at = 8 + padded(length);
  for (const field of header.encoded as EncodedField[]) {
    const numbers = new ARRAYS[field.dtype](data, at, count);
    at += padded(numbers.byteLength);
    fields.set(field.name, scaled(numbers, field.scale, field.offset));
  }
  return { ...header, fields };
}

function scaled(numbers: ArrayLike<number>, scale: number, offset: number): Float32Array {
  const values = new Float32Array(numbers.length);
  for (let i = 0; i < values.length; i++) values[i] = offset + scale * numbers[i]!;
  return values;
}

function padded(length: number): number {
  return (length + 3) & ~3;
}
