/** The side panel: folded and drawn out by a button or a key, made wider by its edge; where there is little room it lies over the scene. */

import { keep, stored } from "../core/stored";
import { h } from "./dom";
import { icon } from "./icons";

const KEY = "barchan-panel";
/** Width (pixels): the least that rows need, what they have at first, the most. */
const LEAST = 280;
const USUAL = 360;
const MOST = 720;
/** Pixels by which an arrow key moves the edge. */
const STEP = 20;
/** Where the panel lies over the scene, and is folded at first; the style sheet says the same. */
const NARROW = "(max-width: 999px)";

export class Side {
  readonly element: HTMLElement;
  readonly button: HTMLButtonElement;
  private readonly edge: HTMLElement;
  private width = USUAL;
  private folded = false;

  constructor(content: HTMLElement[]) {
    const { width, folded } = stored(KEY, { width: USUAL, folded: false });
    this.edge = h("div", { className: "edge", role: "separator", tabIndex: 0, "aria-orientation": "vertical", "aria-label": "Width of the panel", "aria-valuemin": LEAST, "aria-valuemax": MOST });
    this.element = h("aside", { className: "panel", id: "panel", "aria-label": "Panel" }, this.edge, ...content);
    this.button = h("button", { type: "button", title: "Panel (N)", "aria-label": "Panel (N)", "aria-controls": "panel", onclick: () => this.toggle() }, icon("panel"));
    this.edge.addEventListener("pointerdown", (event) => this.edge.setPointerCapture(event.pointerId));
    this.edge.addEventListener("pointermove", (event) => {
      if (this.edge.hasPointerCapture(event.pointerId)) this.resize(this.element.getBoundingClientRect().right - event.clientX);
    });
    this.edge.addEventListener("dblclick", () => this.resize(USUAL));
    this.edge.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: STEP, ArrowRight: -STEP }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      this.resize(this.width + by);
    });
    const narrow = matchMedia(NARROW);
    narrow.addEventListener("change", () => this.fold(narrow.matches, false));
    this.resize(width, false);
    this.fold(narrow.matches || folded, false);
  }

  toggle(): void {
    this.fold(!this.folded);
  }

  /** Draw the panel out where it is folded. */
  unfold(): void {
    if (this.folded) this.fold(false, false);
  }

  private fold(folded: boolean, keep = true): void {
    this.folded = folded;
    this.element.classList.toggle("folded", folded);
    this.button.setAttribute("aria-expanded", String(!folded));
    if (keep) this.keep();
  }

  private resize(width: number, keep = true): void {
    this.width = Math.round(Math.min(Math.max(width, LEAST), MOST));
    this.element.style.setProperty("--panel-width", `${this.width}px`);
    this.edge.setAttribute("aria-valuenow", String(this.width));
    if (keep) this.keep();
  }

  private keep(): void {
    keep(KEY, { width: this.width, folded: this.folded });
  }
}
