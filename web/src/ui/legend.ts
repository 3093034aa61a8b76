/** Scale bars and colour bars: what stands on them, wherever they are drawn. */

import type { App } from "../core/app";
import type { Overlay } from "../core/overlay";
import type { Run } from "../core/run";
import { type Colouring, sameQuantity } from "../scene/colouring";
import { lengthUnit, short } from "./dom";

type Colour = [number, number, number];

/** The longest round length (m) within a length. */
export function scaleLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  return ([5, 2, 1].find((factor) => factor * power <= most) ?? 1) * power;
}

/** The title of a colour bar with its unit, and the numbers below it: lowest, middle, highest; or words of a choice. */
export function legendOf({ title, unit, limits, choice }: Omit<Shown, "map">): { title: string; marks: string[] } {
  const [low, high] = limits;
  const [name, factor] = unit === "m" ? lengthUnit(Math.max(Math.abs(low), Math.abs(high))) : [unit, 1];
  const marks = choice ? ["no", "yes"] : [low, (low + high) / 2, high].map((mark) => short(factor * mark, 3));
  return { title: title + (name ? ` (${name})` : ""), marks };
}

/** What a scale shows of a colouring. */
type Shown = Pick<Colouring, "title" | "unit" | "limits" | "choice" | "map">;

/** The scale of a surface: which of the runs it belongs to, and what its title says of that. */
export interface Scale {
  colouring: Shown;
  /** The number of the run, from the left. */
  at: number;
  /** Stands behind the title. */
  of: string;
}

/** The scales that the surfaces of runs need: one for both where it is the same; that of a draped terrain where surfaces have their material's colour. */
export function scalesOf({ runs, overlay }: App, colouringOf: (run: Run) => Colouring | null | undefined): Scale[] {
  const found = runs.flatMap((run, at) => {
    const colouring = colouringOf(run);
    return colouring && !colouring.natural ? [{ colouring, at, of: "" }] : [];
  });
  const [first, second] = found;
  if (!first) return scaleOfDraped(overlay);
  if (!second) return found;
  const one = sameQuantity(first.colouring, second.colouring) && String(first.colouring.limits) === String(second.colouring.limits);
  return one ? [{ ...first, of: ", both runs" }] : found;
}

function scaleOfDraped({ name, image, limits, opacity }: Overlay): Scale[] {
  if (!image || !limits || opacity === 0) return [];
  return [{ colouring: { title: `draped: elevation of ${name}`, unit: "m", limits, choice: false, map: "perceptual" }, at: 0, of: "" }];
}

/** Draw the colours of a scale from left to right, or where it is higher than wide from the foot to the top. */
export function drawBar(context: CanvasRenderingContext2D, colours: Colour[], x: number, y: number, width: number, height: number): void {
  const count = colours.length;
  colours.forEach((colour, i) => {
    context.fillStyle = `rgb(${colour.join()})`;
    if (height > width) context.fillRect(x, y + height * (1 - (i + 1) / count), width, height / count + 0.5);
    else context.fillRect(x + (i / count) * width, y, width / count + 0.5, height);
  });
}
