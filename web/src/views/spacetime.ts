/** The section over time: every step a row of the picture, crests that travel are slanted lines. */

import type { App } from "../core/app";
import { type Run, nameBeside } from "../core/run";
import { type SectionLine, along, samples } from "../core/section";
import { button, fitCanvas, h, lengthUnit, metres, short, themeColour, ticks } from "../ui/dom";
import { fetchFile } from "../ui/exports";
import { drawBar } from "../ui/legend";
import type { SectionView } from "./section";

const COLUMNS = 512;
const MOST_ROWS = 512;
/** Milliseconds after which the server is asked again for steps that the page has not seen. */
const RECALL = 4000;
const MARGIN = { left: 62, right: 84, top: 8, bottom: 28 };
/** Of the colour bar: its distance from the picture, and its width (pixels). */
const BAR = { gap: 14, width: 12 };

interface Band {
  step: number;
  values: Float32Array;
}

export class SpaceTimeView {
  readonly title = "Space–time";
  readonly element: HTMLElement;
  private readonly canvas = h("canvas", { className: "plot", role: "img", "aria-label": "The section over time" });
  private readonly caption = h("span", {});
  private readonly readout = h("output", { className: "readout" });
  private bands: Band[] = [];
  private every = 1;
  private recalled = Number.NEGATIVE_INFINITY;
  private line = "";
  private visible = false;

  constructor(
    private readonly app: App,
    private readonly section: SectionView,
  ) {
    this.element = h(
      "div",
      { className: "view" },
      h(
        "div",
        { className: "tools" },
        this.caption,
        button("Save a picture with colour bar, of the kept states (PNG)", "save picture", () => this.save(".png")),
        button("Save the elevations of the kept states as CSV", "save CSV", () => this.save(".csv")),
        this.readout,
      ),
      this.canvas,
    );
    app.framed.watch(() => this.collect());
    app.changed.watch(() => this.collect());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  show(visible: boolean): void {
    this.visible = visible;
    this.line = "";
    this.collect();
    this.draw();
  }

  /** Let the server write the section over all kept states up to the one that is shown. */
  private save(suffix: string): void {
    const run = this.app.current;
    if (!run?.ready) return;
    const request = { command: "space_time_file" as const, name: `space-time-${run.status!.step}${suffix}`, line: this.section.current(run), run: run.name };
    void fetchFile(this.app, request).catch((error) => this.app.refused(error));
  }

  /** Take the section of this moment in, if it is later than the last one; first of all those of the past. */
  private collect(): void {
    const run = this.app.current;
    if (!this.visible || !run?.ready || run.status!.looking) return;
    const lattice = run.description!.lattice;
    const line = this.section.current(run);
    const key = `${run.name} ${line.map((x) => x.toFixed(2))} ${run.rows} ${run.columns}`;
    const { step } = run.status!;
    if (key !== this.line || step < (this.bands.at(-1)?.step ?? 0)) {
      this.line = key;
      this.bands = [];
      this.every = 1;
      this.recalled = Number.NEGATIVE_INFINITY;
    }
    if (performance.now() - this.recalled > RECALL) void this.recall(run, line, key);
    if (this.bands.length && step - this.bands.at(-1)!.step < this.every) return;
    const values = along(run.surface, samples(line, lattice), lattice);
    this.bands.push({ step, values: resampled(values, COLUMNS) });
    this.thin();
    this.draw();
  }

  /** Ask the server for the section over the run's past. */
  private async recall(run: Run, line: SectionLine, key: string): Promise<void> {
    this.recalled = performance.now();
    const answer = await this.app.ask({ command: "space_time", run: run.name, line });
    if (!answer || key !== this.line) return;
    const bytes = Uint8Array.from(atob(String(answer.values)), (sign) => sign.charCodeAt(0));
    const numbers = new Uint16Array(bytes.buffer);
    const [columns, low, scale] = [Number(answer.columns), Number(answer.low), Number(answer.scale)];
    const past = (answer.steps as number[]).map((step, row) => ({
      step,
      values: Float32Array.from(numbers.subarray(row * columns, (row + 1) * columns), (number) => low + scale * number),
    }));
    const steps = new Set(past.map((band) => band.step));
    this.bands = [...past, ...this.bands.filter((band) => !steps.has(band.step))].sort((a, b) => a.step - b.step);
    this.thin();
    this.draw();
  }

  private thin(): void {
    if (this.bands.length <= MOST_ROWS) return;
    this.bands = this.bands.filter((_, at) => at % 2 === 0);
    this.every = Math.max(2 * this.every, (this.bands.at(-1)!.step - this.bands[0]!.step) / this.bands.length);
  }

  private draw(): void {
    if (!this.visible || !this.canvas.clientWidth || !this.bands.length) return;
    this.caption.textContent = `Elevation along the section${this.whose()}; time runs upwards.`;
    const { context: c, width, height } = fitCanvas(this.canvas);
    const [first, last] = [this.bands[0]!.step, this.bands.at(-1)!.step];
    const colours = this.app.colours.perceptual ?? [[0, 0, 0], [255, 255, 255]];
    const [w, d] = [width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom];
    const rows = Math.max(1, Math.min(Math.round(d), 600));
    const image = new ImageData(COLUMNS, rows);
    const [low, high] = this.ends();
    let band = 0;
    for (let row = 0; row < rows; row++) {
      const step = first + ((last - first) * row) / Math.max(rows - 1, 1);
      while (band < this.bands.length - 1 && this.bands[band + 1]!.step <= step) band++;
      const { values } = this.bands[band]!;
      const start = (rows - 1 - row) * COLUMNS * 4;
      for (let i = 0; i < COLUMNS; i++) {
        const share = (values[i]! - low) / (high - low || 1);
        const colour = colours[Math.min(Math.max(Math.round(share * (colours.length - 1)), 0), colours.length - 1)]!;
        image.data.set(colour, start + 4 * i);
        image.data[start + 4 * i + 3] = 255;
      }
    }
    const picture = new OffscreenCanvas(COLUMNS, rows);
    picture.getContext("2d")!.putImageData(image, 0, 0);
    c.imageSmoothingEnabled = true;
    c.drawImage(picture, MARGIN.left, MARGIN.top, w, d);
    this.axes(c, first, last, width, height, w, d);
    this.colourBar(c, colours, [low, high], width, d);
    this.readout.textContent = `${this.bands.length} sections, ${metres(low)} to ${metres(high)}`;
  }

  /** Of which of two runs it is: the one whose parameters the panel shows. */
  private whose(): string {
    const { runs, current } = this.app;
    return runs.length > 1 && current ? ` of ${nameBeside(current, runs.find((run) => run !== current))}, which the panel shows` : "";
  }

  private axes(c: CanvasRenderingContext2D, first: number, last: number, width: number, height: number, w: number, d: number): void {
    const run = this.app.current!;
    const [x0, y0, x1, y1] = this.section.current(run);
    const length = Math.hypot(x1 - x0, y1 - y0);
    c.font = "11px system-ui, sans-serif";
    c.fillStyle = themeColour("faint");
    c.textAlign = "right";
    for (const tick of ticks(first, last, d / 36)) {
      const y = MARGIN.top + d - ((tick - first) / Math.max(last - first, 1)) * d;
      c.fillText(short(tick), MARGIN.left - 6, y + 4);
    }
    c.textAlign = "center";
    for (const tick of ticks(0, length, width / 110)) {
      c.fillText(short(tick), MARGIN.left + (tick / length) * w, height - MARGIN.bottom + 15);
    }
    c.textAlign = "right";
    c.fillText("distance (m)", width - MARGIN.right, height - 2);
    c.textAlign = "left";
    c.fillText("step", 4, 14);
  }

  private colourBar(c: CanvasRenderingContext2D, colours: [number, number, number][], [low, high]: [number, number], width: number, d: number): void {
    const x = width - MARGIN.right + BAR.gap;
    const [unit, factor] = lengthUnit(Math.max(Math.abs(low), Math.abs(high)));
    drawBar(c, colours, x, MARGIN.top, BAR.width, d);
    c.fillStyle = themeColour("faint");
    c.textAlign = "left";
    for (const tick of ticks(low, high, d / 30)) {
      const y = MARGIN.top + d * (1 - (tick - low) / (high - low || 1));
      c.fillText(short(factor * tick, 3), x + BAR.width + 4, Math.min(Math.max(y + 4, MARGIN.top + 9), MARGIN.top + d));
    }
    c.fillText(`elevation (${unit})`, x - BAR.gap + 4, MARGIN.top + d + 15);
  }

  private ends(): [number, number] {
    let low = Number.POSITIVE_INFINITY;
    let high = Number.NEGATIVE_INFINITY;
    for (const { values } of this.bands) {
      for (const value of values) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return [low, high];
  }
}

function resampled(values: Float32Array, count: number): Float32Array {
  const found = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    const at = (i / (count - 1)) * (values.length - 1);
    const low = Math.min(Math.floor(at), Math.max(values.length - 2, 0));
    const share = at - low;
    found[i] = values[low]! * (1 - share) + values[Math.min(low + 1, values.length - 1)]! * share;
  }
  return found;
}
