/** The JSON schema of scenarios, read for forms. */

import type { Json, JsonObject } from "./protocol";

export interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  type?: string;
  title?: string;
  description?: string;
  properties?: Record<string, Schema>;
  required?: string[];
  items?: Schema;
  anyOf?: Schema[];
  oneOf?: Schema[];
  allOf?: Schema[];
  discriminator?: { propertyName: string; mapping: Record<string, string> };
  enum?: Json[];
  const?: Json;
  default?: Json;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  unit?: string;
  source?: string;
  live?: boolean;
  group?: string;
  scale?: "linear" | "log";
}

/** A property as a form needs it. */
export interface Entry {
  schema: Schema;
  kind: "number" | "integer" | "boolean" | "text" | "choice" | "group" | "variant" | "list";
  /** Whether it may be left out. */
  nullable: boolean;
  choices: Json[];
  /** The key that distinguishes variants, and the variants by its values. */
  key: string;
  variants: Record<string, Schema>;
}

export function resolved(schema: Schema, root: Schema): Schema {
  if (!schema.$ref) return schema;
  const name = schema.$ref.split("/").at(-1)!;
  const { $ref: _, ...own } = schema;
  return { ...resolved(root.$defs?.[name] ?? {}, root), ...own };
}

export function entryOf(given: Schema, root: Schema): Entry {
  let schema = resolved(given, root);
  const entry: Entry = { schema, kind: "text", nullable: false, choices: [], key: "", variants: {} };
  if (schema.anyOf) {
    const options = schema.anyOf.map((option) => resolved(option, root));
    entry.nullable = options.some((option) => option.type === "null");
    const rest = options.filter((option) => option.type !== "null");
    const { anyOf: _, ...own } = schema;
    schema = { ...rest[0], ...own };
    if (rest.length > 1) return mixed(entry, schema, rest);
  }
  entry.schema = schema;
  if (schema.discriminator) {
    entry.kind = "variant";
    entry.key = schema.discriminator.propertyName;
    for (const [name, ref] of Object.entries(schema.discriminator.mapping)) {
      entry.variants[name] = resolved({ $ref: ref }, root);
    }
  } else if (schema.enum) {
    entry.kind = "choice";
    entry.choices = schema.enum;
  } else if (schema.const !== undefined) {
    entry.kind = "choice";
    entry.choices = [schema.const];
  } else if (schema.type === "object") entry.kind = "group";
  else if (schema.type === "array") entry.kind = "list";
  else if (schema.type === "number" || schema.type === "integer" || schema.type === "boolean") {
    entry.kind = schema.type;
  }
  return entry;
}

/** One of several words, or a number: shown as text that is read as JSON where it can be. */
function mixed(entry: Entry, schema: Schema, options: Schema[]): Entry {
  const choices = options.flatMap((option) => option.enum ?? (option.const !== undefined ? [option.const] : []));
  return { ...entry, schema, choices, kind: "text" };
}

/** The lowest and highest value that are allowed; null where there is none. */
export function bounds(schema: Schema): [number | null, number | null] {
  return [schema.minimum ?? schema.exclusiveMinimum ?? null, schema.maximum ?? schema.exclusiveMaximum ?? null];
}

/** An upper bound from here on guards against overflow; nobody comes near it. */
const BEYOND = 1e9;

/** The values that bounds allow, in words; empty where there are none. */
export function allowedIn(schema: Schema, told: (value: number) => string): string {
  const { minimum, exclusiveMinimum: above } = schema;
  const [maximum, below] = [schema.maximum, schema.exclusiveMaximum].map((one) => (one !== undefined && one < BEYOND ? one : undefined));
  const least = minimum !== undefined ? `from ${told(minimum)}` : above !== undefined ? `above ${told(above)}` : "";
  const most = maximum !== undefined ? `to ${told(maximum)}` : below !== undefined ? `below ${told(below)}` : "";
  if (least && most) return `${least} ${maximum !== undefined && minimum === undefined ? "up " : ""}${most}`;
  return least ? (minimum !== undefined ? `${least} on` : least) : most && (maximum !== undefined ? `up ${most}` : most);
}

/** A first value for something that has no default. */
export function initial(given: Schema, root: Schema): Json {
  const entry = entryOf(given, root);
  if (entry.schema.default !== undefined) return entry.schema.default;
  if (entry.nullable) return null;
  if (entry.kind === "number" || entry.kind === "integer") {
    const [low, high] = bounds(entry.schema);
    return Math.min(Math.max(0, entry.schema.exclusiveMinimum === 0 ? 1 : (low ?? 0)), high ?? 1e9);
  }
  if (entry.kind === "boolean") return false;
  if (entry.kind === "choice") return entry.choices[0] ?? null;
  if (entry.kind === "list") return [];
  if (entry.kind === "variant") {
    const [name, variant] = Object.entries(entry.variants)[0]!;
    return { ...(initial(variant, root) as JsonObject), [entry.key]: name };
  }
  if (entry.kind === "group") {
    const found: JsonObject = {};
    for (const name of entry.schema.required ?? []) {
      found[name] = initial(entry.schema.properties?.[name] ?? {}, root);
    }
    return found;
  }
  return "";
}

/** The schema of a value within nested data; undefined where there is none. */
export function schemaAt(root: Schema, data: Json, path: (string | number)[]): Schema | undefined {
  let schema: Schema | undefined = root;
  for (const [depth, step] of path.entries()) {
    const entry: Entry = entryOf(schema, root);
    const group = at(data, path.slice(0, depth)) as JsonObject | undefined | null;
    const own: Schema | undefined = entry.kind === "variant" ? entry.variants[String(group?.[entry.key])] : entry.schema;
    schema = typeof step === "number" ? own?.items : own?.properties?.[step];
    if (!schema) return undefined;
  }
  return entryOf(schema, root).schema;
}

/** A value within nested data. */
export function at(data: Json | undefined, path: (string | number)[]): Json | undefined {
  let found: Json | undefined = data;
  for (const step of path) found = (found as JsonObject | undefined | null)?.[step as string];
  return found;
}

/** Nested data with one value replaced. */
export function replaced(data: Json, path: (string | number)[], value: Json): Json {
  if (!path.length) return value;
  const [step, ...rest] = path as [string | number, ...(string | number)[]];
  if (Array.isArray(data)) {
    return data.map((item, index) => (index === step ? replaced(item, rest, value) : item));
  }
  const group = (data ?? {}) as JsonObject;
  return { ...group, [step]: replaced(group[step as string] ?? null, rest, value) };
}
