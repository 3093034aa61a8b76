/** The drawer below the scene: section, measures, space–time, log. */

import { h } from "./dom";
import { roving } from "./roving";

export interface DockView {
  title: string;
  element: HTMLElement;
  show(visible: boolean): void;
}

export class Dock {
  readonly element: HTMLElement;
  private readonly tabs: HTMLButtonElement[];
  private open = -1;

  constructor(private readonly views: DockView[]) {
    this.tabs = views.map((view, at) =>
      h(
        "button",
        { type: "button", role: "tab", id: `tab-${at}`, "aria-selected": "false", "aria-controls": `view-${at}`, onclick: () => this.toggle(at) },
        view.title,
      ),
    );
    views.forEach((view, at) => {
      view.element.hidden = true;
      view.element.id = `view-${at}`;
      view.element.setAttribute("role", "tabpanel");
      view.element.setAttribute("aria-labelledby", `tab-${at}`);
    });
    const body = h("div", { className: "dock-body" }, ...views.map((view) => view.element));
    const list = h("div", { className: "tabs", role: "tablist", "aria-label": "Views" }, ...this.tabs);
    roving(list, this.tabs);
    this.element = h("section", { className: "dock", "aria-label": "Views" }, list, body);
  }

  /** Open a view, or close it where it is open. */
  toggle(at: number): void {
    this.choose(this.open === at ? -1 : at);
  }

  choose(at: number): void {
    this.open = at;
    this.element.classList.toggle("open", at >= 0);
    this.views.forEach((view, number) => {
      view.element.hidden = number !== at;
      this.tabs[number]!.setAttribute("aria-selected", String(number === at));
      if (number === at) this.tabs[number]!.classList.remove("marked");
      view.show(number === at);
    });
  }

  /** Mark a view as holding something that was not read yet, until it is opened. */
  mark(view: DockView): void {
    const at = this.views.indexOf(view);
    this.tabs[at]!.classList.toggle("marked", this.open !== at);
  }
}
