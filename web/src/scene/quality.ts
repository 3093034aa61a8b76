/** How much the graphics card can be asked for: everything, or a plain scene for software rendering. */

import type { Look } from "../core/view";

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render|microsoft basic/i;
/** Pictures (ms each) that are too slow, and how many of them in a row decide. */
const SLOW = 55;
const ENOUGH = 24;

export class Quality {
  /** What the browser calls its graphics card. */
  readonly card: string;
  private tooSlow = false;
  private row = 0;
  private before = 0;

  constructor(context: WebGLRenderingContext | WebGL2RenderingContext) {
    const info = context.getExtension("WEBGL_debug_renderer_info");
    this.card = String(context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  }

  /** Whether a plain scene is drawn, as the look says or by itself. */
  plain(look: Pick<Look, "quality">): boolean {
    return look.quality === "plain" || (look.quality === "automatic" && (this.tooSlow || SOFTWARE.test(this.card)));
  }

  /** A picture was drawn now; `moving` where the one before was drawn in the frame before. Returns whether this decides. */
  drawn(now: number, moving: boolean): boolean {
    const took = now - this.before;
    this.before = now;
    this.row = moving && took > SLOW && took < 10 * SLOW ? this.row + 1 : 0;
    if (this.tooSlow || this.row < ENOUGH) return false;
    this.tooSlow = true;
    return true;
  }
}
