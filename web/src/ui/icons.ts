/** Signs of buttons, drawn, so that they look alike whatever fonts a computer has. */

import { svg } from "./dom";

const PATHS = {
  play: "M4 2.5v11l9-5.5z",
  pause: "M4 2.5h3v11H4zM9 2.5h3v11H9z",
  step: "M3 2.5v11l7-5.5zM11 2.5h2v11h-2z",
  restart: "M8 3a5 5 0 1 1-4.6 3l1.5.6A3.4 3.4 0 1 0 8 4.6V7L4 3.8 8 .6z",
  now: "M2 2.5v11l5.5-5.5zM7 2.5v11l5.5-5.5zM12.5 2.5h1.6v11h-1.6z",
  beside: "M1.5 3h5.5v10H1.5zM3 4.5v7h2.5v-7zM9 3h5.5v10H9z",
  full: "M2 6V2h4v1.6H3.6V6zM10 2h4v4h-1.6V3.6H10zM2 10h1.6v2.4H6V14H2zM12.4 10H14v4h-4v-1.6h2.4z",
};

export type Icon = keyof typeof PATHS;

export function icon(name: Icon): HTMLElement {
  return svg("svg", { viewBox: "0 0 16 16", width: 14, height: 14, class: "icon", "aria-hidden": "true" }, svg("path", { d: PATHS[name], fill: "currentColor" })) as unknown as HTMLElement;
}
