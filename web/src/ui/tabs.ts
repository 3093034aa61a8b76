/** The panel at the right: one page at a time. */

import { h } from "./dom";

export class Tabs {
  readonly element: HTMLElement;
  /** Show the page at a place. */
  readonly choose: (chosen: number) => void;

  constructor(pages: [string, HTMLElement][]) {
    const buttons = pages.map(([name], at) =>
      h("button", { type: "button", role: "tab", id: `page-tab-${at}`, "aria-controls": `page-${at}`, onclick: () => choose(at) }, name),
    );
    const sheets = pages.map(([, content], at) =>
      h("div", { className: "page", role: "tabpanel", id: `page-${at}`, "aria-labelledby": `page-tab-${at}` }, content),
    );
    const choose = (chosen: number) => {
      buttons.forEach((button, at) => button.setAttribute("aria-selected", String(at === chosen)));
      sheets.forEach((sheet, at) => (sheet.hidden = at !== chosen));
    };
    this.element = h("aside", { className: "panel", "aria-label": "Panel" }, h("div", { className: "tabs", role: "tablist" }, ...buttons), ...sheets);
    this.choose = choose;
    choose(0);
  }
}
