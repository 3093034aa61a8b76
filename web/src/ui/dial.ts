/** A dial for directions: where the wind comes from, clockwise from north. */

import { h, svg } from "./dom";
import { NumberField } from "./number_field";

const R = 46;

export class Dial {
  readonly element: HTMLElement;
  private readonly arrow: SVGElement;
  private readonly input: NumberField;
  private value = 270;

  /** Of the direction at a path within the wind. */
  constructor(label: string, path: (string | number)[], private readonly take: (direction: number) => void, size = 120) {
    this.arrow = svg(
      "g",
      { class: "needle" },
      svg("line", { x1: 0, y1: -R + 6, x2: 0, y2: 18 }),
      svg("path", { d: "M0 26 L-7 12 L7 12 Z" }),
      svg("circle", { cx: 0, cy: -R + 6, r: 6, class: "grip" }),
    );
    const marks = Array.from({ length: 16 }, (_, i) =>
      svg("line", { x1: 0, y1: -R, x2: 0, y2: i % 4 ? -R + 3 : -R + 6, transform: `rotate(${i * 22.5})`, class: "mark" }),
    );
    const names = ["N", "E", "S", "W"].map((name, i) =>
      svg("text", { x: Math.sin((i * Math.PI) / 2) * (R + 9), y: -Math.cos((i * Math.PI) / 2) * (R + 9) + 3.5 }, name),
    );
    const face = svg(
      "svg",
      { viewBox: "-62 -62 124 124", width: size, height: size, class: "dial" },
      svg("circle", { cx: 0, cy: 0, r: R, class: "face" }),
      ...marks,
      ...names,
      this.arrow,
    );
    face.addEventListener("pointerdown", (event) => this.drag(event as PointerEvent, face));
    face.addEventListener("pointermove", (event) => {
      if ((event as PointerEvent).buttons) this.turn(event as PointerEvent, face);
    });
    this.input = new NumberField({ label, take: (direction) => this.choose(direction!), props: { title: label, "data-path": path.join(".") } });
    this.element = h("div", { className: "dial-box" }, face as unknown as HTMLElement, h("label", {}, "from ", this.input.element, " °"));
  }

  show(direction: number): void {
    this.value = direction;
    this.arrow.setAttribute("transform", `rotate(${direction})`);
    if (document.activeElement !== this.input.element) this.input.show(Number(direction.toFixed(1)));
  }

  private drag(event: PointerEvent, face: Element): void {
    face.setPointerCapture(event.pointerId);
    this.turn(event, face);
  }

  private turn(event: PointerEvent, face: Element): void {
    const box = face.getBoundingClientRect();
    const x = event.clientX - (box.left + box.width / 2);
    const y = event.clientY - (box.top + box.height / 2);
    const angle = (Math.atan2(x, -y) * 180) / Math.PI;
    this.choose(event.shiftKey ? angle : Math.round(angle / 5) * 5);
  }

  private choose(direction: number): void {
    const next = ((direction % 360) + 360) % 360;
    if (next === this.value || !Number.isFinite(next)) return;
    this.show(next);
    this.take(next);
  }
}
