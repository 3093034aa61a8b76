/** A text to be copied: a row with the text and a button. */

import { h } from "./dom";

export function copyRow(label: string, text: string): HTMLElement {
  const field = h("input", { type: "text", readOnly: true, value: text, "aria-label": label, spellcheck: false, onfocus: () => field.select() });
  const said = h("span", { className: "copied", role: "status" });
  const copy = async () => {
    said.textContent = (await copied(field)) ? "copied" : "press Ctrl+C to copy it";
  };
  return h("div", { className: "copy-row" }, field, h("button", { type: "button", "aria-label": `Copy: ${label}`, onclick: () => void copy() }, "copy"), said);
}

/** Copy a field's text; browsers give pages without encryption from another computer no clipboard but the old one. */
async function copied(field: HTMLInputElement): Promise<boolean> {
  field.select();
  try {
    await navigator.clipboard.writeText(field.value);
    return true;
  } catch {
    return document.execCommand("copy");
  }
}
