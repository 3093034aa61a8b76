/** Runs written for other programs: a sheet with every format of `barchan export`. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import type { Command } from "../core/protocol";
import { plainFields } from "../scene/colouring";
import { type Submit, formDialog } from "./dialog";
import { download, h } from "./dom";

/** A format, as the server lists it. */
export interface Format {
  name: string;
  suffix: string;
  meaning: string;
  series: boolean;
  one_field: boolean;
  smooth: boolean;
}

const SMOOTHING = "Whole slabs make terraces in close views; smoothing takes them away and keeps the mean.";

export async function exportRun(app: App): Promise<void> {
  const formats = await app.connection.fetch<Format[]>("formats");
  const choice = h(
    "select",
    { "aria-label": "Format", onchange: () => show() },
    ...formats.map((one) => h("option", { value: one.name }, `${one.suffix}: ${one.meaning}`)),
  );
  const fields = [...plainFields(app.current?.material ?? "sand"), ...(app.current?.description?.fields ?? [])];
  const field = h("select", { "aria-label": "Field" }, ...fields.map((one) => h("option", { value: one.name }, one.meaning)));
  const smooth = h("input", { type: "number", min: "0", max: "20", step: "0.1", value: "0", "aria-label": "Smoothing in cells" });
  const name = h("input", { type: "text", value: "dunes", required: true, pattern: "[A-Za-z0-9_\\-]+", "aria-label": "Name of the file" });
  const told = h("p", { className: "hint" });
  const one = h("div", { className: "row" }, h("span", {}, "field"), field);
  const soft = h("div", { className: "row", title: SMOOTHING }, h("span", {}, "smoothing (cells)"), smooth);

  const chosen = () => formats.find((format) => format.name === choice.value)!;
  const show = () => {
    one.hidden = !chosen().one_field;
    soft.hidden = !chosen().smooth;
    told.textContent = chosen().series ? "All states that are kept, in one file." : "The state that is shown.";
  };
  const save: Submit = async (progress, signal) => {
    const format = chosen();
    const options = {
      ...(format.smooth && Number(smooth.value) > 0 ? { smooth: Number(smooth.value) } : {}),
      ...(format.one_field ? { fields: [field.value] } : {}),
    };
    const request = { command: "export" as const, name: `${name.value}${format.suffix}`, format: format.name, ...options, run: app.selected };
    const written = await fetchFile(app, request, progress, signal);
    app.note("info", `Exported ${written}; it is kept in studio-exports, with a file that tells what its numbers mean.`);
  };
  formDialog("Export for other programs", "export", save, h("div", { className: "row" }, h("span", {}, "format"), choice), one, soft, h("div", { className: "row" }, h("span", {}, "name"), name), told);
  show();
}

/** Let the server write a file, and give it to the user; returns its name. */
export async function fetchFile(app: App, request: Command, progress?: Progress, signal?: AbortSignal): Promise<string> {
  const answer = await app.connection.ask(request, progress, signal);
  const file = String(answer.file);
  const name = file.split("/").at(-1)!;
  download(name, await app.connection.file(`exports/${file}`));
  return name;
}

/** The last step at which both runs have a state, up to those that are shown. */
function lastCommon(app: App): number {
  const [first, second] = app.runs.map((run) => new Set([...run.history, run.status!.step]));
  const shown = Math.min(...app.runs.map((run) => run.status!.step));
  return Math.max(...[...first!].filter((step) => step <= shown && second!.has(step)));
}

/** The report that compares both runs, as `barchan compare` writes it of finished ones. */
export function reportSheet(app: App): void {
  if (app.runs.length < 2) {
    app.note("error", "A comparison report needs two runs: choose Compare with … first.");
    return;
  }
  const until = lastCommon(app);
  const text = `Maps, sections, slopes, differences and measures of both runs from the start to step ${until}, in one HTML file. Every kept state of both runs is measured for it, which can take minutes.`;
  const write: Submit = async (progress, signal) => {
    const name = await fetchFile(app, { command: "report", until }, progress, signal);
    app.note("info", `Wrote ${name}; it is kept in studio-exports.`);
  };
  formDialog("Comparison report of both runs", "write the report", write, h("p", {}, text));
}
