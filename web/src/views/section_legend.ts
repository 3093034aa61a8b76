/** What the lines and colours of a section mean, above its plot, in as many lines as it takes. */

import { nameBeside } from "../core/run";
import { CHART_FONT, short, themeColour } from "../ui/dom";
import { type Side, sideOf } from "../ui/sides";
import { type Drawn, shadowFill } from "./section_marks";

const LINE = 17;
const SWATCH = 16;
const GAP = 16;
/** Between the last line and the plot. */
const FOOT = 7;

type Mark = "line" | "shadow" | "steep" | "steep area";

interface Swatch {
  side: Side;
  mark: Mark;
}

export interface Item {
  swatches: Swatch[];
  text: string;
}

/** What is drawn of a run, or of two along the same line: the left one first, in few words, for the plot is low. */
export function sectionItems(drawn: Drawn[]): Item[] {
  return [...(drawn.length > 1 ? pairItems(drawn) : aloneItems(drawn[0]!)), ...steepItems(drawn)];
}

function aloneItems({ run, profile }: Drawn): Item[] {
  return profile.shadow ? [{ swatches: [swatch(sideOf(run), "shadow")], text: "shadow zone" }] : [];
}

/** The line of each run, and its shadow zones beside it. */
function pairItems(drawn: Drawn[]): Item[] {
  return drawn.map(({ run, profile }, at) => {
    const side = sideOf(run);
    const name = nameBeside(run, drawn[1 - at]!.run);
    const line = swatch(side, "line");
    return profile.shadow ? { swatches: [line, swatch(side, "shadow")], text: `${name}, shadow zone` } : { swatches: [line], text: name };
  });
}

/** Where surfaces are marked as steep, in one item: of two runs in the manner of each line. */
function steepItems(drawn: Drawn[]): Item[] {
  const marked = drawn.filter(({ run }) => run.description!.repose !== null);
  if (!marked.length) return [];
  const pair = drawn.length > 1;
  const swatches = marked.map(({ run }) => swatch(sideOf(run), pair ? "steep" : "steep area"));
  const angles = [...new Set(marked.map(({ run }) => `${run.description!.repose!.toFixed(1)}°`))];
  if (pair) return [{ swatches, text: `near the effective repose, ${angles.join(" and ")}` }];
  const slabs = marked[0]!.run.description!.repose_slabs;
  return [{ swatches, text: `near the effective angle of repose, ${angles[0]}${slabs === null ? "" : ` (${short(slabs, 3)} ${slabs === 1 ? "slab" : "slabs"} a cell)`}` }];
}

const swatch = (side: Side, mark: Mark): Swatch => ({ side, mark });

/** Items in lines that are each no wider than `most`, by their widths. */
export function inLines<T>(items: T[], widthOf: (item: T) => number, most: number): T[][] {
  const lines: T[][] = [];
  let room = 0;
  for (const item of items) {
    const wide = widthOf(item);
    if (lines.length && wide <= room) lines.at(-1)!.push(item);
    else {
      lines.push([item]);
      room = most;
    }
    room -= wide;
  }
  return lines;
}

export class SectionLegend {
  private readonly lines: Item[][];

  /** ``left`` is what the title of the axis takes of the first line. */
  constructor(
    private readonly c: CanvasRenderingContext2D,
    private readonly right: number,
    left: number,
    items: Item[],
  ) {
    c.font = CHART_FONT;
    this.lines = inLines(items, (item) => this.wide(item), right - left);
  }

  /** What it takes above the plot (pixels). */
  get height(): number {
    return LINE * Math.max(this.lines.length, 1) + FOOT;
  }

  draw(): void {
    const { c } = this;
    c.font = CHART_FONT;
    c.textAlign = "left";
    this.lines.forEach((items, line) => {
      let x = this.right + GAP - items.reduce((sum, item) => sum + this.wide(item), 0);
      const y = LINE * (line + 0.5);
      for (const item of items) {
        item.swatches.forEach((one, at) => this.swatch(one, x + at * (SWATCH + 6), y));
        c.fillStyle = themeColour("ink");
        c.fillText(item.text, x + marks(item), y + 4);
        x += this.wide(item);
      }
    });
  }

  private wide(item: Item): number {
    return this.c.measureText(item.text).width + marks(item) + GAP;
  }

  private swatch({ side, mark }: Swatch, x: number, y: number): void {
    const { c } = this;
    const steep = mark.startsWith("steep");
    c.save();
    c.fillStyle = steep ? themeColour("steep") : shadowFill(c, side);
    c.strokeStyle = themeColour(steep ? "steep" : side.colour);
    if (mark === "shadow" || mark === "steep area") c.fillRect(x + 2, y - 4, SWATCH - 4, 8);
    else {
      c.lineWidth = steep ? 3 : 2;
      c.setLineDash(side.dashes);
      c.beginPath();
      c.moveTo(x, y);
      c.lineTo(x + SWATCH, y);
      c.stroke();
    }
    c.restore();
  }
}

/** What the swatches before an item's text take (pixels). */
function marks({ swatches }: Item): number {
  return swatches.length * (SWATCH + 6);
}
