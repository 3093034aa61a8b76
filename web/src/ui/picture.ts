/** The sheet that makes a picture of the scene: its size, light, and what is written over it. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import { type Shot, blobOf } from "../scene/shots";
import type { Stage } from "../scene/stage";
import { formDialog } from "./dialog";
import { download, h, later } from "./dom";
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
  private readonly width = h("input", { type: "number", min: String(LEAST), max: String(MOST), step: "1", required: true, "aria-label": "Width (pixels)", oninput: () => this.changed() });
  private readonly height = h("input", { type: "number", min: String(LEAST), max: String(MOST), step: "1", required: true, "aria-label": "Height (pixels)", oninput: () => this.changed() });
  private readonly light = h(
    "select",
    { "aria-label": "Light", onchange: () => this.changed() },
    ...["as the page", "day", "dusk"].map((text) => h("option", { value: text }, text)),
  );
  private readonly words: WordsRows;
  private readonly clear = h("input", { type: "checkbox", onchange: () => this.changed() });
  private readonly sheet: HTMLDialogElement;
  private drawing = false;
  private again = false;

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    const check = (text: string, box: HTMLInputElement) => h("label", { className: "check" }, box, text);
    this.words = wordsRows(app, stage, () => this.changed(), check("without sky and plain (transparent)", this.clear));
    const row = (text: string, ...controls: HTMLElement[]) => h("div", { className: "row" }, h("span", {}, text), h("div", { className: "control" }, ...controls));
    this.sheet = formDialog(
      "Picture",
      "save PNG",
      (progress, signal) => this.save(progress, signal),
      this.preview,
      row("size", this.size),
      row("width × height", this.width, h("span", {}, "×"), this.height, h("span", { className: "unit" }, "pixels")),
      row("light", this.light),
      this.words.element,
    );
    this.sheet.classList.add("picture");
    this.resize();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.stage.host;
    const ratio = window.devicePixelRatio || 1;
    const chosen = SIZES.find(([name]) => name === this.size.value)!;
    const free = chosen[0] === "free";
    this.width.readOnly = this.height.readOnly = !free;
    const [width, height] = chosen[2] ?? [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    if (!free) [this.width.value, this.height.value] = [String(width), String(height)];
    this.changed();
  }

  private readonly changed = later(SETTLED, () => void this.show());

  private get dark(): boolean {
    return this.light.value === "as the page" ? document.documentElement.dataset.theme === "dark" : this.light.value === "dusk";
  }

  /** The picture with its words; `share` of its size. */
  private async shot(share: number, progress?: Progress): Promise<Shot> {
    const [width, height] = [this.width, this.height].map((input) => Math.max(Math.round(input.valueAsNumber * share), 1)) as [number, number];
    const shot = await this.stage.shoot({ width, height, dark: this.dark, transparent: this.clear.checked, ...(progress ? { progress } : {}) });
    drawWords(this.app, this.stage, shot, this.words.chosen(), this.dark);
    return shot;
  }

  /** Draw the preview; what changes meanwhile is drawn after it. */
  private async show(): Promise<void> {
    this.again = this.drawing;
    if (this.drawing || !this.sheet.open || !this.width.validity.valid || !this.height.validity.valid) return;
    this.drawing = true;
    try {
      const share = Math.min(PREVIEW[0] / this.width.valueAsNumber, PREVIEW[1] / this.height.valueAsNumber, 1);
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
    download(`barchan-${shot.statuses.get(this.app.current!)?.step ?? 0}-${width}x${height}.png`, await blobOf(shot.canvas));
  }
}
