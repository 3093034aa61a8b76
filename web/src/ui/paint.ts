/** The brush: sand laid down or taken away where it is drawn over the surface. */

import type { App } from "../core/app";
import type { Run } from "../core/run";
import type { Place } from "../scene/pick";
import { button, h, id } from "./dom";

type Tool = "sand" | "erase";

export class Paint {
  readonly element: HTMLElement;
  active = false;
  onActive: (active: boolean) => void = () => {};
  private tool: Tool = "sand";
  private radius = 8;
  private strength = 2;
  private falloff = "smooth";
  private pressed: Run | null = null;
  private readonly toggle: HTMLButtonElement;
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly radiusInput: HTMLInputElement;

  constructor(private readonly app: App) {
    this.toggle = h("button", { type: "button", className: "wide", "aria-pressed": "false", onclick: () => this.activate(!this.active) }, "paint (B)");
    this.undo = button("Undo (Ctrl+Z)", "undo", () => app.order({ do: "undo" }));
    this.redo = button("Redo (Ctrl+Shift+Z)", "redo", () => app.order({ do: "redo" }));
    const tools = h(
      "select",
      { onchange: () => (this.tool = tools.value as Tool) },
      h("option", { value: "sand" }, "add sand"),
      h("option", { value: "erase" }, "take sand away"),
    );
    const falloff = h(
      "select",
      { onchange: () => (this.falloff = falloff.value) },
      ...["smooth", "linear", "none"].map((name) => h("option", { value: name }, name)),
    );
    this.radiusInput = h("input", { type: "number", min: "0.1", step: "any", value: "8", onchange: () => this.resize(Number(this.radiusInput.value)) });
    const strength = h("input", {
      type: "number",
      min: "1",
      max: "1000",
      step: "1",
      value: "2",
      onchange: () => (this.strength = Math.min(Math.max(Math.round(Number(strength.value)) || 1, 1), 1000)),
    });
    this.element = h(
      "div",
      { className: "forms" },
      this.toggle,
      row("brush", tools),
      row("radius", this.radiusInput, "m"),
      row("strength", strength, "slabs"),
      row("falloff", falloff),
      h("div", { className: "buttons" }, this.undo, this.redo),
      h("p", { className: "hint" }, "Draw over the surface, while it runs or paused. [ and ] change the radius; hold Alt to turn the view."),
    );
    app.framed.watch(() => this.show());
    app.described.watch((run) => {
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
    this.radiusInput.value = String(Number(this.radius.toPrecision(3)));
  }

  grow(factor: number): void {
    this.resize(this.radius * factor);
  }

  get size(): number {
    return this.radius;
  }

  press(run: Run, place: Place): void {
    this.pressed = run;
    this.send(place, { begin: true });
  }

  move(place: Place): void {
    if (this.pressed) this.send(place, {});
  }

  release(): void {
    if (this.pressed) this.app.order({ do: "stroke", end: true });
    this.pressed = null;
  }

  private send(place: Place, when: { begin?: boolean }): void {
    const amount = this.tool === "erase" ? -this.strength : this.strength;
    const { x, y } = place;
    this.app.order({ do: "stroke", ...when, stroke: { x, y, radius: this.radius, amount, falloff: this.falloff } });
  }

  private show(): void {
    const status = this.app.current?.status;
    this.undo.disabled = !status?.undo;
    this.redo.disabled = !status?.redo;
  }
}

function row(label: string, control: HTMLElement, unit = ""): HTMLElement {
  control.id ||= id("paint");
  return h("div", { className: "row" }, h("label", { for: control.id }, label), h("div", { className: "control" }, control, unit && h("span", { className: "unit" }, unit)));
}
