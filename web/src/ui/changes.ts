/** The changes of parameters and wind, newest first, each of which can be undone. */

import type { App } from "../core/app";
import type { Change, Json } from "../core/protocol";
import { type Restart, same } from "../core/restarts";
import { changeWords, restartWords } from "./change_words";
import { h, short } from "./dom";

/** The list; ``restart`` puts a value back that restarts the run. */
export function changeList(app: App, restarts: Restart[], restart: (path: (string | number)[], value: Json) => void): HTMLElement {
  const live = app.current?.description?.changes ?? [];
  const rows = [
    ...live.toReversed().map((change) => row(`step ${short(change.step, 9)}: ${changeWords(app, change)}${putBack(live, change)}`, change.undo && (() => undo(app, change)))),
    ...restarts.toReversed().map((one) => row(`from the start: ${restartWords(app, one)}`, () => restart(one.path, one.before))),
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
  void app.ask(key === "wind" ? { command: "wind", wind: before, run } : { command: "set", key, value: before, run }, [key]).then((answer) => answer && app.notices.settle([key]));
}
