/** The changes of parameters and wind, newest first, each of which can be undone. */

import type { App, Restart } from "../core/app";
import { spokenKey } from "../core/notices";
import type { Change, Json } from "../core/protocol";
import { h, short } from "./dom";

export const same = (a: Json | undefined, b: Json | undefined): boolean => JSON.stringify(a) === JSON.stringify(b);

/** The list; ``restart`` puts a value back that restarts the run. */
export function changeList(app: App, restarts: Restart[], restart: (path: (string | number)[], value: Json) => void): HTMLElement {
  const live = app.current?.description?.changes ?? [];
  const rows = [
    ...live.toReversed().map((change) => row(`step ${short(change.step, 9)}: ${told(change)}`, change.undo && (() => undo(app, change)))),
    ...restarts.toReversed().map(({ path, before, value }) => row(`from the start: ${spokenKey(path.join("."))} ${between(before, value)}`, () => restart(path, before))),
  ];
  if (!rows.length) return h("p", { className: "hint" }, "Nothing was changed since the scenario was loaded.");
  return h("ol", { className: "changes", reversed: true }, ...rows);
}

function row(text: string, act: (() => void) | false): HTMLElement {
  return h("li", {}, h("span", {}, text), act && h("button", { type: "button", title: `Undo: ${text}`, "aria-label": `undo ${text}`, onclick: act }, "undo"));
}

/** Set the value before again, from now on. */
function undo(app: App, { key, before }: Change): void {
  const run = app.selected;
  void app.ask(key === "wind" ? { command: "wind", wind: before, run } : { command: "set", key, value: before, run });
}

function told({ key, before, value, summary }: Change): string {
  return key === "wind" ? `wind ${summary}` : `${spokenKey(key)} ${between(before, value)}`;
}

function between(before: Json, value: Json): string {
  return `${shown(before)} → ${shown(value)}`;
}

function shown(value: Json): string {
  if (value === null) return "none";
  if (typeof value === "number") return short(value);
  if (typeof value !== "object") return String(value);
  const kind = Array.isArray(value) ? `${value.length} items` : (value.kind ?? value.name ?? "…");
  return String(kind);
}
