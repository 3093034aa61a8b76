/** The log of events, by level. */

import type { App } from "../core/app";
import type { Level } from "../core/notices";
import { h } from "../ui/dom";

const LEVELS: Level[] = ["info", "warning", "error"];

export class LogView {
  readonly title = "Log";
  readonly element: HTMLElement;
  private readonly list = h("ol", {});
  /** What is said aloud is said over the scene, whether or not the log is open. */
  private readonly scroll = h("div", { className: "log", role: "log", "aria-live": "off", tabIndex: 0, "aria-label": "Log" }, this.list);
  private least: Level = "info";

  constructor(private readonly app: App) {
    const level = h(
      "select",
      {
        "aria-label": "Least level shown",
        onchange: () => {
          this.least = LEVELS[level.selectedIndex]!;
          this.draw();
        },
      },
      h("option", {}, "everything"),
      h("option", {}, "warnings and errors"),
      h("option", {}, "errors"),
    );
    const clear = h(
      "button",
      {
        type: "button",
        className: "quiet",
        onclick: () => {
          this.app.notices.clearLog();
          this.draw();
        },
      },
      "clear",
    );
    this.element = h("div", { className: "view" }, h("div", { className: "tools" }, level, clear), this.scroll);
    app.notices.logged.watch(() => this.draw());
  }

  show(_visible: boolean): void {
    this.scroll.scrollTop = this.scroll.scrollHeight;
  }

  private draw(): void {
    const shown = this.app.notices.log.filter((entry) => LEVELS.indexOf(entry.level) >= LEVELS.indexOf(this.least));
    this.list.replaceChildren(
      ...shown.map((entry) =>
        h("li", { className: entry.level }, h("time", {}, entry.time.toTimeString().slice(0, 8)), h("b", {}, entry.level), h("span", {}, entry.text)),
      ),
    );
    this.scroll.scrollTop = this.scroll.scrollHeight;
  }
}
