/** What `barchan wind` tells of a wind: drift potential, threshold, crests and dunes to expect, and what makes them doubtful. */

import type { JsonObject } from "../core/protocol";
import { h } from "./dom";

export function windWords(answer: JsonObject, open: boolean): HTMLElement {
  const { rows, warnings, remarks } = answer as unknown as { rows: [string, string][]; warnings: string[]; remarks: string[] };
  const heading = answer.sand ? "drift potential, crests and dunes" : "the record";
  return h(
    rows.length ? "details" : "div",
    { id: "wind-words", ...(rows.length ? { open } : {}) },
    rows.length > 0 && h("summary", {}, heading),
    h("dl", { className: "facts" }, ...rows.map(([name, value]) => h("div", {}, h("dt", {}, name), h("dd", {}, value)))),
    ...warnings.map((text) => h("p", { className: "hint warned" }, text)),
    ...remarks.map((text) => h("p", { className: "hint" }, text)),
  );
}
