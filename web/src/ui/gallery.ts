/** The presets: a picture, its title, and its features to look for. */

import type { App } from "../core/app";
import type { JsonObject } from "../core/protocol";
import { dialog } from "./dialog";
import { h } from "./dom";

interface Preset {
  name: string;
  title: string;
  citation: string;
  look_for: string;
  model: string;
  rows: number;
  columns: number;
  picture: boolean;
}

export async function gallery(app: App): Promise<void> {
  const presets = await app.connection.fetch<Preset[]>("presets");
  const cards = presets.map((preset) => card(app, preset, () => sheet.close()));
  const search = h("input", {
    type: "search",
    placeholder: "search: star, rocks, Momiji, plants …",
    "aria-label": "Search the presets",
    oninput: () => {
      const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
      presets.forEach((preset, at) => {
        const text = `${preset.name} ${preset.title} ${preset.model} ${preset.look_for} ${preset.citation}`.toLowerCase();
        cards[at]!.hidden = !words.every((word) => text.includes(word));
      });
    },
  });
  const sheet: HTMLDialogElement = dialog("Presets", "gallery", search, h("div", { className: "cards" }, ...cards));
  search.focus();
}

function card(app: App, preset: Preset, close: () => void): HTMLElement {
  const begin = async () => {
    close();
    const answer = await app.ask({ command: "preset", name: preset.name });
    if (!answer) return;
    if (await app.create(answer.scenario as JsonObject)) app.note("info", `Preset ${preset.name}.`);
  };
  const picture = preset.picture
    ? h("img", { src: app.connection.picture(preset.name), alt: "", loading: "lazy", width: 240, height: 150 })
    : h("div", { className: "no-picture" });
  return h(
    "button",
    { type: "button", className: "card", "data-preset": preset.name, onclick: () => void begin() },
    picture,
    h("b", {}, preset.title),
    h("small", {}, `${preset.model} · ${preset.columns} × ${preset.rows} cells`),
    h("span", {}, preset.look_for),
    h("small", { className: "source" }, preset.citation),
  );
}
