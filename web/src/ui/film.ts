/** A film of what was just seen: of the states of the run that are kept, drawn by the server as shaded maps. */

import type { App } from "../core/app";
import type { Format } from "./exports";
import { fetchFile } from "./exports";
import { type Submit, formDialog } from "./dialog";
import { h, short } from "./dom";

/** Frames a second at first, and the longer side of the picture (pixels) to choose from. */
const RATE = 12;
const SIZES = [512, 1024, 1920];

export async function filmSheet(app: App): Promise<void> {
  const steps = shownSteps(app);
  if (steps.length < 2) throw new Error("A film needs two kept states at least; run some steps first.");
  const formats = await app.connection.fetch<Format[]>("formats");
  const format = formats.find((one) => one.name === "mp4") ?? formats.find((one) => one.name === "film")!;
  const states = h("input", { type: "range", min: "2", max: String(steps.length), value: String(steps.length), "aria-label": "States of the film, the last ones" });
  const rate = h("input", { type: "number", min: "1", max: "60", step: "1", value: String(RATE), required: true, "aria-label": "Frames a second" });
  const size = h("select", { "aria-label": "Longer side" }, ...SIZES.map((one) => h("option", { value: String(one), selected: one === 1024 }, `${one} pixels`)));
  const name = h("input", { type: "text", value: "dunes", required: true, pattern: "[A-Za-z0-9_\\-]+", "aria-label": "Name of the file" });
  const told = h("p", { role: "status" });
  const show = () => {
    const count = Number(states.value);
    told.textContent = `${count} states, from step ${short(steps.at(-count), 9)} to ${short(steps.at(-1), 9)}: ${short(count / (Number(rate.value) || RATE), 2)} s of film.`;
  };
  states.oninput = rate.oninput = show;
  const write: Submit = async (progress, signal) => {
    const options = { states: Number(states.value), frames_per_second: Number(rate.value), pixels: Number(size.value) };
    const request = { command: "export" as const, name: `${name.value}${format.suffix}`, format: format.name, ...options, run: app.selected };
    app.note("info", `The film ${await fetchFile(app, request, progress, signal)} is written; it is kept in studio-exports.`);
  };
  const row = (label: string, control: HTMLElement) => h("div", { className: "row" }, h("span", {}, label), control);
  const other = format.name === "mp4" ? "" : " MP4 needs the extra ‘video’: python -m pip install av.";
  formDialog(
    "Film of what was just seen",
    "write the film",
    write,
    told,
    row("how far back", states),
    row("frames a second", rate),
    row("longer side", size),
    row(`name (${format.suffix})`, name),
    h("p", { className: "hint" }, `The kept states up to the one that is shown, as shaded maps from above with the model’s layers. The run may go on meanwhile.${other}`),
  );
  show();
}

/** Steps of the kept states up to the one that is shown, and of that. */
function shownSteps(app: App): number[] {
  const { history = [], status } = app.current ?? {};
  if (!status) return [];
  return [...history.filter((step) => step < status.step), status.step];
}
