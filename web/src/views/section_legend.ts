/** What the lines and colours of a section mean, in its upper right corner, in as many lines as it takes. */

import { type Run, nameBeside } from "../core/run";
import { short, themeColour } from "../ui/dom";

const LINE = 17;
const SWATCH = 16;
const GAP = 16;

export interface Item {
  colour: string;
  text: string;
  /** Whether its line is dashed; no line, an area, where it is missing. */
  dashed?: boolean;
}

/** What is drawn of one run, or of two along the same line. */
export function sectionItems(run: Run, second: Run | undefined, shadow: boolean): Item[] {
  const { repose, repose_slabs: slabs } = run.description!;
  const name = nameBeside(run, second);
  const items: Item[] = [];
  if (second) items.push({ colour: "ink", text: name, dashed: false }, { colour: "second", text: nameBeside(second, run), dashed: true });
  if (shadow) items.push({ colour: "shadow", text: second ? `shadow zone of ${name}` : "shadow zone" });
  if (repose !== null) items.push({ colour: "steep", text: `near the effective angle of repose, ${repose.toFixed(1)}°${slabs === null ? "" : ` (${short(slabs, 3)} slabs a cell)`}` });
  return items;
}

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
  constructor(
    private readonly c: CanvasRenderingContext2D,
    private readonly margin: { left: number; right: number; top: number },
    private readonly width: number,
  ) {}

  draw(run: Run, second: Run | undefined, shadow: boolean): void {
    const { c, margin } = this;
    const most = this.width - margin.left - margin.right - 80; // the layers' own words stand at the left
    const wide = ({ text }: Item) => c.measureText(text).width + SWATCH + 6 + GAP;
    c.textAlign = "left";
    inLines(sectionItems(run, second, shadow), wide, most).forEach((items, line) => {
      let x = this.width - margin.right - items.reduce((sum, item) => sum + wide(item), 0);
      const y = margin.top + LINE * line;
      this.back(x, y);
      for (const item of items) {
        this.swatch(item, x, y);
        c.fillStyle = themeColour("ink");
        c.fillText(item.text, x + SWATCH + 6, y + 4);
        x += wide(item);
      }
    });
  }

  private back(x: number, y: number): void {
    const { c } = this;
    c.globalAlpha = 0.85;
    c.fillStyle = themeColour("card");
    c.fillRect(x - 6, y - 9, this.width - this.margin.right - x + 6 - GAP + 6, LINE + 1);
    c.globalAlpha = 1;
  }

  private swatch({ colour, dashed }: Item, x: number, y: number): void {
    const { c } = this;
    c.fillStyle = c.strokeStyle = themeColour(colour);
    if (dashed === undefined) return c.fillRect(x + 2, y - 4, SWATCH - 4, 8);
    c.save();
    c.lineWidth = 2;
    c.setLineDash(dashed ? [5, 3] : []);
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(x + SWATCH, y);
    c.stroke();
    c.restore();
  }
}
