/** Two values of one parameter side by side: which other value, and how the two runs differ. */

import { labelOf } from "./labels";
import type { Json, JsonObject } from "./protocol";
import { type Entry, bounds } from "./schema";

/** A value to compare with: the default, or where that is the value now, another one that is allowed; null where there is none. */
export function otherValue(entry: Entry, value: Json): Json {
  const { schema } = entry;
  if (schema.default !== undefined && schema.default !== null && JSON.stringify(schema.default) !== JSON.stringify(value)) return schema.default;
  if (entry.kind === "boolean") return !value;
  if (entry.kind === "choice") return entry.choices.find((one) => one !== value) ?? null;
  if (typeof value !== "number") return null;
  const [low, high] = bounds(schema);
  const whole = (number: number) => (entry.kind === "integer" ? Math.round(number) : number);
  const [twice, half] = [whole(2 * value), whole(value / 2)];
  if (twice !== value && (high === null || twice <= high)) return twice;
  return half !== value && (low === null || half > low) ? half : null;
}

/** Keys and values in which one group differs from another, within groups as well, as words: `hop length 5`. */
export function differences(group: JsonObject, other: JsonObject, name = ""): string[] {
  return Object.keys(group).flatMap((key) => between(KINDS.has(key) && name ? name : key, group[key] ?? null, other[key] ?? null));
}

/** Keys that tell of what kind a group is, which is therefore called by its own name. */
const KINDS = new Set(["kind", "name"]);

function between(key: string, own: Json, other: Json): string[] {
  if (JSON.stringify(own) === JSON.stringify(other)) return [];
  const [inner, others] = [own, other].map(keyed);
  const found = inner && others ? differences(inner, others, key) : [];
  return found.length ? found : [`${labelOf(key)} ${shown(own)}`];
}

/** A group, or a list of groups, by keys; null for anything else. */
function keyed(value: Json): JsonObject | null {
  if (value === null || typeof value !== "object") return null;
  if (!Array.isArray(value)) return value;
  return !value.length || value.some((one) => keyed(one) === null) ? null : Object.fromEntries(value.map((one, at) => [String(at + 1), one]));
}

function shown(value: Json): string {
  if (typeof value === "number") return String(Number(value.toPrecision(6)));
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "on" : "off";
  if (typeof value === "string") return labelOf(value);
  if (!Array.isArray(value)) return String(value.kind ?? value.name ?? "given");
  return value.some((one) => one !== null && typeof one === "object") ? `of ${value.length}` : value.map(shown).join("/") || "none";
}
