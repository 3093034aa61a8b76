/** The choice of a limit of the speed. */

import type { App } from "../core/app";
import { h, isActive } from "./dom";

const LIMITS: [string, number | null][] = [
  ["no limit", null],
  ["100 steps/s", 100],
  ["40 steps/s", 40],
  ["10 steps/s", 10],
  ["3 steps/s", 3],
  ["1 step/s", 1],
];

export class Speed {
  readonly element: HTMLSelectElement;

  constructor(app: App) {
    this.element = h(
      "select",
      {
        "aria-label": "Speed limit",
        title: "Speed limit",
        onchange: () => app.send({ command: "limit", rate: LIMITS[this.element.selectedIndex]![1] }),
      },
      ...LIMITS.map(([text]) => h("option", {}, text)),
    );
  }

  /** Show the limit that holds (steps per second), unless somebody is choosing. */
  show(limit: number | null): void {
    const chosen = LIMITS.findIndex(([, rate]) => rate === limit);
    if (chosen >= 0 && !isActive(this.element)) this.element.selectedIndex = chosen;
  }
}
