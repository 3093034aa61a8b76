/** The scene that a browser can draw: in three dimensions with WebGL, else as shaded maps. */

import type { App } from "../core/app";
import { FlatStage } from "./flat_stage";
import { Stage } from "./stage";

/** All that the page asks of its scene. */
type Asked = "canvas" | "painted" | "steady" | "fits" | "drawn" | "look" | "standpoint" | "stand" | "turn" | "keepWhole" | "redraw" | "showLine" | "showBrush" | "pick" | "picture" | "shoot" | "host" | "metresPerPixel" | "heading" | "dispose";

export function sceneIn(host: HTMLElement, app: App): Stage {
  try {
    return new Stage(app, host);
  } catch {
    app.note("warning", "This browser draws no three-dimensional pictures (WebGL is off or missing): the surface is shown from above.");
    const flat: Pick<Stage, Asked> = new FlatStage(app, host);
    app.flat = true;
    return flat as Stage;
  }
}
