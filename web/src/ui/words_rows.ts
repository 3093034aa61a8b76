/** The boxes that choose what is written over a picture or a film. */

import type { App } from "../core/app";
import type { Stage } from "../scene/stage";
import { h } from "./dom";
import type { Words } from "./picture_words";

export interface WordsRows {
  element: HTMLElement;
  chosen: () => Words;
}

/** A box for each of them, and further `boxes`; `changed` is called where one of them is changed. */
export function wordsRows(app: App, stage: Stage, changed: () => void, ...boxes: HTMLElement[]): WordsRows {
  const natural = stage.terrain(app.current!)?.colouring?.natural ?? true;
  const box = () => h("input", { type: "checkbox", checked: true, onchange: changed });
  const words: Record<keyof Words, HTMLInputElement> = { title: box(), scale: box(), legend: box() };
  words.legend.disabled = natural;
  const check = (text: string, input: HTMLInputElement) => h("label", { className: "check" }, input, text);
  return {
    element: h(
      "div",
      { className: "checks" },
      check("title, model, step, seed, version", words.title),
      check("scale bar and compass", words.scale),
      check(natural ? "legend (choose a field under View, colour by)" : "legend of the colours", words.legend),
      ...boxes,
    ),
    chosen: () => ({ title: words.title.checked, scale: words.scale.checked, legend: words.legend.checked }),
  };
}
