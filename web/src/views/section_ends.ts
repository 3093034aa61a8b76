/** The ends of the section as numbers: shown, and typed so that a section can be repeated. */

import type { App } from "../core/app";
import type { Place } from "../core/protocol";
import type { SectionLine } from "../core/section";
import { h } from "../ui/dom";
import { NumberField } from "../ui/number_field";

const LABELS = ["x of the section’s first end", "y of its first end", "x of its second end", "y of its second end"];

export class SectionEnds {
  readonly element: HTMLElement;
  private readonly inputs: NumberField[];
  /** Whether the ends are places of the ground's reference system, where it has one, not distances within the field. */
  private readonly system = h("select", { "aria-label": "Coordinates of the section’s ends", onchange: () => this.put(this.line) });
  private line: SectionLine | null = null;
  private offered = "";

  /** ``take`` gets the line whose ends were typed. */
  constructor(
    private readonly app: App,
    private readonly take: (line: SectionLine) => void,
  ) {
    this.inputs = LABELS.map((label) => new NumberField({ label, signed: true, optional: true, take: () => this.typed(), props: { title: `${label} (m)`, className: "end" } }));
    const [x0, y0, x1, y1] = this.inputs.map(({ element }) => element);
    this.element = h("span", { className: "ends" }, "from", x0!, y0!, "to", x1!, y1!, "m", this.system);
  }

  /** Show a line's ends, unless they are being typed. */
  show(line: SectionLine): void {
    this.offer();
    if (this.line?.join() === line.join() || this.element.contains(document.activeElement)) return;
    this.put(line);
  }

  private put(line: SectionLine | null): void {
    this.line = line;
    line?.forEach((_, at) => this.inputs[at]!.show(this.shown(at)!));
  }

  /** A number of the line as its field shows it: to a tenth of a cell, and to a centimetre at least. */
  private shown(at: number): number | null {
    if (!this.line) return null;
    const cell = this.app.current?.description?.lattice.cell_size ?? 1;
    return Number((this.line[at]! + this.corner[at % 2]!).toFixed(Math.max(2, Math.ceil(1 - Math.log10(cell)))));
  }

  private typed(): void {
    const run = this.app.current;
    const numbers = this.inputs.flatMap(({ number }) => number ?? []);
    if (!run?.description || numbers.length < LABELS.length) return;
    const { columns, rows, cell_size } = run.description.lattice;
    const [west, south] = this.corner;
    const within = (place: number, count: number) => Math.min(Math.max(place, 0), count * cell_size);
    const { line: before } = this;
    const line = numbers.map((place, at) => {
      if (before && place === this.shown(at)) return before[at]!; // of a number that is not typed anew every digit counts
      return at % 2 ? within(place - south, rows) : within(place - west, columns);
    }) as SectionLine;
    if (line[0] === line[2] && line[1] === line[3]) return;
    this.put(line);
    this.take(line);
  }

  /** What is added to places within the field. */
  private get corner(): [number, number] {
    const place = this.place;
    return place && this.system.value === "map" ? [place.west, place.south] : [0, 0];
  }

  private get place(): Place | null {
    return this.app.current?.description?.place ?? null;
  }

  private offer(): void {
    const { place } = this;
    const key = JSON.stringify(place);
    if (key === this.offered) return;
    this.offered = key;
    this.system.hidden = place === null;
    this.system.replaceChildren(
      ...(place ? [h("option", { value: "map" }, `easting, northing${place.crs ? ` (${place.crs})` : ""}`)] : []),
      h("option", { value: "field" }, "from the south-west corner"),
    );
    this.put(this.line);
  }
}
