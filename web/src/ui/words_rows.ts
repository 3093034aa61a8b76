/** The boxes that choose what is written over a picture or a film. */

import type { App } from "../core/app";
import { withoutChanges } from "../core/labels";
import { titleOfShown } from "../core/run";
import type { Stage } from "../scene/stage";
import { h } from "./dom";
import type { Words } from "./picture_words";

export interface WordsRows {
  element: HTMLElement;
  chosen: () => Words;
}

/** The titles that were typed, each for the scenario whose title it stands for. */
const typed = new WeakMap<App, Map<string, string>>();

/** The field of the title: that of the scenario without what was changed, until another one is typed, which is kept for the next picture of it. */
function headingField(app: App, changed: () => void): HTMLInputElement {
  const own = withoutChanges(titleOfShown(app.runs, app.current));
  const titles = typed.get(app) ?? new Map<string, string>();
  typed.set(app, titles);
  const take = () => {
    titles.set(own, field.value);
    changed();
  };
  const field = h("input", { type: "text", value: titles.get(own) ?? own, maxLength: 120, "aria-label": "Title", oninput: take });
  return field;
}

/** A box for each of them, and further `boxes`; `changed` is called where one of them is changed. */
export function wordsRows(app: App, stage: Stage, changed: () => void, ...boxes: HTMLElement[]): WordsRows {
  const natural = stage.terrain(app.current!)?.colouring?.natural ?? true;
  const box = () => h("input", { type: "checkbox", checked: true, onchange: changed });
  const heading = headingField(app, changed);
  const words: Record<"title" | "scale" | "legend", HTMLInputElement> = { title: box(), scale: box(), legend: box() };
  words.legend.disabled = natural;
  const check = (text: string, input: HTMLInputElement) => h("label", { className: "check" }, input, text);
  return {
    element: h(
      "div",
      { className: "checks" },
      h("div", { className: "row" }, h("span", {}, "title"), heading),
      check("title block: title, model, step, seed, version", words.title),
      check("scale bar and compass", words.scale),
      check(natural ? "legend (choose a field under View, colour by)" : "legend of the colours", words.legend),
      ...boxes,
    ),
    chosen: () => ({ heading: heading.value, title: words.title.checked, scale: words.scale.checked, legend: words.legend.checked }),
  };
}
