/** The gallery of presets by landform: pictures, what to look for, and where to start. */

import type { App } from "../core/app";
import { withoutNames } from "../core/labels";
import type { JsonObject } from "../core/protocol";
import { dialog } from "./dialog";
import { h } from "./dom";
import type { Unfinished } from "./unfinished";

interface Preset {
  name: string;
  group: string;
  /** Whether it is the one to start with. */
  start: boolean;
  title: string;
  citation: string;
  look_for: string;
  question: string;
  model: string;
  rows: number;
  columns: number;
  picture: boolean;
}

/** Open the gallery; `onTour` leads through the first steps, where it is to be offered. Runs that were interrupted come first. */
export async function gallery(app: App, onTour: () => void, unfinished: Unfinished): Promise<void> {
  const presets = await app.connection.fetch<Preset[]>("presets");
  const close = () => sheet.close();
  const cards = presets.map((preset) => card(app, preset, close));
  const sections = [...new Set(presets.map((preset) => preset.group))].map((title) => {
    const own = cards.filter((_, at) => presets[at]!.group === title);
    return { title, own, element: h("section", { id: `group-of-${slug(title)}` }, h("h3", {}, title), h("div", { className: "cards" }, ...own)) };
  });
  const search = h("input", {
    type: "search",
    placeholder: "search: star, rocks, Momiji, plants …",
    "aria-label": "Search the presets",
    oninput: () => {
      const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
      presets.forEach((preset, at) => {
        const text = [preset.name, preset.title, preset.model, preset.look_for, preset.question, preset.citation, preset.group].join(" ").toLowerCase();
        cards[at]!.hidden = !words.every((word) => text.includes(word));
      });
      for (const section of sections) section.element.hidden = section.own.every((one) => one.hidden);
    },
  });
  const jump = (title: string) => document.getElementById(`group-of-${slug(title)}`)?.scrollIntoView({ behavior: "smooth" });
  const groups = h("nav", { className: "groups", "aria-label": "Landforms" }, ...sections.map(({ title }) => h("button", { type: "button", onclick: () => jump(title) }, title)));
  const first = presets.find((preset) => preset.start);
  const start = first && lead(app, first, close, onTour);
  const sheet: HTMLDialogElement = dialog("Presets", "gallery", h("div", { className: "finder" }, search, groups), h("div", { className: "sections" }, unfinished.inSheet(close), start ?? "", ...sections.map((section) => section.element)));
  search.focus();
}

/** The one to start with, and the tour. */
function lead(app: App, preset: Preset, close: () => void, onTour: () => void): HTMLElement {
  const begin = (tour: boolean) => {
    close();
    void open(app, preset).then(() => tour && onTour());
  };
  return h(
    "section",
    { className: "lead" },
    h("img", { src: app.connection.picture(preset.name), alt: "", width: 320, height: 200 }),
    h(
      "div",
      {},
      h("h3", {}, "Start here"),
      h("p", {}, h("b", {}, preset.title), ". ", withoutNames(preset.look_for)),
      h("p", { className: "question" }, withoutNames(preset.question)),
      h(
        "div",
        { className: "buttons" },
        h("button", { type: "button", className: "primary", onclick: () => begin(true) }, "turn the wind, watch the horns grow: a tour in three steps"),
        h("button", { type: "button", onclick: () => begin(false) }, "only watch"),
      ),
    ),
  );
}

/** Start a preset. */
export async function open(app: App, { name, title }: Pick<Preset, "name" | "title">): Promise<void> {
  const answer = await app.ask({ command: "preset", name });
  if (!answer) return;
  app.note("info", `Preset “${title}”.`);
  await app.create(answer.scenario as JsonObject, true);
}

function card(app: App, preset: Preset, close: () => void): HTMLElement {
  const begin = () => {
    close();
    void open(app, preset);
  };
  const picture = preset.picture
    ? h("img", { src: app.connection.picture(preset.name), alt: "", loading: "lazy", width: 320, height: 200 })
    : h("div", { className: "no-picture" });
  return h(
    "button",
    { type: "button", className: "card", "data-preset": preset.name, onclick: begin },
    picture,
    h("b", {}, preset.title),
    h("small", {}, `${preset.model} · ${preset.columns} × ${preset.rows} cells`),
    h("span", {}, withoutNames(preset.look_for)),
    h("em", { className: "question" }, withoutNames(preset.question)),
    h("small", { className: "source" }, withoutNames(preset.citation)),
  );
}

function slug(title: string): string {
  return title.toLowerCase().replaceAll(/\W+/g, "-");
}
