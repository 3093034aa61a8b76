/** The display over the scene: compass with the wind, scale bar, colour bar, values under the mouse. */

import type { App } from "../core/app";
import { namesOf } from "../core/run";
import type { Stage } from "../scene/stage";
import { slopes } from "../scene/smooth";
import { h, heights, metres, short, svg } from "./dom";
import { scaleLength, scalesOf } from "./legend";
import { LegendBox } from "./legend_box";
import { stepsOf, timesOf, windsOf } from "./steps";

const BAR = 110;

export class Hud {
  readonly element: HTMLElement;
  private readonly rose = svg("g", {});
  /** The winds of the left and of the right run; the latter where it blows otherwise. */
  private readonly winds = ["wind", "wind beside"].map((name) => svg("g", { class: name }, svg("line", { x1: 0, y1: -30, x2: 0, y2: 24 }), svg("path", { d: "M0 30 L-6 17 L6 17 Z" })));
  private readonly windText = h("span", { className: "wind-text" });
  private readonly scale = h("div", { className: "scale" });
  private readonly steeper = h("div", { className: "steeper", title: "Heights are drawn this many times as steep as they are (View, vertical exaggeration)" });
  /** The scales of the left and of the right surface; one that both have is the left one's. */
  private readonly legends: [LegendBox, LegendBox];
  private readonly photograph = h("div", { className: "colours", hidden: true });
  private readonly under = h("output", { className: "under" });
  private readonly names = h("div", { className: "names" });

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    this.rose.append(
      ...[0, 90, 180, 270].map((angle) => svg("line", { x1: 0, y1: -36, x2: 0, y2: -32, transform: `rotate(${angle})`, class: "mark" })),
      svg("text", { x: 0, y: -41 }, "N"),
      ...this.winds,
    );
    const compass = svg("svg", { viewBox: "-54 -54 108 108", width: 92, height: 96, role: "img", "aria-label": "Compass; the arrow shows where the wind blows" }, svg("circle", { r: 36, class: "face" }), this.rose);
    this.legends = [new LegendBox(app), new LegendBox(app, "right")];
    this.element = h(
      "div",
      { className: "hud", hidden: true },
      this.names,
      h("div", { className: "compass" }, compass as unknown as HTMLElement, this.windText),
      h("div", { className: "corner" }, this.legends[0].element, this.photograph, h("div", { className: "measure" }, this.scale, this.steeper)),
      this.legends[1].element,
      this.under,
    );
    stage.painted.watch(() => this.draw());
  }

  /** Show position, elevation, slope and depth at a place of the page. */
  pointAt(event: { clientX: number; clientY: number } | null): void {
    const found = event && this.stage.pick(event);
    if (!found) {
      this.under.textContent = "";
      return;
    }
    const { run, place } = found;
    const { lattice } = run.description!;
    const at = place.row * run.columns + place.column;
    const slope = slopeAt(run.surface, run.rows, run.columns, place.row, place.column, lattice.cell_size, lattice.periodic);
    const colouring = this.stage.terrain(run)?.colouring;
    const named = run.description!.fields.find((field) => field.name === this.app.view.look.field);
    const extra = named && colouring ? ` · ${named.meaning} ${colouring.choice ? (colouring.values[at]! > 0.5 ? "yes" : "no") : short(colouring.values[at])} ${colouring.unit}` : "";
    this.under.textContent =
      `x ${short(place.x)} m, y ${short(place.y)} m · elevation ${metres(run.surface[at])} · ` +
      `slope ${slope.toFixed(1)}° · ${run.material} ${metres(run.depth[at])}${extra}`;
  }

  private draw(): void {
    const run = this.app.current;
    this.element.hidden = !run?.ready;
    if (!run?.ready) return;
    const heading = (this.stage.heading() * 180) / Math.PI;
    this.rose.setAttribute("transform", `rotate(${-heading})`);
    this.drawWinds();
    this.drawScale();
    this.drawColours();
    const two = this.app.runs.length > 1;
    this.names.hidden = !two;
    if (two) {
      const names = namesOf(this.app.runs).map((name, at) => [name, ...this.stand(at)].join(" · "));
      if (this.names.dataset.text !== names.join("|")) {
        this.names.dataset.text = names.join("|");
        this.names.replaceChildren(...names.map((name) => h("span", {}, name)));
      }
    }
  }

  private drawWinds(): void {
    const statuses = this.app.runs.map((one) => one.status);
    const differ = windsOf(statuses).includes("|");
    this.winds.forEach((arrow, at) => {
      arrow.style.display = at && !differ ? "none" : "";
      arrow.setAttribute("transform", `rotate(${statuses[at]?.wind ?? 0})`);
    });
    this.windText.textContent = `wind from ${windsOf(statuses)}`;
  }

  /** Where one of two runs stands: its step, and its time and its wind where they are not those of the other. */
  private stand(at: number): string[] {
    const all = this.app.runs.map((run) => run.status);
    const own = [all[at]];
    const time = timesOf(all).includes("|") && timesOf(own);
    const wind = windsOf(all).includes("|") && `wind from ${windsOf(own)}`;
    return [`step ${stepsOf(own)}`, time, wind].filter((text) => text !== false);
  }

  private drawScale(): void {
    const perPixel = this.stage.metresPerPixel();
    if (!Number.isFinite(perPixel)) return;
    const length = scaleLength(perPixel * BAR);
    this.scale.style.width = `${length / perPixel}px`;
    const text = metres(length);
    if (this.scale.textContent !== text) this.scale.textContent = text;
    const times = heights(this.stage.terrain(this.app.current!)?.exaggeration ?? 1);
    if (this.steeper.textContent !== times) this.steeper.textContent = times;
  }

  private drawColours(): void {
    const scales = scalesOf(this.app, (run) => this.stage.terrain(run)?.colouring);
    const { name, image, terrain, opacity } = this.app.overlay;
    this.photograph.hidden = !image || terrain || opacity === 0 || scales.length > 0;
    if (!this.photograph.hidden) this.photograph.textContent = `draped: photograph ${name}`;
    this.legends.forEach((legend, at) => legend.show(scales.find((scale) => scale.at === at)));
  }
}

function slopeAt(surface: Float32Array, rows: number, columns: number, row: number, column: number, cell: number, joined: [boolean, boolean]): number {
  const size = 3;
  const patch = new Float32Array(size * size);
  const step = (at: number, by: number, count: number, closed: boolean) =>
    closed ? (at + by + count) % count : Math.min(Math.max(at + by, 0), count - 1);
  for (let r = -1; r <= 1; r++) {
    for (let c = -1; c <= 1; c++) {
      const from = step(row, r, rows, joined[0]) * columns + step(column, c, columns, joined[1]);
      patch[(r + 1) * size + c + 1] = surface[from]!;
    }
  }
  return slopes(patch, size, size, cell, [false, false])[4]!;
}
