/** What the lines and colours of a section mean, in its upper right corner, in as many lines as it takes. */

import type { Profile } from "../core/profile";
import { type Run, nameBeside } from "../core/run";
import { short, themeColour } from "../ui/dom";
import { DASHES, shadowFill } from "./section_marks";
import type { Second } from "./second_profile";

const LINE = 17;
const SWATCH = 16;
const GAP = 16;

type Manner = "line" | "dashes" | "area" | "hatching";

interface Swatch {
  colour: string;
  manner: Manner;
}

export interface Item {
  swatches: Swatch[];
  text: string;
}

/** What is drawn of one run, or of two along the same line. */
export function sectionItems(run: Run, own: Profile, second: Second | null): Item[] {
  const items = second ? namesAndShadows(run, own, second) : own.shadow ? [{ swatches: [swatch("shadow", "area")], text: "shadow zone" }] : [];
  return [...items, ...steepItems(run, second)];
}

function namesAndShadows(run: Run, own: Profile, second: Second): Item[] {
  const [name, other] = [nameBeside(run, second.run), nameBeside(second.run, run)];
  const items: Item[] = [
    { swatches: [swatch("ink", "line")], text: name },
    { swatches: [swatch("second", "dashes")], text: other },
  ];
  if (own.shadow) items.push({ swatches: [swatch("shadow", "area")], text: `shadow zone of ${name}` });
  if (second.profile.shadow) items.push({ swatches: [swatch("second", "hatching")], text: `shadow zone of ${other}` });
  return items;
}

/** Where surfaces are marked as steep: of two runs in the manner of each line, in one item where their angle is the same. */
function steepItems(run: Run, second: Second | null): Item[] {
  const own = steepText(run);
  if (!second) return own === null ? [] : [{ swatches: [swatch("steep", "area")], text: own }];
  const other = steepText(second.run);
  const [line, dashes] = [swatch("steep", "line"), swatch("steep", "dashes")];
  if (own !== null && own === other) return [{ swatches: [line, dashes], text: own }];
  const of = (text: string | null, mark: Swatch, one: Run, beside: Run) => (text === null ? [] : [{ swatches: [mark], text: `${nameBeside(one, beside)}: ${text}` }]);
  return [...of(own, line, run, second.run), ...of(other, dashes, second.run, run)];
}

function steepText(run: Run): string | null {
  const { repose, repose_slabs: slabs } = run.description!;
  return repose === null ? null : `near the effective angle of repose, ${repose.toFixed(1)}°${slabs === null ? "" : ` (${short(slabs, 3)} slabs a cell)`}`;
}

const swatch = (colour: string, manner: Manner): Swatch => ({ colour, manner });

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

  draw(all: Item[]): void {
    const { c, margin } = this;
    const most = this.width - margin.left - margin.right - 80; // the layers' own words stand at the left
    const marks = ({ swatches }: Item) => swatches.length * (SWATCH + 6);
    const wide = (item: Item) => c.measureText(item.text).width + marks(item) + GAP;
    c.textAlign = "left";
    inLines(all, wide, most).forEach((items, line) => {
      let x = this.width - margin.right - items.reduce((sum, item) => sum + wide(item), 0);
      const y = margin.top + LINE * line;
      this.back(x, y);
      for (const item of items) {
        item.swatches.forEach((one, at) => this.swatch(one, x + at * (SWATCH + 6), y));
        c.fillStyle = themeColour("ink");
        c.fillText(item.text, x + marks(item), y + 4);
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

  private swatch({ colour, manner }: Swatch, x: number, y: number): void {
    const { c } = this;
    c.save();
    c.fillStyle = manner === "hatching" ? shadowFill(c, true) : themeColour(colour);
    c.strokeStyle = themeColour(colour);
    if (manner === "area" || manner === "hatching") c.fillRect(x + 2, y - 4, SWATCH - 4, 8);
    else {
      c.lineWidth = colour === "steep" ? 3 : 2;
      c.setLineDash(manner === "dashes" ? DASHES : []);
      c.beginPath();
      c.moveTo(x, y);
      c.lineTo(x + SWATCH, y);
      c.stroke();
    }
    c.restore();
  }
}
