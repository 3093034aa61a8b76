/** The question whether a run may end that cannot be kept. */

import { dialog } from "./dialog";
import { h } from "./dom";

/** Ask it; what leaves the sheet otherwise means no. */
export function mayEnd(text: string): Promise<boolean> {
  return new Promise((answer) => {
    const end = () => {
      answer(true);
      sheet.close();
    };
    const yes = h("button", { type: "button", onclick: end }, "let it end");
    const no = h("button", { type: "button", className: "primary", onclick: () => sheet.close() }, "leave all as it is");
    const sheet: HTMLDialogElement = dialog("A run would end", "small", h("p", {}, text), h("div", { className: "buttons" }, no, yes));
    sheet.addEventListener("close", () => answer(false));
  });
}
