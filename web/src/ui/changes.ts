/** The changes of parameters and wind, newest first, each of which can be undone. */

import type { App } from "../core/app";
import { valueLabel } from "../core/labels";
import { spokenKey } from "../core/notices";
import type { Change, Json } from "../core/protocol";
import { type Restart, same } from "../core/restarts";
import { h, short } from "./dom";

/** The list; ``restart`` puts a value back that restarts the run. */
export function changeList(app: App, restarts: Restart[], restart: (path: (string | number)[], value: Json) => void): HTMLElement {
  const { changes: live = [], models = {} } = app.current?.description ?? {};
  const rows = [
    ...live.toReversed().map((change) => row(`step ${short(change.step, 9)}: ${told(change, models)}${putBack(live, change)}`, change.undo && (() => undo(app, change)))),
    ...restarts.toReversed().map(({ path, before, value }) => row(`from the start: ${spokenKey(path.join("."))} ${between(before, value, models)}`, () => restart(path, before))),
  ];
  if (!rows.length) return h("p", { className: "hint" }, "Nothing was changed since the scenario was loaded.");
  return h("ol", { className: "changes", reversed: true }, ...rows);
}

/** That a change gave a value back which another one had taken away first. */
function putBack(changes: Change[], { key, value }: Change): string {
  const first = changes.find((one) => one.key === key)!;
  return same(first.before, value) ? ", as it was at first" : "";
}

function row(text: string, act: (() => void) | false): HTMLElement {
  return h("li", {}, h("span", {}, text), act && h("button", { type: "button", title: `Undo: ${text}`, "aria-label": `undo ${text}`, onclick: act }, "undo"));
}

/** Set the value before again, from now on. */
function undo(app: App, { key, before }: Change): void {
  const run = app.selected;
  void app.ask(key === "wind" ? { command: "wind", wind: before, run } : { command: "set", key, value: before, run });
}

function told({ key, before, value, summary }: Change, models: Record<string, string>): string {
  return key === "wind" ? `wind ${summary}` : `${spokenKey(key)} ${between(before, value, models)}`;
}

function between(before: Json, value: Json, models: Record<string, string>): string {
  return `${shown(before, models)} → ${shown(value, models)}`;
}

function shown(value: Json, models: Record<string, string>): string {
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "on" : "off";
  if (typeof value === "string") return valueLabel(value, models);
  if (typeof value === "number") return short(value);
  if (typeof value !== "object") return String(value);
  const kind = Array.isArray(value) ? `${value.length} items` : (value.kind ?? value.name ?? "…");
  return valueLabel(String(kind), models);
}
