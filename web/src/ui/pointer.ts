/** The mouse, or fingers, over the scene: they turn the view, paint, draw the line of a section, or measure. */

import { TOUCH } from "three";
import type { SectionLine } from "../core/section";
import type { Stage } from "../scene/stage";
import type { Hud } from "./hud";
import type { Paint } from "./paint";
import type { Ruler } from "./ruler";

const PAUSE = 40;
/** Pixels that the mouse may move between press and release of a click. */
const STILL = 5;

export class Pointer {
  private drawing = false;
  private from: [number, number] | null = null;
  private last = 0;
  /** Where the mouse was while painting, since it was followed last. */
  private trail: PointerEvent[] = [];
  /** Where the ruler was pressed on, on the page; null while nothing is pressed. */
  private pressed: PointerEvent | null = null;
  /** The finger that paints, as it was put down. */
  private finger: PointerEvent | null = null;

  constructor(
    private readonly stage: Stage,
    private readonly hud: Hud,
    private readonly paint: Paint,
    private readonly section: { put: (line: SectionLine | null) => void },
    private readonly ruler: Ruler,
  ) {
    const { canvas } = stage;
    canvas.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    canvas.addEventListener("pointerup", (event) => this.release(event), { capture: true });
    canvas.addEventListener("pointercancel", (event) => this.release(event), { capture: true });
    canvas.addEventListener("pointerleave", () => {
      hud.pointAt(null);
      stage.showBrush(0, 0, 0);
    });
    paint.onActive = (active) => this.choose(active ? "paint" : null);
    ruler.onActive = () => this.choose(ruler.active ? "ruler" : null);
  }

  /** The next drag draws the line of the section. */
  drawLine(): void {
    this.drawing = !this.drawing;
    this.choose(this.drawing ? "line" : null);
  }

  /** Of the brush, the line of the section and the ruler, the mouse has one. */
  private choose(tool: "paint" | "line" | "ruler" | null): void {
    if (tool !== null && tool !== "paint" && this.paint.active) this.paint.activate(false);
    if (tool !== null && tool !== "ruler" && this.ruler.active) this.ruler.toggle();
    if (tool !== null && tool !== "line") this.drawing = false;
    this.refresh();
  }

  private refresh(): void {
    this.stage.canvas.classList.toggle("painting", this.paint.active);
    this.stage.controls.touches.TWO = this.paint.active ? TOUCH.DOLLY_ROTATE : TOUCH.DOLLY_PAN; // where none paints one finger turns
    this.stage.canvas.classList.toggle("drawing", this.drawing || this.ruler.active);
    if (!this.paint.active) this.stage.showBrush(0, 0, 0);
  }

  private press(event: PointerEvent): void {
    if (!event.isPrimary) return this.finger ? this.turnInstead(this.finger) : undefined; // further fingers are the camera's
    if (event.button !== 0 || event.altKey || !(this.paint.active || this.drawing || this.ruler.active)) return;
    const found = this.stage.pick(event);
    if (!found && !this.paint.active) return;
    this.stage.controls.enabled = false; // with a brush beside the field as well, which one may miss
    this.stage.canvas.setPointerCapture(event.pointerId);
    if (this.paint.active && event.pointerType === "touch") this.finger = event;
    if (!found) return;
    if (this.paint.active) this.paint.press(found.run, found.place);
    else if (this.drawing) this.from = [found.place.x, found.place.y];
    else {
      this.pressed = event;
      this.ruler.press(found.place.x, found.place.y);
    }
  }

  /** A second finger was put down: with the first one it turns the view, and what that has painted is taken back. */
  private turnInstead(first: PointerEvent): void {
    this.finger = null;
    this.trail = [];
    this.paint.takeBack();
    this.stage.controls.enabled = true;
    const { pointerId, pointerType, clientX, clientY } = first;
    this.stage.canvas.dispatchEvent(new PointerEvent("pointerdown", { pointerId, pointerType, clientX, clientY })); // the camera was not told of it
  }

  private move(event: PointerEvent): void {
    if (this.paint.active && event.buttons & 1) this.trail.push(...(event.getCoalescedEvents?.() ?? []), event);
    if (event.timeStamp - this.last < PAUSE) return;
    this.last = event.timeStamp;
    this.hud.pointAt(event);
    const found = this.paint.active || this.from || this.ruler.active ? this.stage.pick(event) : null;
    if (this.paint.active) {
      const [width, depth] = found ? this.stage.terrain(found.run)!.extent : [1, 1];
      if (found) this.stage.showBrush(found.place.x / width, found.place.y / depth, this.paint.size);
      else this.stage.showBrush(0, 0, 0);
      this.follow();
    } else if (found && this.from) {
      const { x, y } = found.place;
      if (Math.hypot(x - this.from[0], y - this.from[1]) > 0) this.section.put([...this.from, x, y]);
    } else if (found && this.ruler.active && !event.buttons === !this.pressed) this.ruler.move(found.place.x, found.place.y);
  }

  /** Paint along all places where the mouse was since it was followed last. */
  private follow(): void {
    for (const event of this.trail.splice(0)) {
      const found = this.stage.pick(event);
      if (found) this.paint.move(found.place);
    }
  }

  private release(event: PointerEvent): void {
    this.stage.controls.enabled = true;
    this.finger = null;
    this.follow();
    if (this.paint.active) this.paint.release();
    if (this.pressed) {
      this.ruler.release(Math.hypot(event.clientX - this.pressed.clientX, event.clientY - this.pressed.clientY) > STILL);
      this.pressed = null;
    }
    if (this.from) {
      this.from = null;
      this.drawing = false;
      this.refresh();
    }
    if (this.stage.canvas.hasPointerCapture(event.pointerId)) this.stage.canvas.releasePointerCapture(event.pointerId);
  }
}
