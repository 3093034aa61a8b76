/** Scale bars and colour bars: what stands on them, wherever they are drawn. */

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
export function legendOf({ title, unit, limits, choice }: Pick<Colouring, "title" | "unit" | "limits" | "choice">): { title: string; marks: string[] } {
  const [low, high] = limits;
  const [name, factor] = unit === "m" ? lengthUnit(Math.max(Math.abs(low), Math.abs(high))) : [unit, 1];
  const marks = choice ? ["no", "yes"] : [low, (low + high) / 2, high].map((mark) => short(factor * mark, 3));
  return { title: title + (name ? ` (${name})` : ""), marks };
}

/** The scale of a surface: which of the runs it belongs to, and what its title says of that. */
export interface Scale {
  colouring: Colouring;
  /** The number of the run, from the left. */
  at: number;
  /** Stands behind the title. */
  of: string;
}

/** The scales that the surfaces of runs need: one for both where it is the same, none where a surface has its material's colour. */
export function scalesOf(runs: Run[], colouringOf: (run: Run) => Colouring | null | undefined): Scale[] {
  const found = runs.flatMap((run, at): Scale[] => {
    const colouring = colouringOf(run);
    return colouring && !colouring.natural ? [{ colouring, at, of: "" }] : [];
  });
  const [first, second] = found;
  if (!first || !second) return found;
  const one = sameQuantity(first.colouring, second.colouring) && String(first.colouring.limits) === String(second.colouring.limits);
  return one ? [{ ...first, of: ", both runs" }] : found;
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
