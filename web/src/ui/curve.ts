/** An editor for a ramp in time: a cubic Bézier curve from its first to its last value.

Time runs from 0 to 1 along the curve, values from 0 (the first) to 1 (the last). Anything that goes
from one value to another over a time can use it.
*/

import { h, svg } from "./dom";

export interface Ramp {
  time_1: number;
  value_1: number;
  time_2: number;
  value_2: number;
}

export const STRAIGHT: Ramp = { time_1: 0.33, value_1: 0.33, time_2: 0.67, value_2: 0.67 };

const W = 240;
const H = 130;
const MARGIN = 14;
/** Values that the picture has room for. */
const LOW = -0.25;
const HIGH = 1.25;

export class CurveEditor {
  readonly element: HTMLElement;
  private readonly curve = svg("path", { class: "curve" });
  private readonly guides = [svg("line", { class: "guide" }), svg("line", { class: "guide" })];
  private readonly grips: SVGElement[];
  private readonly drawing: SVGElement;
  private readonly showGuides: HTMLInputElement;
  private ramp: Ramp;

  constructor(
    ramp: Ramp,
    labels: { of: string; from: string; to: string; duration: string },
    private readonly take: (ramp: Ramp) => void,
  ) {
    this.ramp = { ...ramp };
    this.grips = [1, 2].map((number) => this.grip(number as 1 | 2));
    this.drawing = svg(
      "svg",
      { viewBox: `0 0 ${W} ${H}`, class: "curve-editor", role: "group", "aria-label": `Curve of the ${labels.of}` },
      svg("rect", { x: MARGIN, y: this.y(1), width: W - 2 * MARGIN, height: this.y(0) - this.y(1), class: "frame" }),
      svg("text", { x: MARGIN + 3, y: this.y(0) - 4 }, labels.from),
      svg("text", { x: W - MARGIN - 3, y: this.y(1) + 11, class: "end" }, labels.to),
      svg("text", { x: W / 2, y: H - 2, class: "middle" }, labels.duration),
      ...this.guides,
      this.curve,
      ...this.grips,
    );
    this.showGuides = h("input", { type: "checkbox", checked: true, onchange: () => this.draw() });
    this.element = h(
      "div",
      { className: "curve-box" },
      this.drawing as unknown as HTMLElement,
      h(
        "div",
        { className: "curve-tools" },
        h("label", {}, this.showGuides, " guide lines"),
        h("button", { type: "button", className: "quiet", onclick: () => this.put(STRAIGHT) }, "reset points"),
      ),
    );
    this.draw();
  }

  private x(time: number): number {
    return MARGIN + time * (W - 2 * MARGIN);
  }

  private y(value: number): number {
    return MARGIN / 2 + ((HIGH - value) / (HIGH - LOW)) * (H - 1.5 * MARGIN);
  }

  private grip(number: 1 | 2): SVGElement {
    const grip = svg("circle", {
      r: 7,
      class: "grip",
      tabindex: 0,
      role: "slider",
      "aria-label": `Control point ${number}`,
      "data-point": number,
    });
    grip.addEventListener("pointerdown", (event) => grip.setPointerCapture((event as PointerEvent).pointerId));
    grip.addEventListener("pointermove", (event) => {
      if ((event as PointerEvent).buttons) this.drag(number, event as PointerEvent);
    });
    grip.addEventListener("keydown", (event) => this.nudge(number, event as KeyboardEvent));
    return grip;
  }

  private drag(number: 1 | 2, event: PointerEvent): void {
    const box = this.drawing.getBoundingClientRect();
    const time = (((event.clientX - box.left) / box.width) * W - MARGIN) / (W - 2 * MARGIN);
    const value = HIGH - ((((event.clientY - box.top) / box.height) * H - MARGIN / 2) / (H - 1.5 * MARGIN)) * (HIGH - LOW);
    this.move(number, time, value);
  }

  private nudge(number: 1 | 2, event: KeyboardEvent): void {
    const by = { ArrowLeft: [-0.02, 0], ArrowRight: [0.02, 0], ArrowUp: [0, 0.02], ArrowDown: [0, -0.02] }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    this.move(number, this.ramp[`time_${number}`] + by[0]!, this.ramp[`value_${number}`] + by[1]!);
  }

  private move(number: 1 | 2, time: number, value: number): void {
    const rounded = (x: number) => Math.round(x * 1000) / 1000;
    this.put({
      ...this.ramp,
      [`time_${number}`]: rounded(Math.min(Math.max(time, 0), 1)),
      [`value_${number}`]: rounded(Math.min(Math.max(value, LOW), HIGH)),
    });
  }

  private put(ramp: Ramp): void {
    this.ramp = { ...ramp };
    this.draw();
    this.take(this.ramp);
  }

  private draw(): void {
    const { time_1, value_1, time_2, value_2 } = this.ramp;
    const points: [number, number][] = [
      [this.x(0), this.y(0)],
      [this.x(time_1), this.y(value_1)],
      [this.x(time_2), this.y(value_2)],
      [this.x(1), this.y(1)],
    ];
    this.curve.setAttribute("d", `M${points[0]} C${points[1]} ${points[2]} ${points[3]}`);
    const ends: [number, number][] = [
      [0, 1],
      [3, 2],
    ];
    ends.forEach(([end, point], at) => {
      const guide = this.guides[at]!;
      const [x1, y1] = points[end]!;
      const [x2, y2] = points[point]!;
      for (const [name, value] of Object.entries({ x1, y1, x2, y2 })) guide.setAttribute(name, String(value));
      guide.setAttribute("visibility", this.showGuides?.checked === false ? "hidden" : "visible");
      this.grips[at]!.setAttribute("cx", String(x2));
      this.grips[at]!.setAttribute("cy", String(y2));
      const value = this.ramp[at ? "value_2" : "value_1"];
      this.grips[at]!.setAttribute("aria-valuenow", value.toFixed(2));
      this.grips[at]!.setAttribute("aria-valuetext", `time ${[time_1, time_2][at]!.toFixed(2)}, value ${value.toFixed(2)}`);
    });
  }
}
