/** A film of what was just seen: of the states of the run that are kept, as the scene shows them or as maps from above. */

import type { App } from "../core/app";
import { shownSteps } from "../core/run";
import type { Stage } from "../scene/stage";
import { type Submit, formDialog } from "./dialog";
import { counted, h, short } from "./dom";
import type { Format } from "./exports";
import { fetchFile, nameField } from "./exports";
import { filmOfStates } from "./scene_film";
import { NumberField } from "./number_field";
import { wordsRows } from "./words_rows";

/** How long a film is at first (s), where enough states are kept for it, and the frames a second by which that is sought. */
const LONG = 10;
const SLOWEST = 4;
const FASTEST = 30;
/** The longer side of a map (pixels), to choose from. */
const SIDES = [512, 1024, 1920];
/** Sizes (pixels) of pictures of the scene. */
const SIZES: [number, number][] = [
  [1280, 720],
  [1920, 1080],
  [3840, 2160],
];

/** How many of the kept states a film shows at first, and how many a second. */
export function proposed(kept: number): { states: number; rate: number } {
  const rate = Math.min(Math.max(Math.round(kept / LONG), SLOWEST), FASTEST);
  return { states: Math.min(kept, LONG * FASTEST), rate };
}

export async function filmSheet(app: App, stage: Stage): Promise<void> {
  const steps = shownSteps(app.runs);
  if (steps.length < 2) throw new Error("A film needs two kept states at least; run some steps first.");
  const formats = await app.connection.fetch<Format[]>("formats");
  const format = formats.find((one) => one.name === "mp4") ?? formats.find((one) => one.name === "film")!;
  const view = h("select", { "aria-label": "Drawn", onchange: () => show() }, h("option", { value: "scene" }, "as the scene shows it"), h("option", { value: "map" }, "as a shaded map"));
  const first = proposed(steps.length);
  const states = h("input", { type: "range", min: "2", max: String(steps.length), value: String(first.states), "aria-label": "States of the film, the last ones" });
  const rate = new NumberField({ label: "Frames a second", value: first.rate, whole: true, least: 1, most: 60, typing: () => show() });
  const size = h("select", { "aria-label": "Size" }, ...SIZES.map(([width, height], at) => h("option", { value: String(at) }, `${width} × ${height}`)));
  const turn = new NumberField({ label: "Degrees that the camera turns", value: 0, least: -720, most: 720 });
  const side = h("select", { "aria-label": "Longer side" }, ...SIDES.map((one) => h("option", { value: String(one), selected: one === 1024 }, `${one} pixels`)));
  const name = nameField(app);
  const words = wordsRows(app, stage, () => {});
  const count = h("span", { className: "unit" });
  const told = h("p", { className: "source", role: "status" });
  const hint = h("p", { className: "hint" });
  const row = (label: string, control: HTMLElement) => h("div", { className: "row" }, h("span", {}, label), control);
  const ofScene = [row("size (pixels)", size), row("camera turns (°)", turn.element), words.element];
  const ofMap = [row("longer side", side)];
  const other = format.name === "mp4" ? "" : " MP4 needs the extra ‘video’: python -m pip install av.";

  const show = () => {
    const [shown, scene] = [Number(states.value), view.value === "scene"];
    count.textContent = counted(shown, "state");
    const long = rate.number === null ? "" : `: a film of ${short(shown / rate.number, 2)} s`;
    told.textContent = `From step ${short(steps.at(-shown), 9)} to ${short(steps.at(-1), 9)}${long}.`;
    for (const one of ofScene) one.hidden = !scene;
    for (const one of ofMap) one.hidden = scene;
    const how = scene ? "in the colours and the light of the scene, exaggeration and scale of colours held. The run rests meanwhile and then goes on" : "with the model’s layers. The run may go on meanwhile";
    hint.textContent = `The kept states up to the one that is shown, ${how}.${other}`;
  };
  states.oninput = show;
  const write: Submit = async (progress, signal) => {
    const [last, second, file] = [Number(states.value), rate.number!, `${name.value}${format.suffix}`];
    const [width, height] = SIZES[Number(size.value)]!;
    const request = { command: "export" as const, name: file, format: format.name, states: last, options: { frames_per_second: second, pixels: Number(side.value) }, run: app.selected };
    const film = { name: file, states: last, width, height, rate: second, turn: turn.number!, words: words.chosen() };
    const written = view.value === "scene" ? await filmOfStates(app, stage, film, progress, signal) : await fetchFile(app, request, progress, signal);
    app.notices.confirm(`The film ${written} is written; it is kept in studio-exports.`);
  };
  formDialog("Film of what was just seen", "write the film", write, row("drawn", view), row("how far back", h("div", { className: "control" }, states, count)), row("frames a second", rate.element), told, ...ofScene, ...ofMap, row(`name (${format.suffix})`, name), hint);
  show();
}
