/** The editor of a change in time, for every quantity that has one: a speed, a temperature, a snowfall. */

import type { Json, JsonObject } from "../core/protocol";
import type { Entry } from "../core/schema";
import { CurveEditor, type Ramp, STRAIGHT } from "./curve";
import { counted, h } from "./dom";
import { labelOf } from "../core/labels";

const SUFFIX = "_ramp";

/** Whether a parameter is a change in time that may be a curve. */
export function isRamp(entry: Entry): boolean {
  return entry.kind === "variant" && "linear" in entry.variants && "bezier" in entry.variants;
}

/** Whether a change can be drawn as one curve. */
export function isCurve(ramp: JsonObject | null): boolean {
  return ramp === null || ramp.kind === "linear" || ramp.kind === "bezier";
}

/** The editor of the change `name` within a group of values; a hint where it has no two values to go between. */
export function rampEditor(name: string, values: JsonObject, unit: string, take: (ramp: Json) => void): HTMLElement {
  const quantity = name.endsWith(SUFFIX) ? name.slice(0, -SUFFIX.length) : "";
  const first = values[quantity || "first"] ?? null;
  const last = values[quantity ? `final_${quantity}` : "last"] ?? null;
  const title = labelOf(quantity || "value");
  if (first === null || last === null) {
    const given = quantity ? `a ${title} and a final ${title}` : "a first and a last value";
    return h("p", { className: "hint" }, `Give ${given} to let it change along a curve.`);
  }
  const ramp = (values[name] ?? null) as JsonObject | null;
  const start = ramp?.kind === "bezier" ? (ramp as unknown as Ramp) : STRAIGHT;
  const labels = { of: title, from: `${first}${unit}`, to: `${last}${unit}`, duration: lasting(values) };
  return new CurveEditor(start, labels, (next) => take({ kind: "bezier", ...next })).element;
}

/** How long a change takes. */
export function lasting(values: JsonObject): string {
  const { seconds, steps } = values;
  if (seconds !== null && seconds !== undefined) return `${seconds} s`;
  return typeof steps === "number" ? counted(steps, "step") : "some steps";
}
