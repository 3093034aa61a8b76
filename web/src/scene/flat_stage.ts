/** The scene without WebGL: shaded maps from above, drawn by the processor. */

import type { App } from "../core/app";
import type { Run } from "../core/run";
import { Signal } from "../core/signal";
import type { Standpoint } from "./camera";
import { type Colouring, colouring } from "./colouring";
import { hillShade } from "./hill_shade";
import { type Ends, INKS } from "./line_mark";
import type { Shot, ShotOptions } from "./shots";
import type { Place } from "./pick";
import { type Lines, NO_LINES } from "./shown";
import { smoothingOf } from "./looks";
import { smoothed } from "./smooth";

/** Times that heights are drawn as steep as they are, unless chosen. */
const STEEPER = 2;
/** Where the sun stands (degrees), unless chosen: as on maps. */
const SUN = { azimuth: 315, height: 40 };
/** Pixels around a map. */
const MARGIN = 24;

interface Map {
  run: Run;
  /** One pixel a cell, north at the top. */
  picture: HTMLCanvasElement;
  extent: [number, number];
  exaggeration: number;
  colouring: Colouring | undefined;
}

/** What the page asks of its scene; answered as ``Stage`` does. */
export class FlatStage {
  readonly canvas = document.createElement("canvas");
  readonly controls = { enabled: true, touches: {} };
  readonly painted = new Signal<void>();
  steady = false;
  readonly fits = false;
  drawn = 0;
  private maps: Map[] = [];
  private dirty = true;
  private next = 0;
  private readonly resized = new ResizeObserver(() => this.redraw());
  private zoom = 1;
  private readonly lines: Lines = { section: null, ruler: null };
  private brush: [number, number, number] = [0, 0, 0];

  constructor(
    private readonly app: App,
    readonly host: HTMLElement,
  ) {
    this.canvas.className = "flat";
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The surface from above, shaded. + and − zoom.");
    host.prepend(this.canvas);
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.turn(0, 0, event.deltaY > 0 ? 1.1 : 0.9);
    });
    this.resized.observe(host);
    app.opened.watch(() => this.look());
    app.framed.watch(() => this.redraw());
    app.changed.watch(() => this.redraw());
    app.view.changed.watch(() => this.redraw());
    app.overlay.changed.watch(() => this.redraw());
    const tick = () => {
      if (this.dirty) this.draw();
      this.next = requestAnimationFrame(tick);
    };
    tick();
  }

  /** Draw no more. */
  dispose(): void {
    cancelAnimationFrame(this.next);
    this.resized.disconnect();
    this.canvas.remove();
  }

  look(_from = ""): void {
    this.zoom = 1;
    this.redraw();
  }

  standpoint(): Standpoint {
    return { viewpoint: "top", position: [], target: [], zoom: this.zoom };
  }

  stand({ viewpoint, zoom }: Standpoint): void {
    this.zoom = viewpoint === "top" && Number.isFinite(zoom) ? Math.min(Math.max(zoom, 1), 16) : 1;
    this.redraw();
  }

  /** Come nearer by a factor; a map cannot be turned. */
  turn(_around: number, _up: number, nearer = 1): void {
    this.zoom = Math.min(Math.max(this.zoom / nearer, 1), 16);
    this.redraw();
  }

  /** Of a map, which does not turn, there is nothing to keep. */
  keepWhole(): void {}

  redraw(): void {
    this.dirty = true;
  }

  terrain(run: Run): Map | undefined {
    return this.maps.find((map) => map.run === run);
  }

  showLine(of: keyof Lines, line: Ends | null): void {
    this.lines[of] = line;
    this.redraw();
  }

  showBrush(x: number, y: number, radius: number): void {
    this.brush = [x, y, radius];
    this.redraw();
  }

  pick(event: { clientX: number; clientY: number }): { run: Run; place: Place } | null {
    const box = this.canvas.getBoundingClientRect();
    for (const [at, map] of this.maps.entries()) {
      const { left, top, perMetre } = this.frame(at);
      const x = (event.clientX - box.left - left) / perMetre;
      const y = map.extent[1] - (event.clientY - box.top - top) / perMetre;
      if (x < 0 || y < 0 || x >= map.extent[0] || y >= map.extent[1]) continue;
      const { rows, columns } = map.run;
      const row = Math.floor((y / map.extent[1]) * rows);
      return { run: map.run, place: { x, y, row, column: Math.floor((x / map.extent[0]) * columns) } };
    }
    return null;
  }

  picture(): Promise<Blob> {
    this.draw();
    return new Promise((done) => this.canvas.toBlob((blob) => done(blob!), "image/png"));
  }

  /** A picture of any size of both maps. */
  async shoot({ width, height, lines = false }: ShotOptions): Promise<Shot> {
    this.draw();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width, height];
    this.drawMaps(canvas.getContext("2d")!, [width, height], lines ? this.lines : NO_LINES);
    const metresPerPixel = 1 / this.frame(0, [width, height]).perMetre;
    return { canvas, metresPerPixel, heading: 0, statuses: new Map(this.maps.map(({ run }) => [run, run.status!])) };
  }

  metresPerPixel(): number {
    return this.maps.length ? 1 / this.frame(0).perMetre : Number.NaN;
  }

  sun(): { azimuth: number; height: number } {
    const { sunAzimuth, sunHeight } = this.app.view.look;
    return { azimuth: sunAzimuth ?? SUN.azimuth, height: sunHeight ?? SUN.height };
  }

  heading(): number {
    return 0;
  }

  /** Place and scale (pixels a metre) of a map: side by side where there are two. */
  private frame(at: number, [across, up] = this.size): { left: number; top: number; perMetre: number } {
    const [width, height] = this.maps[at]!.extent;
    const share = across / this.maps.length;
    const perMetre = this.zoom * Math.min((share - 2 * MARGIN) / width, (up - 2 * MARGIN) / height);
    return { left: share * (at + 0.5) - (width * perMetre) / 2, top: (up - height * perMetre) / 2, perMetre };
  }

  /** Width and height on the page (pixels). */
  private get size(): [number, number] {
    return [this.canvas.clientWidth, this.canvas.clientHeight];
  }

  private draw(): void {
    this.dirty = false;
    this.maps = this.app.runs.filter((run) => run.ready).map((run) => this.update(run));
    const ratio = window.devicePixelRatio || 1;
    [this.canvas.width, this.canvas.height] = [this.host.clientWidth * ratio, this.host.clientHeight * ratio];
    [this.canvas.style.width, this.canvas.style.height] = [`${this.host.clientWidth}px`, `${this.host.clientHeight}px`];
    const context = this.canvas.getContext("2d")!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.drawMaps(context, this.size);
    this.app.confirm();
    this.drawn++;
    this.painted.send();
  }

  private update(run: Run): Map {
    const { lattice } = run.description!;
    const { look } = this.app.view;
    const picture = this.terrain(run)?.picture ?? document.createElement("canvas");
    [picture.width, picture.height] = [run.columns, run.rows];
    const surface = smoothed(run.surface, run.rows, run.columns, smoothingOf(run.material, look.smoothing), lattice.periodic);
    const exaggeration = look.exaggeration ?? STEEPER;
    const colours = colouring(this.app, run);
    picture.getContext("2d")!.putImageData(hillShade(this.app, run, surface, colours, exaggeration, this.sun(), this.host), 0, 0);
    return { run, picture, exaggeration, colouring: colours, extent: [run.columns * lattice.cell_size, run.rows * lattice.cell_size] };
  }

  private drawMaps(context: CanvasRenderingContext2D, size: [number, number], lines = this.lines): void {
    this.maps.forEach((_, at) => this.drawMap(context, at, size, lines));
  }

  private drawMap(context: CanvasRenderingContext2D, at: number, size: [number, number], lines: Lines): void {
    const { picture, extent, colouring: colours } = this.maps[at]!;
    const { left, top, perMetre } = this.frame(at, size);
    const [width, height] = [extent[0] * perMetre, extent[1] * perMetre];
    context.save();
    context.beginPath();
    const share = size[0] / this.maps.length;
    context.rect(share * at, 0, share, size[1]);
    context.clip();
    context.drawImage(picture, left, top, width, height);
    const { image, opacity } = this.app.overlay;
    context.globalAlpha = opacity;
    if (image && colours?.natural) context.drawImage(image, left, top, width, height);
    context.globalAlpha = 1;
    const on = (x: number, y: number): [number, number] => [left + x * width, top + (1 - y) * height];
    context.lineWidth = 2;
    for (const [line, ink] of [[lines.section, INKS.section], [lines.ruler, INKS.ruler]] as const) {
      if (!line) continue;
      context.strokeStyle = `#${ink.toString(16).padStart(6, "0")}`;
      context.beginPath();
      context.moveTo(...on(line[0], line[1]));
      context.lineTo(...on(line[2], line[3]));
      context.stroke();
    }
    context.strokeStyle = "#2f6d8c";
    context.beginPath();
    const [x, y, radius] = this.brush;
    if (radius > 0) {
      context.moveTo(on(x, y)[0] + radius * perMetre, on(x, y)[1]);
      context.arc(...on(x, y), radius * perMetre, 0, 2 * Math.PI);
    }
    context.stroke();
    context.restore();
  }
}
