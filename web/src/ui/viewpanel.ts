/** The panel of the view: colours, layers, lines, light and camera. */

import type { App } from "../core/app";
import { LOOK, type Look } from "../core/view";
import { ANGLES } from "../scene/camera";
import { plainFields } from "../scene/colouring";
import { smoothingOf } from "../scene/looks";
import type { Stage } from "../scene/stage";
import { button, h, id, isActive } from "./dom";
import { icon } from "./icons";
import { labelOf } from "../core/labels";
import { NumberField } from "./number_field";
import { OverlayPanel } from "./overlay";

const SANDS: [string, string][] = [["golden", "golden (quartz)"], ["white", "white (gypsum)"], ["red", "red (iron oxide)"], ["dark", "dark (basalt)"]];

/** Rows, and how they show what is chosen now. */
interface Rows {
  rows: HTMLElement[];
  show: () => void;
}

export class ViewPanel {
  readonly element = h("div", { className: "forms" });
  private shown = "";
  /** Let the rows of what the scene chooses by itself show what it has chosen. */
  private showChosen = () => {};
  private readonly numbers = new Map<string, NumberField>();
  private readonly overlay: OverlayPanel;

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    this.overlay = new OverlayPanel(app);
    app.described.watch(() => this.draw());
    app.changed.watch(() => this.draw());
    app.view.changed.watch(() => this.follow());
    stage.painted.watch(() => this.showChosen());
    this.draw();
  }

  private draw(): void {
    const run = this.app.current;
    const text = JSON.stringify([run?.material, run?.description?.fields, run?.description?.paths, run?.description?.layers, this.app.runs.length]);
    if (text === this.shown) return;
    this.shown = text;
    this.redraw();
  }

  /** Let the controls show what keys have changed. */
  private follow(): void {
    for (const control of this.element.querySelectorAll<HTMLInputElement>("[data-look]")) {
      const value = this.app.view.look[control.dataset.look as keyof Look];
      if (control === document.activeElement) continue;
      if (control.type === "checkbox") control.checked = value === true;
      else if (typeof value === "number" && this.numbers.has(control.dataset.look!)) this.numbers.get(control.dataset.look!)!.show(value);
      else control.value = String(value);
    }
  }

  private redraw(): void {
    const [steep, smooth, sun] = [this.exaggeration(), this.smoothing(), this.sun()];
    this.showChosen = () => [steep, smooth, sun].forEach(({ show }) => show());
    const description = this.app.current?.description;
    const fields = [...plainFields(this.app.current?.material ?? "sand"), ...(description?.fields ?? [])];
    const layers = description?.layers ?? [];
    const two = this.app.runs.length > 1;
    const named = fields.map((field) => [field.name, field.meaning] as [string, string]);
    this.element.replaceChildren(
      h("h2", {}, "Colour"),
      this.choice("colour by", "field", named),
      this.choice("colours", "map", [["perceptual", "perceptual"], ["grey", "grey"], ["red-green", "red (high) to green"]]),
      ...(this.app.current?.material === "sand" ? [this.choice("sand", "sand", SANDS)] : []),
      this.limits(),
      this.check("shade the colours by the relief", "shaded"),
      this.check("ground in grey where it is bare", "bare"),
      ...(two ? [h("h2", {}, "Two at once"), this.choice("show", "side", [["surface", "each by itself"], ["difference", "right less left"]])] : []),
      ...(layers.length ? [h("h2", {}, "Layers"), ...layers.map((layer) => this.layer(layer.field, layer.title))] : []),
      ...(description?.paths ? [h("h2", {}, "Grains"), this.number("paths", "paths", 0, 500, "grains", true)] : []),
      h("h2", {}, "Overlay"),
      this.overlay.element,
      h("h2", {}, "Lines"),
      this.choice("contours", "contours", [["off", "none"], ["interval", "at an interval"], ["count", "a number of them"]]),
      this.number("interval", "interval", 0.05, 100, "m"),
      this.number("count", "count", 1, 60, "", true),
      this.check("wireframe of the cells", "wireframe"),
      h("h2", {}, "Shape and light"),
      ...steep.rows,
      ...smooth.rows,
      ...sun.rows,
      this.choice("light", "light", [["theme", "as the theme"], ["day", "day"], ["dusk", "dusk"]]),
      this.check("shadows of the sun", "shadows"),
      this.choice("detail", "quality", [["automatic", "automatic"], ["full", "full"], ["plain", "plain (slow graphics)"]]),
      h("h2", {}, "Camera"),
      h(
        "div",
        { className: "buttons" },
        ...(["oblique", "top", "side"] as const).map((from) =>
          h("button", { type: "button", onclick: () => this.stage.look(from) }, from),
        ),
      ),
      this.number("field of view", "fieldOfView", ANGLES.least, ANGLES.most, "°"),
      this.check("turn slowly while nobody touches it", "turning"),
      h("h2", {}, "Page"),
      this.choice("theme", "theme", [["system", "as the system"], ["light", "light"], ["dark", "dark"]]),
      h("button", { type: "button", className: "quiet", onclick: () => this.reset() }, "reset the view"),
    );
  }

  private reset(): void {
    this.set({ ...LOOK }, true);
    this.stage.look("oblique");
  }

  private set(change: Partial<Look>, redraw = false): void {
    this.app.view.set(change);
    if (redraw) this.redraw();
  }

  private row(label: string, control: HTMLElement, ...more: (HTMLElement | string)[]): HTMLElement {
    control.id ||= id("view");
    return h("div", { className: "row" }, h("label", { for: control.id }, label), h("div", { className: "control" }, control, ...more));
  }

  private choice<K extends keyof Look>(label: string, key: K, options: [string, string][]): HTMLElement {
    const select = h(
      "select",
      { "data-look": key, onchange: () => this.set({ [key]: select.value } as Partial<Look>) },
      ...options.map(([value, text]) => h("option", { value, selected: value === this.app.view.look[key] }, labelOf(text))),
    );
    return this.row(label, select);
  }

  private check(label: string, key: "bare" | "wireframe" | "shadows" | "shaded" | "turning"): HTMLElement {
    const box = h("input", {
      type: "checkbox",
      "data-look": key,
      checked: this.app.view.look[key],
      onchange: () => this.set({ [key]: box.checked }),
    });
    return this.row(label, box);
  }

  private number(label: string, key: "interval" | "count" | "paths" | "fieldOfView", least: number, most: number, unit: string, whole = false): HTMLElement {
    const take = (value: number | null) => this.set({ [key]: value! });
    const input = new NumberField({ value: this.app.view.look[key], least, most, whole, take, props: { "data-look": key } });
    this.numbers.set(key, input);
    return this.row(label, input.element, h("span", { className: "unit" }, unit));
  }

  /** A slider that shows the smoothing that acts, and a way back to the one that suits the material. */
  private smoothing(): Rows {
    const now = () => smoothingOf(this.app.current?.material ?? "sand", this.app.view.look.smoothing);
    const value = h("span", { className: "unit" });
    const slider = h("input", { type: "range", min: "0", max: "4", step: "any", oninput: () => this.set({ smoothing: Number(slider.value) }) });
    const reset = button("Smooth as suits the material", icon("back"), () => this.set({ smoothing: null }), { className: "reset" });
    const show = () => {
      value.textContent = `${Number(now().toFixed(1))} ×`;
      reset.hidden = this.app.view.look.smoothing === null;
      if (Number(slider.value) !== now()) slider.value = String(now());
    };
    show();
    return { rows: [this.row("smoothing (display only)", slider, value, reset)], show };
  }

  /** A slider by factors, and the choice to leave it to the lattice. */
  private exaggeration(): Rows {
    const now = () => (this.app.current && this.stage.terrain(this.app.current)?.exaggeration) ?? 1;
    const [least, most] = [0.5, 50];
    const value = new NumberField({ label: "Times as steep", least, most, take: (typed) => this.set({ exaggeration: typed! }) });
    const slider = h("input", {
      type: "range",
      min: String(Math.log(least)),
      max: String(Math.log(most)),
      step: "any",
      oninput: () => {
        this.set({ exaggeration: Number(Math.exp(Number(slider.value)).toPrecision(2)) });
      },
    });
    const usual = h("input", {
      type: "checkbox",
      onchange: () => {
        if (usual.checked) for (const run of this.app.runs) run.painted = false;
        this.set({ exaggeration: usual.checked ? null : now() });
      },
    });
    const show = () => {
      usual.checked = this.app.view.look.exaggeration === null;
      follow(value, Number(now().toPrecision(3)));
      if (slider !== document.activeElement || usual.checked) slider.value = String(Math.log(now()));
    };
    show();
    return { rows: [this.row("vertical exaggeration", slider, value.element, "×"), this.row("automatic", usual)], show };
  }

  /** Where the sun stands, and the choice to leave it to the wind. */
  private sun(): Rows {
    const rows = ([["sun from", "azimuth", "sunAzimuth", 0, 360], ["sun height", "height", "sunHeight", 5, 89]] as const).map(([label, part, key, min, max]) => {
      const value = new NumberField({ label: label === "sun from" ? "Direction of the sun" : "Height of the sun", least: min, most: max, take: (typed) => this.set({ [key]: typed! }) });
      const slider = h("input", {
        type: "range",
        min: String(min),
        max: String(max),
        step: "any",
        oninput: () => {
          this.set({ [key]: Number(Number(slider.value).toFixed(1)) });
        },
      });
      const show = () => {
        slider.value = String(this.stage.sun()[part]);
        follow(value, Number(this.stage.sun()[part].toFixed(1)));
        across.checked = this.app.view.look.sunAzimuth === null && this.app.view.look.sunHeight === null;
      };
      return { row: this.row(label, slider, value.element, "°"), show };
    });
    const show = () => rows.forEach((row) => row.show());
    const across = h("input", {
      type: "checkbox",
      onchange: () => {
        const { azimuth, height } = this.stage.sun();
        this.set(across.checked ? { sunAzimuth: null, sunHeight: null } : { sunAzimuth: azimuth, sunHeight: height });
      },
    });
    show();
    return { rows: [...rows.map((row) => row.row), this.row("across the crests", across)], show };
  }

  private limits(): HTMLElement {
    const { limits } = this.app.view.look;
    const take = (end: number) => {
      const [low, high] = ends.map((field) => field.number) as [number | null, number | null];
      if (low === null || high === null) return;
      if (low < high) this.set({ limits: [low, high] });
      else ends[end]!.refuse("The lowest value must be below the highest.");
    };
    const ends = ["Lowest value of the colours", "Highest value of the colours"].map(
      (label, end) => new NumberField({ label, value: limits?.[end] ?? null, signed: true, take: () => take(end), props: { disabled: !limits } }),
    );
    const box = h("input", {
      type: "checkbox",
      checked: limits !== null,
      onchange: () => {
        const now = this.stage.terrain(this.app.current!)?.colouring?.limits ?? [0, 1];
        this.set({ limits: box.checked ? (now.map((x) => Number(x.toPrecision(4))) as [number, number]) : null }, true);
      },
    });
    return this.row("fixed scale", box, ...ends.map((field) => field.element));
  }

  private layer(field: string, title: string): HTMLElement {
    const box = h("input", {
      type: "checkbox",
      "data-layer": field,
      checked: this.app.view.look.overlays.includes(field),
      onchange: () => {
        const others = this.app.view.look.overlays.filter((name) => name !== field);
        this.set({ overlays: box.checked ? [...others, field] : others });
      },
    });
    return this.row(title, box);
  }
}

/** Let a number stand in a field, unless somebody is typing there or it stands there already. */
function follow(field: NumberField, value: number): void {
  if (!isActive(field.element) && field.element.value !== String(value)) field.show(value);
}
