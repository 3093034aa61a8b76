/** What is written and drawn over a picture: title block, scale bar, compass, legend. */

import type { App } from "../core/app";
import { namesOf } from "../core/run";
import type { Shot } from "../scene/shots";
import type { Stage } from "../scene/stage";
import { heights, metres } from "./dom";
import { type Scale, drawBar, legendOf, scaleLength, scalesOf } from "./legend";
import { stepsOf, timesOf, windsOf } from "./steps";

/** What a picture may have over its scene. */
export interface Words {
  title: boolean;
  /** The first line of the title block; none where it is empty. */
  heading: string;
  scale: boolean;
  legend: boolean;
}

/** Height (pixels) of the picture for which sizes below are stated. */
const STATED = 1080;
const SIZES = { margin: 36, title: 34, text: 19, bar: 260, legend: 340 };
const FONT = '"Inter", system-ui, -apple-system, "Segoe UI", "Noto Sans", sans-serif';
const INKS = { light: { ink: "#2b2620", card: "rgb(251 248 242 / 74%)" }, dark: { ink: "#ece4d6", card: "rgb(38 35 32 / 74%)" } };

/** The lines of the title block: its heading; model, step and time; seed and version. */
export function titleLines(app: App, { statuses }: Pick<Shot, "statuses">, heading: string): string[] {
  const run = app.current;
  const [description, status] = [run?.description, run && statuses.get(run)];
  if (!description || !status) return [];
  const all = app.runs.map((one) => statuses.get(one));
  const time = timesOf(all);
  const seed = (description.scenario.run as { seed?: number }).seed;
  return [
    ...(heading ? [heading] : []),
    namesOf(app.runs).join("  |  "),
    `step ${stepsOf(all)}${time && ` · ${time}`} · seed ${seed ?? "–"} · Barchan ${app.version}`,
  ];
}

/** Draw what is wanted over a picture. */
export function drawWords(app: App, stage: Stage, shot: Shot, words: Words, dark: boolean): void {
  new Writer(app, stage, shot, dark ? INKS.dark : INKS.light).draw(words);
}

class Writer {
  private readonly c: CanvasRenderingContext2D;
  /** Pixels of a stated pixel. */
  private readonly u: number;
  private readonly margin: number;

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
    private readonly shot: Shot,
    private readonly inks: { ink: string; card: string },
  ) {
    this.c = shot.canvas.getContext("2d")!;
    const { width, height } = shot.canvas;
    this.u = Math.min(height / STATED, width / STATED);
    this.margin = SIZES.margin * this.u;
  }

  draw(words: Words): void {
    if (words.title) this.title(words.heading.trim());
    const above = words.scale ? this.scale() : this.shot.canvas.height - this.margin;
    if (words.legend) this.legends(above);
  }

  private font(size: number, weight = 400): void {
    this.c.font = `${weight} ${size * this.u}px ${FONT}`;
  }

  private card(x: number, y: number, width: number, height: number): void {
    this.c.fillStyle = this.inks.card;
    this.c.beginPath();
    this.c.roundRect(x, y, width, height, 8 * this.u);
    this.c.fill();
    this.c.fillStyle = this.c.strokeStyle = this.inks.ink;
  }

  private title(heading: string): void {
    const { c, u, margin } = this;
    const lines = titleLines(this.app, this.shot, heading).map((line, at) => (heading && !at ? { line, size: SIZES.title, weight: 600 } : { line, size: SIZES.text, weight: 400 }));
    const room = this.shot.canvas.width - 2 * margin - 160 * u;
    const fitted = lines.map(({ line, size, weight }) => {
      this.font(size, weight);
      const wide = c.measureText(line).width + 32 * u;
      return { line, weight, size: size * Math.min(1, room / wide), wide: Math.min(wide, room) };
    });
    const step = 1.42;
    const high = fitted.reduce((sum, { size }) => sum + step * size * u, 24 * u);
    this.card(margin, margin, Math.max(...fitted.map(({ wide }) => wide)), high);
    let y = margin + 10 * u;
    for (const { line, size, weight } of fitted) {
      y += step * size * u;
      this.font(size, weight);
      c.fillText(line, margin + 16 * u, y - 0.3 * size * u);
    }
  }

  /** Draw scale bar, exaggeration and compass; returns the height where the scale bar's card begins. */
  private scale(): number {
    const { c, u, margin } = this;
    const { canvas, metresPerPixel } = this.shot;
    const length = scaleLength(metresPerPixel * SIZES.bar * u);
    const wide = length / metresPerPixel;
    const text = `${metres(length)} · ${heights(this.stage.terrain(this.app.current!)?.exaggeration ?? 1)}`;
    this.font(SIZES.text);
    const [w, high] = [Math.max(wide, c.measureText(text).width) + 32 * u, 62 * u];
    const top = canvas.height - margin - high;
    this.card(margin, top, w, high);
    c.fillText(text, margin + 16 * u, top + 26 * u);
    c.lineWidth = 2.5 * u;
    c.beginPath();
    c.moveTo(margin + 16 * u, top + 36 * u);
    c.lineTo(margin + 16 * u, top + 48 * u);
    c.lineTo(margin + 16 * u + wide, top + 48 * u);
    c.lineTo(margin + 16 * u + wide, top + 36 * u);
    c.stroke();
    this.compass();
    return top - 12 * u;
  }

  private compass(): void {
    const { c, u, margin } = this;
    const [radius, half] = [44 * u, 66 * u];
    const statuses = this.app.runs.map((run) => this.shot.statuses.get(run));
    const winds = [...new Set(statuses.flatMap((status) => status?.wind ?? []))];
    c.save();
    c.translate(this.shot.canvas.width - margin - half, margin + radius);
    this.card(-half, -radius, 2 * half, 2 * radius + 30 * u);
    this.font(15);
    c.textAlign = "center";
    c.fillText(`wind from ${windsOf(statuses)}`, 0, radius + 20 * u, 2 * half - 8 * u);
    c.rotate(-this.shot.heading);
    c.lineWidth = 2 * u;
    for (let quarter = 0; quarter < 4; quarter++) {
      c.beginPath();
      c.moveTo(0, -0.86 * radius);
      c.lineTo(0, -0.72 * radius);
      if (quarter) c.stroke();
      else c.fillText("N", 0, -0.66 * radius);
      c.rotate(Math.PI / 2);
    }
    for (const [at, wind] of winds.entries()) this.arrow(wind, radius, at > 0);
    c.restore();
  }

  /** An arrow from the centre of a compass; that of the right one of two runs is fainter. */
  private arrow(wind: number, radius: number, faint: boolean): void {
    const { c, u } = this;
    c.save();
    c.globalAlpha = faint ? 0.5 : 1;
    c.rotate((wind * Math.PI) / 180);
    c.lineWidth = 4 * u;
    c.beginPath();
    c.moveTo(0, -0.5 * radius);
    c.lineTo(0, 0.3 * radius);
    c.stroke();
    c.beginPath();
    c.moveTo(0, 0.6 * radius);
    c.lineTo(-0.18 * radius, 0.25 * radius);
    c.lineTo(0.18 * radius, 0.25 * radius);
    c.fill();
    c.restore();
  }

  /** Draw the scales of the surfaces' colours, the feet of their cards at a height. */
  private legends(foot: number): void {
    const { runs } = this.app;
    for (const scale of scalesOf(this.app, (run) => this.stage.terrain(run)?.colouring)) this.legend(scale, foot, (scale.at * this.shot.canvas.width) / runs.length);
  }

  private legend({ colouring, of }: Scale, foot: number, from: number): void {
    const { c, u, margin } = this;
    const { title, marks } = legendOf(colouring);
    const [wide, high] = [SIZES.legend * u, 84 * u];
    const [left, top] = [from + margin + 16 * u, foot - high];
    this.card(from + margin, top, wide + 32 * u, high);
    this.font(SIZES.text);
    c.fillText(title + of, left, top + 25 * u, wide);
    drawBar(c, this.app.colours[colouring.map] ?? [], left, top + 34 * u, wide, 16 * u);
    c.fillStyle = this.inks.ink;
    this.font(16);
    marks.forEach((mark, at) => {
      const share = at / Math.max(marks.length - 1, 1);
      c.textAlign = share === 0 ? "left" : share === 1 ? "right" : "center";
      c.fillText(mark, left + share * wide, top + 72 * u);
    });
    c.textAlign = "left";
  }
}
