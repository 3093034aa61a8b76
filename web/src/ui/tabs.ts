/** The panel at the right: one page at a time. */

import { h } from "./dom";
import { roving } from "./roving";

export class Tabs {
  /** The row of tabs, and the pages below it. */
  readonly elements: HTMLElement[];
  private readonly buttons: HTMLButtonElement[];
  private readonly sheets: HTMLElement[];

  constructor(pages: [string, HTMLElement][]) {
    this.buttons = pages.map(([name], at) =>
      h("button", { type: "button", role: "tab", id: `page-tab-${at}`, "aria-controls": `page-${at}`, onclick: () => this.choose(at) }, name),
    );
    this.sheets = pages.map(([, content], at) =>
      h("div", { className: "page", role: "tabpanel", id: `page-${at}`, "aria-labelledby": `page-tab-${at}` }, content),
    );
    const list = h("div", { className: "tabs", role: "tablist", "aria-label": "Pages of the panel" }, ...this.buttons);
    roving(list, this.buttons, (at) => this.choose(at));
    this.elements = [list, ...this.sheets];
    this.choose(0);
  }

  /** Show the page at a place. */
  choose(chosen: number): void {
    this.buttons.forEach((button, at) => {
      button.setAttribute("aria-selected", String(at === chosen));
      button.tabIndex = at === chosen ? 0 : -1;
    });
    this.sheets.forEach((sheet, at) => (sheet.hidden = at !== chosen));
  }
}
