/** Draws sections over time: a panel for each run, on one scale of colours and of steps. */

import { CHART_FONT, lengthUnit, short, themeColour, ticks, timeUnit } from "../ui/dom";
import { drawBar } from "../ui/legend";
import { type Bands, COLUMNS } from "./bands";

/** Above a panel is a line with the unit of its time and the name of its run. */
const MARGIN = { left: 62, right: 84, top: 22, bottom: 28, between: 14 };
/** Of the colour bar: its distance from the picture, and its width (pixels). */
const BAR = { gap: 14, width: 12 };
/** Rows of pixels of a panel at most. */
const MOST = 600;

export interface Panel {
  /** Stands above it; empty where there is one run. */
  name: string;
  /** The colour of the theme of its run. */
  colour: string;
  bands: Bands;
  /** Duration of a step (s), where it is known. */
  stepSeconds: number | null;
}

/** What all panels have in common. */
export interface Scales {
  colours: [number, number, number][];
  /** Lowest and highest elevation (m). */
  ends: [number, number];
  /** First and last step. */
  steps: [number, number];
  /** Length of the section (m). */
  length: number;
}

interface Box {
  x: number;
  y: number;
  w: number;
  d: number;
}

export function drawPanels(c: CanvasRenderingContext2D, panels: Panel[], scales: Scales, width: number, height: number): void {
  c.font = CHART_FONT;
  c.imageSmoothingEnabled = true;
  const { top } = MARGIN;
  const each = (width - MARGIN.right + MARGIN.between) / panels.length;
  panels.forEach(({ name, colour, bands, stepSeconds }, at) => {
    const box = { x: at * each + MARGIN.left, y: top, w: each - MARGIN.left - MARGIN.between, d: height - top - MARGIN.bottom };
    drawBands(c, bands, scales, box);
    const [label, step] = timeScale(scales.steps[1], stepSeconds);
    drawAxes(c, scales, step, box, height);
    c.textAlign = "left";
    c.fillText(label, at * each + 4, top - 10);
    c.fillStyle = themeColour(colour);
    c.textAlign = "right";
    c.fillText(name, box.x + box.w, top - 8, box.w - 20);
  });
  drawColourBar(c, scales, { x: width - MARGIN.right + BAR.gap, y: top, w: BAR.width, d: height - top - MARGIN.bottom }, width, height);
}

/** What stands above an axis of time whose last step is known, and how much of that a step is. */
function timeScale(last: number, stepSeconds: number | null): [string, number] {
  if (stepSeconds === null) return ["step", 1];
  const [unit, length] = timeUnit(last * stepSeconds);
  return [`time (${unit})`, stepSeconds / length];
}

/** The sections from the first to the last step of a run; what is later of the other one is left out. */
function drawBands(c: CanvasRenderingContext2D, { rows: bands }: Bands, { colours, ends: [low, high], steps: [first, last] }: Scales, { x, y, w, d }: Box): void {
  const rows = Math.max(1, Math.min(Math.round(d), MOST));
  const image = new ImageData(COLUMNS, rows);
  let band = 0;
  for (let row = 0; row < rows; row++) {
    const step = first + ((last - first) * row) / Math.max(rows - 1, 1);
    while (band < bands.length - 1 && bands[band + 1]!.step <= step) band++;
    const { step: shown, values } = bands[band]!;
    if (step < shown || (band === bands.length - 1 && step - shown > (last - first) / rows)) continue;
    const start = (rows - 1 - row) * COLUMNS * 4;
    for (let i = 0; i < COLUMNS; i++) {
      const share = (values[i]! - low) / (high - low || 1);
      image.data.set(colours[Math.min(Math.max(Math.round(share * (colours.length - 1)), 0), colours.length - 1)]!, start + 4 * i);
      image.data[start + 4 * i + 3] = 255;
    }
  }
  const picture = new OffscreenCanvas(COLUMNS, rows);
  picture.getContext("2d")!.putImageData(image, 0, 0);
  c.drawImage(picture, x, y, w, d);
}

function drawAxes(c: CanvasRenderingContext2D, { steps, length }: Scales, step: number, { x, y, w, d }: Box, height: number): void {
  const [first, last] = steps.map((one) => one * step) as [number, number];
  c.fillStyle = themeColour("faint");
  c.textAlign = "right";
  for (const tick of ticks(first, last, d / 36)) c.fillText(short(tick), x - 6, y + d - ((tick - first) / (last - first || 1)) * d + 4);
  c.textAlign = "center";
  c.fillText("distance (m)", x + w / 2, height - 2);
  for (const tick of ticks(0, length, w / 100)) c.fillText(short(tick), x + (tick / length) * w, height - MARGIN.bottom + 15);
}

function drawColourBar(c: CanvasRenderingContext2D, { colours, ends: [low, high] }: Scales, { x, y, w, d }: Box, width: number, height: number): void {
  const [unit, factor] = lengthUnit(Math.max(Math.abs(low), Math.abs(high)));
  drawBar(c, colours, x, y, w, d);
  c.fillStyle = themeColour("faint");
  c.textAlign = "left";
  for (const tick of ticks(low, high, d / 30)) {
    const at = y + d * (1 - (tick - low) / (high - low || 1));
    c.fillText(short(factor * tick, 3), x + w + 4, Math.min(Math.max(at + 4, y + 9), y + d));
  }
  c.textAlign = "right";
  c.fillText(`elevation (${unit})`, width - 2, height - 2);
}
