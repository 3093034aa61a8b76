/** The brush: the model's material, the ground or plants added or taken away where it is drawn over the surface. */

import type { App } from "../core/app";
import type { Brush, BrushNumber } from "../core/protocol";
import type { Run } from "../core/run";
import type { Place } from "../scene/pick";
import { button, h, id } from "./dom";
import { NumberField } from "./number_field";

/** Metres from the south-west corner. */
type Point = [number, number];

/** Distance of two stamps, as a share of the radius: so far apart smooth and linear ones add up to an even band. */
const STAMP = 0.5;

/** Stamps of one message at most; a longer way is drawn with wider gaps. */
const MOST_STAMPS = 400;

/** Points every `step` on the way from one to another, the first one left out. */
export function between([x0, y0]: Point, [x1, y1]: Point, step: number): Point[] {
  const length = Math.hypot(x1 - x0, y1 - y0);
  const count = Math.min(Math.floor(length / step), MOST_STAMPS);
  const share = Math.max(step, length / MOST_STAMPS) / length;
  return Array.from({ length: count }, (_, at) => [x0 + (x1 - x0) * share * (at + 1), y0 + (y1 - y0) * share * (at + 1)]);
}

export class Paint {
  readonly element: HTMLElement;
  active = false;
  onActive: (active: boolean) => void = () => {};
  private brushes: Brush[] = [];
  private painted = "";
  private erases = false;
  private radius = 8;
  private readonly strengths = new Map<string, number>();
  private falloff = "smooth";
  private pressed: Run | null = null;
  /** The last stamp of the gesture. */
  private last: Point = [0, 0];
  private readonly toggle: HTMLButtonElement;
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly radiusInput = new NumberField({ value: 8, take: (radius) => this.resize(radius!), props: { "data-paint": "radius" } });
  private readonly what = h("select", { "data-paint": "what", onchange: () => this.choose(this.what.value) });
  private readonly strength = new NumberField({ take: (strength) => this.strengthen(strength!), props: { "data-paint": "strength" } });
  private readonly unit = h("span", { className: "unit" });
  private readonly numbers = h("div", {});
  private readonly note = h("p", { className: "hint" });
  /** Further numbers of brushes, by brush and key. */
  private readonly chosen = new Map<string, number>();

  constructor(private readonly app: App) {
    this.toggle = h("button", { type: "button", className: "wide", "aria-pressed": "false", onclick: () => this.activate(!this.active) }, "paint (B)");
    this.undo = button("Undo (Ctrl+Z)", "undo", () => app.send({ command: "undo" }));
    this.redo = button("Redo (Ctrl+Shift+Z)", "redo", () => app.send({ command: "redo" }));
    const way = h(
      "select",
      { "data-paint": "way", onchange: () => (this.erases = way.value === "erase") },
      h("option", { value: "add" }, "add"),
      h("option", { value: "erase" }, "take away"),
    );
    const falloff = h(
      "select",
      { onchange: () => (this.falloff = falloff.value) },
      ...["smooth", "linear", "none"].map((name) => h("option", { value: name }, name)),
    );
    this.element = h(
      "div",
      { className: "forms" },
      this.toggle,
      row("paint", this.what),
      row("brush", way),
      row("radius", this.radiusInput.element, h("span", { className: "unit" }, "m")),
      row("strength", this.strength.element, this.unit),
      this.numbers,
      this.note,
      row("falloff", falloff),
      h("div", { className: "buttons" }, this.undo, this.redo),
      h("p", { className: "hint" }, "Draw over the surface, while it runs or paused. [ and ] change the radius; hold Alt, or use two fingers, to turn the view."),
    );
    app.framed.watch(() => this.show());
    app.described.watch((run) => {
      this.offer(run.description!.brushes);
      const { columns, rows, cell_size } = run.description!.lattice;
      const whole = Math.min(columns, rows) * cell_size;
      if (this.radius > whole / 2 || this.radius < cell_size) this.resize(Number((whole / 16).toPrecision(2)));
    });
  }

  activate(active: boolean): void {
    this.active = active;
    this.toggle.setAttribute("aria-pressed", String(active));
    this.onActive(active);
  }

  resize(radius: number): void {
    this.radius = Math.max(radius, 1e-3);
    this.radiusInput.show(Number(this.radius.toPrecision(3)));
  }

  grow(factor: number): void {
    this.resize(this.radius * factor);
  }

  get size(): number {
    return this.radius;
  }

  press(run: Run, place: Place): void {
    this.pressed = run;
    for (const one of this.app.runs) one.painted = true;
    this.last = [place.x, place.y];
    this.send([this.last], { begin: true });
  }

  /** Draw on to a place, with stamps as close to each other as their radius asks for. */
  move(place: Place): void {
    if (!this.pressed) return;
    const stamps = between(this.last, [place.x, place.y], STAMP * this.radius);
    if (!stamps.length) return;
    this.last = stamps.at(-1)!;
    this.send(stamps, {});
  }

  release(): void {
    if (this.pressed) this.app.send({ command: "stroke", end: true });
    this.pressed = null;
  }

  /** End a stroke as if it had not been begun. */
  takeBack(): void {
    if (!this.pressed) return;
    this.release();
    this.app.send({ command: "undo" });
  }

  private get brush(): Brush | undefined {
    return this.brushes.find((brush) => brush.title === this.painted);
  }

  private offer(brushes: Brush[]): void {
    const titles = brushes.map((brush) => brush.title);
    if (titles.join() !== this.brushes.map((brush) => brush.title).join()) {
      this.what.replaceChildren(...titles.map((title) => h("option", { value: title }, title)));
    }
    this.brushes = brushes;
    this.choose(titles.includes(this.painted) ? this.painted : titles[0]!);
  }

  private choose(title: string): void {
    this.painted = this.what.value = title;
    const brush = this.brush!;
    this.unit.textContent = brush.unit;
    this.note.textContent = brush.note;
    this.note.hidden = !brush.note;
    this.strengthen(this.strengths.get(title) ?? brush.usual);
    this.numbers.replaceChildren(...brush.numbers.map((number) => this.numberRow(title, number)));
  }

  private numberRow(title: string, { key, title: name, unit, least, most, usual }: BrushNumber): HTMLElement {
    const at = `${title}.${key}`;
    const value = this.chosen.get(at) ?? usual;
    this.chosen.set(at, value);
    const take = (typed: number | null) => {
      const held = Math.min(Math.max(typed || usual, least), most);
      this.chosen.set(at, held);
      input.show(held);
    };
    const input = new NumberField({ value, take, props: { "data-paint": key } });
    return row(name, input.element, h("span", { className: "unit" }, unit));
  }

  private strengthen(asked: number): void {
    const { least, most, whole, usual } = this.brush!;
    const held = Math.min(Math.max(asked || usual, least), most);
    const strength = whole ? Math.round(held) : Number(held.toPrecision(3));
    this.strengths.set(this.painted, strength);
    this.strength.show(strength);
  }

  private send(places: Point[], when: { begin?: boolean }): void {
    const { brush } = this;
    if (!brush) return;
    const amount = (this.erases ? -1 : 1) * this.strengths.get(this.painted)!;
    const numbers = Object.fromEntries(brush.numbers.map(({ key }) => [key, this.chosen.get(`${brush.title}.${key}`)!]));
    this.app.send({ command: "stroke", ...when, places, stroke: { ...brush.stroke, ...numbers, radius: this.radius, amount, falloff: this.falloff } });
  }

  private show(): void {
    const status = this.app.current?.status;
    this.undo.disabled = !status?.undo;
    this.redo.disabled = !status?.redo;
  }
}

function row(label: string, control: HTMLElement, unit?: HTMLElement): HTMLElement {
  control.id ||= id("paint");
  return h("div", { className: "row" }, h("label", { for: control.id }, label), h("div", { className: "control" }, control, unit));
}
