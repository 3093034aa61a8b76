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

/** Keys and values in which one group differs from another, as words: `hop length 5`. */
export function differences(group: JsonObject, other: JsonObject): string[] {
  return Object.keys(group)
    .filter((key) => JSON.stringify(group[key]) !== JSON.stringify(other[key]))
    .map((key) => `${labelOf(key)} ${shown(group[key] ?? null)}`);
}

function shown(value: Json): string {
  if (typeof value === "number") return String(Number(value.toPrecision(4)));
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "on" : "off";
  return typeof value === "string" ? labelOf(value) : JSON.stringify(value);
}
