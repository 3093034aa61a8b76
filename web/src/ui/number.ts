/** The control of a number: a field, and a slider where the bounds make one useful. */

import type { Json } from "../core/protocol";
import { type Entry, type Schema, bounds } from "../core/schema";
import { h, later } from "./dom";
import { labelOf } from "../core/labels";
import { NumberField } from "./number_field";

export function numberControl(
  entry: Entry,
  value: Json,
  take: (value: Json) => void,
  mark: <T extends HTMLElement>(element: T) => T,
  path: (string | number)[],
): HTMLElement[] {
  const { schema } = entry;
  const whole = entry.kind === "integer";
  const input = new NumberField({
    value: typeof value === "number" ? value : null,
    whole,
    signed: (bounds(schema)[0] ?? -1) < 0,
    optional: true,
    take: (typed) => take(typed ?? (entry.nullable ? null : (schema.default ?? 0))),
    props: { placeholder: entry.nullable ? "none" : "" },
  });
  const range = sliderRange(schema, value);
  if (!range) return [mark(input.element)];
  const { from, to, log } = range;
  const place = (x: number) => (log ? Math.log(x / from) / Math.log(to / from) : (x - from) / (to - from));
  const number = (share: number) => {
    const raw = log ? from * (to / from) ** share : from + (to - from) * share;
    return whole ? Math.round(raw) : Number(raw.toPrecision(3));
  };
  const send = later(60, take);
  const slider = h("input", {
    type: "range",
    min: "0",
    max: "1",
    step: "any",
    value: String(place(Number(value))),
    "aria-label": labelOf(String(path.at(-1))),
    oninput: () => {
      input.show(number(Number(slider.value)));
      send(number(Number(slider.value)));
    },
  });
  slider.dataset.path = `${path.join(".")}~`;
  return [slider, mark(input.element)];
}

/** The range of a slider: the bounds, or without any a factor of ten around the default. */
function sliderRange(schema: Schema, value: Json): { from: number; to: number; log: boolean } | null {
  const [low, high] = bounds(schema);
  const usual = typeof schema.default === "number" ? schema.default : null;
  if (typeof value !== "number" || low === null || high === null) return null;
  if (schema.scale === "log" && usual !== null && usual > 0) {
    const from = Math.max(low, usual / 10) || usual / 10;
    const to = Math.min(high, usual * 10);
    return value >= from && value <= to ? { from, to, log: true } : null;
  }
  return high - low <= 1000 ? { from: low, to: high, log: false } : null;
}
