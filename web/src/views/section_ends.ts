/** The ends of the section as numbers: shown, and typed so that a section can be repeated. */

import type { App } from "../core/app";
import type { SectionLine } from "../core/section";
import { Coordinates } from "../ui/coordinates";
import { h } from "../ui/dom";
import { NumberField } from "../ui/number_field";

const LABELS = ["x of the section’s first end", "y of its first end", "x of its second end", "y of its second end"];

export class SectionEnds {
  readonly element: HTMLElement;
  private readonly inputs: NumberField[];
  private readonly coordinates: Coordinates;
  private line: SectionLine | null = null;

  /** ``take`` gets the line whose ends were typed. */
  constructor(
    private readonly app: App,
    private readonly take: (line: SectionLine) => void,
  ) {
    this.coordinates = new Coordinates(app, "Coordinates of the section’s ends", () => this.put(this.line));
    this.inputs = LABELS.map((label) => new NumberField({ label, signed: true, optional: true, grows: true, take: () => this.typed(), props: { title: `${label} (m)`, className: "end" } }));
    const [x0, y0, x1, y1] = this.inputs.map(({ element }) => element);
    this.element = h("span", { className: "ends" }, "from", x0!, y0!, "to", x1!, y1!, "m", this.coordinates.element);
  }

  /** Show a line's ends, unless they are being typed. */
  show(line: SectionLine): void {
    this.coordinates.offer();
    if (this.line?.join() === line.join() || this.element.contains(document.activeElement)) return;
    this.put(line);
  }

  private put(line: SectionLine | null): void {
    this.line = line;
    line?.forEach((_, at) => this.inputs[at]!.show(this.coordinates.shown(line, at)));
  }

  private typed(): void {
    const numbers = this.inputs.flatMap(({ number }) => number ?? []);
    if (!this.app.current?.description || numbers.length < LABELS.length) return;
    const line = this.coordinates.read(numbers, this.line);
    if (line[0] === line[2] && line[1] === line[3]) return;
    this.put(line);
    this.take(line);
  }
}
