/** What a section marks of a profile: zones in shadow, and slopes about as steep as the material can stand. */

import type { Profile } from "../core/profile";
import type { Run } from "../core/run";
import { themeColour } from "../ui/dom";
import { RIGHT, type Side, sideOf } from "../ui/sides";

/** The share of the angle of repose from which a slope counts as near it. */
const NEAR = 0.85;
/** Distance of the lines of a hatching (pixels). */
const HATCH = 7;

/** A profile that is drawn, and whose it is. */
export interface Drawn {
  run: Run;
  profile: Profile;
}

export type Across = (distance: number) => number;

/** What fills the shadow zones: of the left run a tint, of the right one lines, so that both are seen where they overlap. */
export function shadowFill(c: CanvasRenderingContext2D, side: Side): string | CanvasPattern {
  if (side !== RIGHT) return themeColour("shadow");
  const tile = new OffscreenCanvas(HATCH, HATCH);
  const t = tile.getContext("2d")!;
  t.strokeStyle = themeColour(side.colour);
  for (const shift of [-HATCH, 0, HATCH]) {
    t.moveTo(shift, HATCH);
    t.lineTo(shift + HATCH, 0);
  }
  t.stroke();
  return c.createPattern(tile, "repeat")!;
}

/** Height of the strip that tells the shadow zones of one of two runs, and the distance of both (pixels). */
const STRIP = 7;
const BETWEEN = 2;

/** The shadow zones of two runs, a strip each below the top of the plot: over its whole height they would hide both lines. */
export function drawShadowStrips(c: CanvasRenderingContext2D, drawn: Drawn[], x: Across, top: number): void {
  drawn.forEach(({ run, profile }, at) => {
    const above = top + at * (STRIP + BETWEEN);
    drawShadows(c, profile, x, above, above + STRIP, sideOf(run));
  });
}

/** Fill the zones in shadow from the top of the plot to its foot. */
export function drawShadows(c: CanvasRenderingContext2D, p: Profile, x: Across, top: number, foot: number, side: Side): void {
  if (!p.shadow) return;
  c.fillStyle = shadowFill(c, side);
  let from = -1;
  p.distance.forEach((_, i) => {
    const dark = p.shadow![i]! > 0.5;
    if (dark && from < 0) from = i;
    if (from >= 0 && (!dark || i === p.distance.length - 1)) {
      c.fillRect(x(p.distance[from]!), top, x(p.distance[i]!) - x(p.distance[from]!), foot - top);
      from = -1;
    }
  });
}

/** The line of a surface, in red where it is near an angle of repose (degrees). */
export function drawSurface(c: CanvasRenderingContext2D, p: Profile, x: Across, y: (z: number) => number, repose: number | null, side: Side): void {
  const stroke = (colour: string, width: number, wanted: (i: number) => boolean) => {
    c.strokeStyle = themeColour(colour);
    c.lineWidth = width;
    c.beginPath();
    const to = (i: number): [number, number] => [x(p.distance[i]!), y(p.surface[i]!)];
    for (let i = 0; i + 1 < p.distance.length; i++) {
      if (!wanted(i)) continue;
      if (i === 0 || !wanted(i - 1)) c.moveTo(...to(i));
      c.lineTo(...to(i + 1));
    }
    c.stroke();
  };
  c.save();
  c.lineJoin = "round";
  c.setLineDash(side.dashes);
  stroke(side.colour, side === RIGHT ? 1.8 : 1.3, () => true);
  if (repose !== null) stroke("steep", 3, (i) => Math.abs(p.slope[i]!) >= NEAR * repose);
  c.restore();
}
