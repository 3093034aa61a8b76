/** The sheet that makes a picture of the scene: its size, light, and what is written over it. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import { nameOfRun } from "../core/file_name";
import { isDusk } from "../scene/light";
import { type Shot, blobOf } from "../scene/shots";
import type { Stage } from "../scene/stage";
import { formDialog } from "./dialog";
import { download, h, later } from "./dom";
import { NumberField } from "./number_field";
import { drawWords } from "./picture_words";
import { type WordsRows, wordsRows } from "./words_rows";

/** Sizes (pixels) by name; of the window and free ones are filled in. */
const SIZES: [string, string, [number, number] | null][] = [
  ["window", "as the window", null],
  ["hd", "1920 × 1080", [1920, 1080]],
  ["4k", "3840 × 2160 (4K)", [3840, 2160]],
  ["free", "another size", null],
];
const LEAST = 64;
const MOST = 8192;
/** Pixels of the preview at most, across and up. */
const PREVIEW = [480, 270] as const;
const SETTLED = 250;

export function pictureSheet(app: App, stage: Stage): void {
  new PictureSheet(app, stage);
}

class PictureSheet {
  private readonly preview = h("canvas", { className: "preview", role: "img", "aria-label": "Preview of the picture" });
  private readonly size = h("select", { "aria-label": "Size", onchange: () => this.resize() }, ...SIZES.map(([value, text]) => h("option", { value }, text)));
  private readonly width = this.pixels("Width (pixels)");
  private readonly height = this.pixels("Height (pixels)");
  private readonly light = h(
    "select",
    { "aria-label": "Light", onchange: () => this.changed() },
    ...["as the scene", "day", "dusk"].map((text) => h("option", { value: text }, text)),
  );
  private readonly words: WordsRows;
  private readonly lines = h("input", { type: "checkbox", onchange: () => this.changed() });
  private readonly clear = h("input", { type: "checkbox", onchange: () => this.changed() });
  private readonly sheet: HTMLDialogElement;
  private drawing = false;
  private again = false;

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    const check = (text: string, box: HTMLInputElement) => h("label", { className: "check" }, box, text);
    this.words = wordsRows(app, stage, () => this.changed(), check("lines of section and ruler", this.lines), check("without sky and plain (transparent)", this.clear));
    const row = (text: string, ...controls: HTMLElement[]) => h("div", { className: "row" }, h("span", {}, text), h("div", { className: "control" }, ...controls));
    this.sheet = formDialog(
      "Picture",
      "save PNG",
      (progress, signal) => this.save(progress, signal),
      this.preview,
      row("size", this.size),
      row("width × height", this.width.element, h("span", {}, "×"), this.height.element, h("span", { className: "unit" }, "pixels")),
      row("light", this.light),
      this.words.element,
    );
    this.sheet.classList.add("picture");
    stage.steady = true; // what is saved is what the preview shows
    this.sheet.addEventListener("close", () => (stage.steady = false));
    this.resize();
  }

  private pixels(label: string): NumberField {
    return new NumberField({ label, whole: true, least: LEAST, most: MOST, typing: () => this.changed() });
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.stage.host;
    const ratio = window.devicePixelRatio || 1;
    const chosen = SIZES.find(([name]) => name === this.size.value)!;
    const free = chosen[0] === "free";
    this.width.element.readOnly = this.height.element.readOnly = !free;
    const [width, height] = chosen[2] ?? [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    if (!free) [width, height].forEach((side, at) => [this.width, this.height][at]!.show(side));
    this.changed();
  }

  private readonly changed = later(SETTLED, () => void this.show());

  private get dark(): boolean {
    return this.light.value === "as the scene" ? isDusk(this.app.view.look, this.stage.host) : this.light.value === "dusk";
  }

  /** The picture with its words; `share` of its size. */
  private async shot(share: number, progress?: Progress): Promise<Shot> {
    const [width, height] = [this.width, this.height].map((input) => Math.max(Math.round(input.number! * share), 1)) as [number, number];
    const shot = await this.stage.shoot({ width, height, dark: this.dark, transparent: this.clear.checked, lines: this.lines.checked, ...(progress ? { progress } : {}) });
    drawWords(this.app, this.stage, shot, this.words.chosen(), this.dark);
    return shot;
  }

  /** Draw the preview; what changes meanwhile is drawn after it. */
  private async show(): Promise<void> {
    this.again = this.drawing;
    const [width, height] = [this.width.number, this.height.number];
    if (this.drawing || !this.sheet.open || width === null || height === null) return;
    this.drawing = true;
    try {
      const share = Math.min(PREVIEW[0] / width, PREVIEW[1] / height, 1);
      const { canvas } = await this.shot(share);
      [this.preview.width, this.preview.height] = [canvas.width, canvas.height];
      this.preview.getContext("2d")!.drawImage(canvas, 0, 0);
    } finally {
      this.drawing = false;
    }
    if (this.again) await this.show();
  }

  private async save(progress: Progress, signal: AbortSignal): Promise<void> {
    const shot = await this.shot(1, (done, of) => {
      signal.throwIfAborted();
      progress(done, of);
    });
    const { width, height } = shot.canvas;
    download(`${nameOfRun(this.app.current)}-${shot.statuses.get(this.app.current!)?.step ?? 0}-${width}x${height}.png`, await blobOf(shot.canvas));
  }
}
