/** A terrain or a photograph over the surface: its sheet, and its rows in the panel of the view. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import { refuseContent, refuseName, suffixesOf } from "../core/file_kinds";
import { isImage } from "../core/image_ground";
import { withKeptFile } from "../core/kept_file";
import { ABOVE, OVERLAY } from "../core/overlay";
import { ends } from "../core/profile";
import type { Json } from "../core/protocol";
import { photograph, shadedMap } from "../scene/draped";
import { type Submit, formDialog } from "./dialog";
import { h } from "./dom";
import { HeightEnds, sheetRow } from "./height_ends";

const PHOTOGRAPHS = [".png", ".jpg", ".jpeg", ".webp"];

const has = (name: string, suffixes: string[]): boolean => suffixes.some((suffix) => name.toLowerCase().endsWith(suffix));

export class OverlayPanel {
  readonly element = h("div", {});

  constructor(private readonly app: App) {
    app.overlay.changed.watch(() => this.draw());
    app.framed.watch(() => this.makeMap());
    app.described.watch(() => this.follow());
    this.draw();
  }

  private draw(): void {
    const { overlay } = this.app;
    if (!overlay.name) {
      this.element.replaceChildren(h("button", { type: "button", onclick: () => overlaySheet(this.app) }, "compare with a terrain or photograph …"));
      return;
    }
    if (this.element.dataset.name === overlay.name && this.element.querySelector("input")) return;
    this.element.dataset.name = overlay.name;
    const value = h("span", { className: "unit" }, percent(overlay.opacity));
    const slider = h("input", {
      type: "range",
      min: "0",
      max: "1",
      step: "0.01",
      value: String(overlay.opacity),
      "aria-label": "Opacity of the overlay",
      oninput: () => {
        overlay.set({ opacity: slider.valueAsNumber });
        value.textContent = percent(overlay.opacity);
      },
    });
    const difference = h("button", { type: "button", onclick: () => this.app.view.set({ field: ABOVE }) }, "colour by the difference");
    this.element.replaceChildren(
      h("p", { className: "source" }, `${overlay.name}; not drawn while a field colours the surface`),
      h("div", { className: "row" }, h("span", {}, "opacity"), h("div", { className: "control" }, slider, value)),
      h(
        "div",
        { className: "buttons" },
        overlay.terrain && difference,
        h("button", { type: "button", onclick: () => overlaySheet(this.app) }, "another …"),
        h("button", { type: "button", onclick: () => removeOverlay(this.app) }, "remove"),
      ),
    );
  }

  /** Make the map of a terrain as soon as its heights are there. */
  private makeMap(): void {
    const { overlay, current } = this.app;
    const heights = current?.ready && overlay.terrain && !overlay.image ? current.fields.get(OVERLAY) : undefined;
    if (!heights) return;
    overlay.set({ image: shadedMap(this.app, current!, heights), limits: ends(heights) });
    this.app.view.need(OVERLAY, false);
  }

  /** A run on another lattice has no terrain over it any more. */
  private follow(): void {
    const { overlay, current } = this.app;
    const there = current?.description?.fields.some((field) => field.name === ABOVE);
    if (!overlay.terrain || there || current?.lost) return;
    this.app.note("warning", `${overlay.name} is no longer compared with: the run has another lattice, or was started again after a loss.`);
    removeOverlay(this.app);
  }
}

const percent = (share: number): string => `${Math.round(100 * share)} %`;

/** Ask for a file, and drape it over the surface. */
export function overlaySheet(app: App): void {
  const heights = app.files.heights;
  const input = h("input", { type: "file", accept: suffixesOf(app, "overlay").join(), required: true, "aria-label": "Terrain or photograph", onchange: () => show() });
  const as = h("select", { "aria-label": "Read as", onchange: () => show() }, h("option", { value: "photograph" }, "a photograph"), h("option", { value: "terrain" }, "heights"));
  const level = h("input", { type: "checkbox" });
  const ends = new HeightEnds(app.current!);
  const kind = sheetRow("read as", as);
  const levelled = sheetRow("compare forms only: both with the same mean height", level);
  const name = () => input.files?.[0]?.name ?? "";
  const terrain = () => !has(name(), PHOTOGRAPHS) || as.value === "terrain";
  const show = () => {
    kind.hidden = !isImage(name());
    levelled.hidden = !name() || !terrain();
    ends.element.hidden = levelled.hidden || !isImage(name());
  };
  const use: Submit = async (progress, signal) => {
    const file = input.files![0]!;
    refuseName(app, file.name, "overlay");
    if (!terrain()) return drape(app, file, signal);
    const between = isImage(file.name) ? ends.values : {};
    await compareWith(app, file, { level: level.checked, ...between }, progress, signal);
  };
  const words = `A photograph (PNG, JPEG, WebP) is stretched over the field, its upper edge in the north. A terrain (${heights.join(", ")}) is read as ground from a file is: an elevation model at its own scale from its south-west corner, which must cover the field.`;
  formDialog("Compare with a terrain or photograph", "drape it", use, h("p", {}, words), input, kind, levelled, ends.element);
  show();
}

async function drape(app: App, file: File, signal: AbortSignal): Promise<void> {
  const image = await photograph(file);
  signal.throwIfAborted();
  if (app.overlay.terrain) removeOverlay(app);
  app.overlay.set({ name: file.name, terrain: false, image, limits: null });
}

/** Let every run compare its surface with a terrain. */
async function compareWith(app: App, file: File, options: { [key: string]: Json }, progress: Progress, signal: AbortSignal): Promise<void> {
  await withKeptFile(app, file, progress, signal, async (kept) => {
    refuseContent(file.name, kept, "overlay");
    const { path, heights } = kept;
    const codes = heights?.codes ?? [];
    const request = { command: "overlay" as const, path, ...options, ...(codes.length ? { missing: codes } : {}) };
    await Promise.all(app.runs.map((run) => app.connection.ask({ ...request, run: run.name }, undefined, signal)));
  });
  app.overlay.set({ name: file.name, terrain: true, image: null, limits: null });
  for (const run of app.runs) run.fields.delete(OVERLAY);
  app.view.need(OVERLAY, true);
}

function removeOverlay(app: App): void {
  const { terrain } = app.overlay;
  app.overlay.set({ name: "", terrain: false, image: null, limits: null });
  app.view.need(OVERLAY, false);
  if (!terrain) return;
  if ([OVERLAY, ABOVE].includes(app.view.look.field)) app.view.set({ field: "natural" });
  app.send({ command: "overlay" });
}
