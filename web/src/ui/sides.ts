/** How each of two runs is drawn wherever both are: the same in every view, whichever panel is open. */

import type { Run } from "../core/run";

/** The colour of the theme of a run's lines, and the lengths of their dashes and gaps (pixels); none are full. */
export interface Side {
  colour: "left" | "right";
  dashes: number[];
}

export const LEFT: Side = { colour: "left", dashes: [] };
export const RIGHT: Side = { colour: "right", dashes: [6, 3] };

/** The side of a run; one that is alone is drawn as the left one. */
export function sideOf(run: Run): Side {
  return run.name === "b" ? RIGHT : LEFT;
}
