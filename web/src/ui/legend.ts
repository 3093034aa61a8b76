/** Scale bars and colour bars: what stands on them, wherever they are drawn. */

import type { Colouring } from "../scene/colouring";
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

/** Draw the colours of a scale from left to right, or where it is higher than wide from the foot to the top. */
export function drawBar(context: CanvasRenderingContext2D, colours: Colour[], x: number, y: number, width: number, height: number): void {
  const count = colours.length;
  colours.forEach((colour, i) => {
    context.fillStyle = `rgb(${colour.join()})`;
    if (height > width) context.fillRect(x, y + height * (1 - (i + 1) / count), width, height / count + 0.5);
    else context.fillRect(x + (i / count) * width, y, width / count + 0.5, height);
  });
}
