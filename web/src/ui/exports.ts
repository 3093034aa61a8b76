/** Runs written for other programs: a sheet with every format of `barchan export`. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import { nameOfRun } from "../core/file_name";
import type { Command, Description, JsonObject } from "../core/protocol";
import { shownSteps } from "../core/run";
import { type Submit, formDialog } from "./dialog";
import { download, h } from "./dom";
import { NumberField } from "./number_field";

/** An option of a format, as the server lists it. */
export interface Option {
  name: string;
  kind: "number" | "whole" | "pair" | "flag" | "moment" | "field";
  title: string;
  meaning: string;
}

/** A format, as the server lists it. */
export interface Format {
  name: string;
  suffix: string;
  meaning: string;
  /** Whether all states go into one file. */
  series: boolean;
  /** Fields that a file holds. */
  fields: "one" | "many" | "none";
  options: Option[];
}

export async function exportRun(app: App): Promise<void> {
  new ExportSheet(app, await app.connection.fetch<Format[]>("formats"));
}

class ExportSheet {
  private readonly choice: HTMLSelectElement;
  private readonly states = h("select", { "aria-label": "States" });
  private readonly fields = h("div", { className: "checks" });
  private readonly chosenFields = h("details", {}, h("summary", {}, "fields"), h("p", { className: "hint" }, "Files name each as in brackets. None chosen: those that the format usually has."), this.fields);
  private readonly options = h("div", {});
  private readonly further = h("details", {}, h("summary", {}, "options"), this.options);
  private readonly name: HTMLInputElement;
  private read: () => JsonObject = () => ({});

  constructor(
    private readonly app: App,
    private readonly formats: Format[],
  ) {
    this.name = nameField(app);
    this.choice = h("select", { "aria-label": "Format", onchange: () => this.show() }, ...formats.map((one) => h("option", { value: one.name }, `${one.suffix}: ${one.meaning}`)));
    const row = (text: string, control: HTMLElement) => h("div", { className: "row" }, h("span", {}, text), control);
    formDialog("Export for other programs", "export", (progress, signal) => this.save(progress, signal), row("format", this.choice), row("states", this.states), this.chosenFields, this.further, row("name", this.name));
    this.show();
  }

  private get format(): Format {
    return this.formats.find((format) => format.name === this.choice.value)!;
  }

  private show(): void {
    const { series, fields, options } = this.format;
    const kept = shownSteps([this.app.current!]).length;
    const several = series ? `all ${kept} that are kept, in one file` : `all ${kept} that are kept, a file each`;
    const choices = [h("option", { value: "1" }, "the one that is shown"), h("option", { value: String(kept) }, several)];
    this.states.replaceChildren(...(series ? choices.reverse() : choices));
    this.chosenFields.hidden = fields === "none";
    const exported = this.app.current?.description?.exported ?? [];
    this.fields.replaceChildren(...exported.map(({ name, meaning }) => h("label", { className: "check" }, h("input", { type: "checkbox", value: name }), `${meaning} (${name})`)));
    this.further.hidden = options.length === 0;
    const rows = options.map((option) => optionRow(option, exported));
    this.options.replaceChildren(...rows.map(({ element }) => element));
    this.read = () => Object.assign({}, ...rows.map(({ value }) => value())) as JsonObject;
  }

  private async save(progress: Progress, signal: AbortSignal): Promise<void> {
    const { name, suffix, fields } = this.format;
    const chosen = fields === "none" ? [] : [...this.fields.querySelectorAll<HTMLInputElement>("input:checked")].map((box) => box.value);
    const what = { format: name, states: Number(this.states.value), options: this.read(), ...(chosen.length ? { fields: chosen } : {}) };
    const written = await fetchFile(this.app, { command: "export", name: `${this.name.value}${suffix}`, ...what, run: this.app.selected }, progress, signal);
    this.app.notices.confirm(`Exported ${written}; it is kept in studio-exports, with a file that tells what its numbers mean.`);
  }
}

/** A field for the name of a file, at first by the title of the run. */
export function nameField(app: App): HTMLInputElement {
  return h("input", { type: "text", value: nameOfRun(app.current), required: true, pattern: "[A-Za-z0-9_\\-]+", "aria-label": "Name of the file" });
}

/** The row of an option; its value is empty where it is left out. */
function optionRow({ name, kind, title, meaning }: Option, fields: Description["exported"]): { element: HTMLElement; value: () => JsonObject } {
  if (kind === "field") {
    const field = h("select", { "aria-label": title }, h("option", { value: "" }, "natural colours"), ...fields.map((one) => h("option", { value: one.name }, one.meaning)));
    return { element: h("div", { className: "row", title: meaning }, h("span", {}, title), field), value: () => (field.value ? { [name]: field.value } : {}) };
  }
  const row = (...controls: HTMLElement[]) => h("div", { className: "row", title: meaning }, h("span", {}, title), h("div", { className: "control" }, ...controls));
  if (kind === "flag" || kind === "moment") {
    const input = h("input", { type: kind === "flag" ? "checkbox" : "datetime-local", "aria-label": title });
    const given = () => (kind === "flag" ? input.checked : input.value);
    return { element: row(input), value: () => (given() ? { [name]: given() } : {}) };
  }
  const labels = kind === "pair" ? [`${title}: first`, `${title}: second`] : [title];
  const inputs = labels.map((label) => new NumberField({ label, optional: true, signed: true, whole: kind === "whole" }));
  const value = () => {
    const numbers = inputs.map(({ number }) => number);
    return numbers.some((number) => number !== null) ? { [name]: kind === "pair" ? numbers : numbers[0]! } : {};
  };
  return { element: row(...inputs.map(({ element }) => element)), value };
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
    app.notices.confirm(`Wrote ${name}; it is kept in studio-exports.`);
  };
  formDialog("Comparison report of both runs", "write the report", write, h("p", {}, text));
}
