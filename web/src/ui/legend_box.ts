/** The scale of a surface's colours, as a box over the scene. */

import type { App } from "../core/app";
import { fitCanvas, h } from "./dom";
import { type Scale, drawBar, legendOf } from "./legend";

export class LegendBox {
  readonly element: HTMLElement;
  private readonly bar = h("canvas", { className: "colour-canvas" });
  private readonly title = h("div", { className: "bar-title" });
  private readonly ends = h("div", { className: "bar-ends" });
  private drawn = "";

  constructor(
    private readonly app: App,
    className = "",
  ) {
    this.element = h("div", { className: `colours ${className}`.trim(), hidden: true }, this.title, this.bar, this.ends);
  }

  show(scale: Scale | undefined): void {
    this.element.hidden = !scale;
    if (!scale) return;
    const { colouring, of } = scale;
    const key = `${colouring.map} ${colouring.limits.join(" ")} ${colouring.title} ${of} ${this.bar.clientWidth}`;
    if (key === this.drawn) return;
    this.drawn = key;
    const { context, width, height } = fitCanvas(this.bar);
    drawBar(context, this.app.colours[colouring.map] ?? [], 0, 0, width, height);
    const { title, marks } = legendOf(colouring);
    this.title.textContent = title + of;
    this.ends.replaceChildren(...marks.map((text) => h("span", {}, text)));
  }
}
