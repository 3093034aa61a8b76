/** The signs on buttons, drawn as lines so that they look alike with every font. */

import { svg } from "./dom";

/** Paths in a square of 16 units; filled where they are closed. */
const SHAPES = {
  run: ["M4 2.5 L13 8 L4 13.5 Z"],
  pause: ["M4 3 H6.5 V13 H4 Z", "M9.5 3 H12 V13 H9.5 Z"],
  step: ["M3 3 L10 8 L3 13 Z", "M11.5 3 H13 V13 H11.5 Z"],
  restart: ["M12.8 5.2 A5.5 5.5 0 1 0 13.5 8", "M13.6 2 V5.6 H10"],
  back: ["M5.5 3 L2.5 6 L5.5 9", "M2.5 6 H9.5 A3.5 3.5 0 0 1 9.5 13 H6"],
  up: ["M8 13 V3", "M4 7 L8 3 L12 7"],
  down: ["M8 3 V13", "M4 9 L8 13 L12 9"],
  eye: ["M1 8 C3.5 3 12.5 3 15 8 C12.5 13 3.5 13 1 8 Z", "M8 5.8 A2.2 2.2 0 1 0 8.01 5.8"],
  pen: ["M3 13 L4 9.5 L10.5 3 L13 5.5 L6.5 12 L3 13", "M9 4.5 L11.5 7"],
  remove: ["M4 4 L12 12", "M12 4 L4 12"],
  latest: ["M3 3 L10 8 L3 13 Z", "M12 3 V13"],
  beside: ["M2 3 H7 V13 H2 Z", "M9 3 H14 V13 H9 Z"],
  panel: ["M2 3 H14 V13 H2 Z M10 3 V13"],
  full: ["M6 2.5 H2.5 V6", "M10 2.5 H13.5 V6", "M6 13.5 H2.5 V10", "M10 13.5 H13.5 V10"],
  ruler: ["M1.5 10.5 L10.5 1.5 L14.5 5.5 L5.5 14.5 Z", "M4.5 7.5 L6.5 9.5", "M7.5 4.5 L9 6"],
} as const;

export type Icon = keyof typeof SHAPES;

const OUTLINES = new Set<Icon>(["panel", "beside", "eye", "ruler"]);

export function icon(name: Icon): SVGElement {
  const paths = SHAPES[name].map((d) => svg("path", { d, class: d.endsWith("Z") && !OUTLINES.has(name) ? "solid" : "line" }));
  return svg("svg", { viewBox: "0 0 16 16", class: "icon", "aria-hidden": "true" }, ...paths);
}
