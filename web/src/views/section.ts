/** The cross-section along a line: profile, shadow zones, slopes; it follows the run. */

import type { App } from "../core/app";
import { nameOfRun } from "../core/file_name";
import type { Run } from "../core/run";
import { type Profile, ends, nearest, profile } from "../core/profile";
import { type SectionLine, alongWind } from "../core/section";
import type { Stage } from "../scene/stage";
import { nameBeside } from "../core/run";
import { SectionEnds } from "./section_ends";
import { SectionLegend, sectionItems } from "./section_legend";
import { type Drawn, drawShadowStrips, drawShadows, drawSurface } from "./section_marks";
import { type Second, placed, secondProfile, sectionCsv } from "./second_profile";
import { SectionLayers } from "./strata";
import { CHART_FONT, button, download, fitCanvas, h, heights, lengthUnit, metres, short, themeColour, ticks } from "../ui/dom";
import { sideOf } from "../ui/sides";
import { stepsOf } from "../ui/steps";

const MARGIN = { left: 54, right: 14, bottom: 30 };
/** What the title of the axis of heights takes above the plot (pixels). */
const AXIS_TITLE = 90;
/** How opaque the left one of two runs is filled, so that the lines of both stand out from it. */
const FILLED_OF_TWO = 0.45;
/** A layer deeper than this multiple of its relief is not shown down to the ground. */
const DEEP = 3;

export class SectionView {
  readonly title = "Section";
  readonly element: HTMLElement;
  /** The line that was dragged; null: along the wind through the middle. */
  line: SectionLine | null = null;
  /** The line along the wind that blew when the run, or its wind, was last changed. */
  private downwind: SectionLine | null = null;
  private readonly canvas = h("canvas", { className: "plot", role: "img", "aria-label": "Profile along the section" });
  private readonly readout = h("output", { className: "readout" });
  private hover: number | null = null;
  private visible = false;
  private readonly layers: SectionLayers;
  private readonly ends: SectionEnds;

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
    drawLine: () => void,
  ) {
    this.layers = new SectionLayers(app, () => this.draw());
    this.ends = new SectionEnds(app, (line) => this.put(line));
    this.element = h(
      "div",
      { className: "view" },
      h(
        "div",
        { className: "tools" },
        button("Drag a line over the field (L)", "draw a line", drawLine),
        button("Along the wind through the middle", "along the wind", () => this.put(null)),
        button("Save the section as CSV", "save CSV", () => this.save()),
        this.ends.element,
        this.layers.choice,
        this.readout,
      ),
      this.canvas,
    );
    this.canvas.addEventListener("pointermove", (event) => {
      this.hover = event.offsetX;
      this.draw();
    });
    this.canvas.addEventListener("pointerleave", () => {
      this.hover = null;
      this.draw();
    });
    app.opened.watch(() => (this.line = null)); // it was drawn over another field
    app.described.watch(() => (this.downwind = null));
    app.framed.watch((run) => {
      if (run === app.current && run.ready) this.downwind ??= alongWind(run.status!.wind, run.description!.lattice);
      this.draw();
    });
    app.changed.watch(() => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  show(visible: boolean): void {
    this.visible = visible;
    this.app.view.need("shadow", visible);
    this.mark();
    this.draw();
  }

  put(line: SectionLine | null): void {
    this.line = line;
    this.downwind = null;
    this.mark();
    this.draw();
  }

  /** The line as it is now. */
  current(run: Run): SectionLine {
    return this.line ?? this.downwind ?? alongWind(run.status!.wind, run.description!.lattice);
  }

  private mark(): void {
    const run = this.app.current;
    if (!this.visible || !run?.ready) return this.stage.showLine("section", null);
    const [x0, y0, x1, y1] = this.current(run);
    const { columns, rows, cell_size } = run.description!.lattice;
    const [w, d] = [columns * cell_size, rows * cell_size];
    this.ends.show([x0, y0, x1, y1]);
    this.stage.showLine("section", [x0 / w, y0 / d, x1 / w, y1 / d]);
  }

  private save(): void {
    const run = this.app.current;
    if (!run?.ready) return;
    const line = this.current(run);
    download(`${nameOfRun(run)}-section-${run.status!.step}.csv`, sectionCsv(run, profile(run, line), secondProfile(this.app, run, line)));
  }

  private draw(): void {
    const run = this.app.current;
    if (!this.visible || !run?.ready || !this.canvas.clientWidth) return;
    this.mark();
    const { context: c, width, height } = fitCanvas(this.canvas);
    const p = profile(run, this.current(run));
    const { length } = p;
    const second = secondProfile(this.app, run, this.current(run));
    let [low, high] = ends(p.surface);
    if (second) [low, high] = [Math.min(low, second.ends[0]), Math.max(high, second.ends[1])];
    high = Math.max(high, this.layers.highest(run, this.current(run)));
    const foot = Math.min(...ends(p.ground));
    if (low - foot < DEEP * (high - low)) low = foot;
    const room = Math.max((high - low) * 0.12, run.description!.lattice.thickness);
    [low, high] = [low - room * 0.6, high + room];
    const x = (d: number) => MARGIN.left + (d / length) * (width - MARGIN.left - MARGIN.right);
    const drawn: Drawn[] = [{ run, profile: p }, ...(second ? [second] : [])].sort((one, other) => one.run.name.localeCompare(other.run.name));
    const legend = new SectionLegend(c, width - MARGIN.right, AXIS_TITLE, sectionItems(drawn));
    const y = (z: number) => height - MARGIN.bottom - ((z - low) / (high - low)) * (height - legend.height - MARGIN.bottom);
    this.axes(c, x, y, length, [low, high], width, height);
    const area = (values: Float32Array, colour: string) => {
      c.beginPath();
      c.moveTo(x(0), y(low));
      const half = p.cells ? p.distance[0]! : 0;
      values.forEach((z, i) => [-half, half].forEach((aside) => c.lineTo(x(p.distance[i]! + aside), y(Math.max(z, low)))));
      c.lineTo(x(length), y(low));
      c.closePath();
      c.fillStyle = colour;
      c.fill();
    };
    if (second) drawShadowStrips(c, drawn, x, y(high));
    else drawShadows(c, p, x, y(high), y(low), sideOf(run));
    const layered = this.layers.draw(c, run, this.current(run), x, y, low);
    c.globalAlpha = second ? FILLED_OF_TWO : 1;
    if (!layered) area(drawn[0]!.profile.surface, themeColour(drawn[0]!.run.material === "snow" ? "snow" : "loose"));
    c.globalAlpha = 1;
    area(p.ground, themeColour("rock"));
    for (const one of drawn) if (!layered || one.run !== run) drawSurface(c, one.profile, x, y, one.run.description!.repose, sideOf(one.run));
    legend.draw();
    if (layered) this.layers.legend(c, run, MARGIN.left + 60, legend.height);
    this.point(c, p, x, y, length, width, run, second);
  }

  private axes(
    c: CanvasRenderingContext2D,
    x: (d: number) => number,
    y: (z: number) => number,
    length: number,
    [low, high]: [number, number],
    width: number,
    height: number,
  ): void {
    c.font = CHART_FONT;
    c.fillStyle = themeColour("faint");
    c.strokeStyle = themeColour("line");
    c.lineWidth = 1;
    c.textAlign = "right";
    const [unit, factor] = lengthUnit(Math.max(Math.abs(low), Math.abs(high)));
    for (const tick of ticks(low, high, height / 40)) {
      c.beginPath();
      c.moveTo(MARGIN.left, y(tick));
      c.lineTo(width - MARGIN.right, y(tick));
      c.stroke();
      c.fillText(short(factor * tick), MARGIN.left - 6, y(tick) + 4);
    }
    c.textAlign = "center";
    for (const tick of ticks(0, length, width / 110)) c.fillText(short(tick), x(tick), height - MARGIN.bottom + 15);
    c.textAlign = "right";
    c.fillText("distance (m)", width - MARGIN.right, height - 3);
    c.textAlign = "left";
    c.fillText(`elevation (${unit})`, 4, 10);
    const times = (y(low) - y(high)) / (high - low) / ((x(length) - x(0)) / length);
    c.fillText(heights(times), MARGIN.left, height - 3);
  }

  private point(
    c: CanvasRenderingContext2D,
    p: Profile,
    x: (d: number) => number,
    y: (z: number) => number,
    length: number,
    width: number,
    run: Run,
    second: Second | null,
  ): void {
    const cells = `${short(length)} m long, step ${stepsOf(second ? this.app.runs.map((one) => one.status) : [run.status])}`;
    if (this.hover === null) {
      this.readout.textContent = cells;
      return;
    }
    const share = (this.hover - MARGIN.left) / (width - MARGIN.left - MARGIN.right);
    const i = nearest(p, share * length);
    drawPoint(c, x(p.distance[i]!), y(p.surface[i]!), sideOf(run).colour);
    const lee = p.shadow && p.shadow[i]! > 0.5 ? ", in shadow" : "";
    const own =
      `elevation ${metres(p.surface[i])}, ${run.material} ${metres(p.surface[i]! - p.ground[i]!)}, ` +
      `slope ${p.slope[i]!.toFixed(1)}°${lee}${this.layers.under(p.distance[i]!, run)}`;
    if (second) drawPoint(c, x(p.distance[i]!), y(second.profile.surface[i]!), sideOf(second.run).colour);
    const both = second ? `${nameBeside(run, second.run)}: ${own} · ${placed(second, run, i)}` : own;
    this.readout.textContent = `${short(p.distance[i])} m: ${both}`;
  }
}

function drawPoint(c: CanvasRenderingContext2D, x: number, y: number, colour: string): void {
  c.fillStyle = themeColour(colour);
  c.beginPath();
  c.arc(x, y, 4, 0, 7);
  c.fill();
}
