/** The ruler: a line between two places of the surface, and what it measures, which follows the run. */

import type { App } from "../core/app";
import { type Distance, distance } from "../core/distance";
import { type Run, nameBeside } from "../core/run";
import type { SectionLine } from "../core/section";
import type { Stage } from "../scene/stage";
import { Coordinates } from "./coordinates";
import { button, copyText, h, short, suitedLength } from "./dom";
import { NumberField } from "./number_field";

const VALUES: [string, string, (of: Distance) => string][] = [
  ["distance", "Metres on a map", (of) => suitedLength(of.horizontal)],
  ["height difference", "How much higher the surface is at the second place", (of) => suitedLength(of.rise)],
  ["along the surface", "Length of the profile, with every step of its cells", (of) => suitedLength(of.surface)],
  ["slope", "Of the straight line between both places, rising positive", (of) => angle(of.slope)],
  ["azimuth", "Of the way from the first place to the second, clockwise from north", (of) => angle(of.azimuth)],
];
const PLACES = ["first place, metres east", "first place, metres north", "second place, metres east", "second place, metres north"];
const HINT = "Click two places of the surface, or drag from one to the other.";

export class Ruler {
  readonly element = h("section", { className: "ruler", hidden: true, "aria-label": "Ruler" });
  /** Both places; the same one twice while the second is still to come. */
  line: SectionLine | null = null;
  /** Whether the next click of the mouse, or touch, chooses a place. */
  active = false;
  onActive: () => void = () => {};
  /** Whether the first place is chosen and the second is not. */
  private half = false;
  private readonly inputs: NumberField[];
  private readonly coordinates: Coordinates;
  private readonly table = h("table", {});
  private readonly hint = h("p", { className: "hint" }, HINT);

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    this.coordinates = new Coordinates(app, "Coordinates of the ruler’s places", () => this.show());
    this.inputs = PLACES.map((label) => new NumberField({ label, signed: true, optional: true, grows: true, take: () => this.type(), props: { title: `The ${label}` } }));
    const fields = this.inputs.map(({ element }) => element);
    this.element.append(
      h(
        "header",
        {},
        h("h2", {}, "Ruler"),
        h("div", { className: "places" }, "from", ...fields.slice(0, 2), "to", ...fields.slice(2), "m"),
        this.coordinates.element,
        button("Copy the values", "copy", () => void this.copy()),
        h("button", { type: "button", className: "close", title: "Close (M)", "aria-label": "Close the ruler", onclick: () => this.toggle() }, "×"),
      ),
      this.table,
      this.hint,
    );
    this.element.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.toggle();
    });
    app.framed.watch(() => this.show());
    app.changed.watch(() => this.show());
  }

  /** Take the ruler out, its first place in the fields for its numbers, or put it away. */
  toggle(): void {
    this.active = !this.active;
    this.element.hidden = !this.active;
    if (this.active) this.inputs[0]!.element.focus();
    else {
      this.half = false;
      this.stage.canvas.focus();
    }
    this.show();
    this.onActive();
  }

  /** A place was clicked or touched: the first one, or the second where the first is chosen. */
  press(x: number, y: number): void {
    this.line = this.half ? [this.line![0], this.line![1], x, y] : [x, y, x, y];
    this.half = !this.half;
    this.show();
  }

  /** The mouse is over a place while the second one is to come. */
  move(x: number, y: number): void {
    if (!this.half || !this.line) return;
    this.line = [this.line[0], this.line[1], x, y];
    this.show();
  }

  /** The mouse was let go: after a drag the second place is there, after a click only the first, however the mouse trembled. */
  release(dragged: boolean): void {
    if (dragged) this.half = false;
    else if (this.half && this.line) this.line = [this.line[0], this.line[1], this.line[0], this.line[1]];
    this.show();
  }

  /** The places as they are typed. */
  private type(): void {
    const numbers = this.inputs.flatMap(({ number }) => number ?? []);
    if (numbers.length < PLACES.length) return;
    this.line = this.coordinates.read(numbers, this.line);
    this.half = false;
    this.show();
  }

  private show(): void {
    const run = this.app.current;
    if (!this.active || !run?.ready) return this.stage.showLine("ruler", null);
    this.coordinates.offer();
    const { columns, rows, cell_size } = run.description!.lattice;
    const [w, d] = [columns * cell_size, rows * cell_size];
    this.stage.showLine("ruler", this.line && [this.line[0] / w, this.line[1] / d, this.line[2] / w, this.line[3] / d]);
    this.hint.hidden = this.line !== null && !this.half;
    const known = this.second ? 4 : 2;
    this.line?.forEach((_, at) => {
      const input = this.inputs[at]!;
      if (input.element !== document.activeElement || !this.half) input.show(at < known ? this.coordinates.shown(this.line!, at) : null);
    });
    this.table.replaceChildren(...this.rows());
  }

  /** Whether there is a second place, or the mouse is over one: the first place alone is none. */
  private get second(): boolean {
    const { line } = this;
    return line !== null && !(this.half && line[0] === line[2] && line[1] === line[3]);
  }

  /** A column for each value, a row for each run: low, so that the field below stays free. */
  private rows(): HTMLElement[] {
    const { line } = this;
    const runs = line && this.second ? this.app.runs.filter((run) => run.ready) : [];
    if (!line || !runs.length) return [];
    const two = runs.length > 1;
    const head = h("tr", {}, two && h("th", {}), ...VALUES.map(([name, title]) => h("th", { scope: "col", title }, name)));
    const values = (of: Distance) => VALUES.map(([, title, text]) => h("td", { title }, text(of)));
    return [head, ...runs.map((run) => h("tr", {}, two && h("th", { scope: "row" }, this.name(run)), ...values(distance(run, line))))];
  }

  /** Both places as eastings and northings, where the ground has them. */
  private onTheMap(): string[] {
    const { place } = this.coordinates;
    if (!place || !this.line) return [];
    const numbers = this.line.map((one, at) => (one + (at % 2 ? place.south : place.west)).toFixed(3));
    return [`eastings and northings (m${place.crs ? `, ${place.crs}` : ""})\t${numbers.join("\t")}`];
  }

  private name(run: Run): string {
    return nameBeside(run, this.app.runs.find((one) => one !== run));
  }

  private async copy(): Promise<void> {
    const rows = [...this.table.rows].map((row) => [...row.cells].map((cell) => cell.textContent).join("\t"));
    const step = `step\t${this.app.current?.status?.step ?? ""}`;
    const places = `places (m)\t${this.line?.map((place) => Number(place.toPrecision(7))).join("\t") ?? ""}`;
    await copyText([step, places, ...this.onTheMap(), ...rows, ""].join("\n"));
    this.app.note("info", "The values of the ruler are copied.");
  }
}

const angle = (degrees: number | null): string => (degrees === null ? "–" : `${short(Number(degrees.toFixed(2)), 5)}°`);
