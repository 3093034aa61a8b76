/** In which coordinates places are shown and typed: within the field, or of the ground's reference system where it has one. */

import type { App } from "../core/app";
import type { Place } from "../core/protocol";
import type { SectionLine } from "../core/section";
import { h } from "./dom";

export class Coordinates {
  /** The choice of both; hidden where the ground has no reference system. */
  readonly element: HTMLSelectElement;
  private offered = "";

  /** ``changed`` is called when others are chosen. */
  constructor(
    private readonly app: App,
    label: string,
    private readonly changed: () => void,
  ) {
    this.element = h("select", { "aria-label": label, onchange: () => changed() });
  }

  /** Offer what the ground of the run has. */
  offer(): void {
    const { place } = this;
    const key = JSON.stringify(place);
    if (key === this.offered) return;
    this.offered = key;
    this.element.hidden = place === null;
    this.element.replaceChildren(
      ...(place ? [h("option", { value: "map" }, `easting, northing${place.crs ? ` (${place.crs})` : ""}`)] : []),
      h("option", { value: "field" }, "from the south-west corner"),
    );
    this.changed();
  }

  get place(): Place | null {
    return this.app.current?.description?.place ?? null;
  }

  /** A number of a line as its field shows it: to a tenth of a cell, and to a centimetre at least. */
  shown(line: SectionLine, at: number): number {
    const cell = this.app.current?.description?.lattice.cell_size ?? 1;
    return Number((line[at]! + this.corner[at % 2]!).toFixed(Math.max(2, Math.ceil(1 - Math.log10(cell)))));
  }

  /** The line of numbers that were typed, within the field; of a number that is not typed anew every digit before counts. */
  read(numbers: number[], before: SectionLine | null): SectionLine {
    const { columns, rows, cell_size } = this.app.current!.description!.lattice;
    const within = (place: number, count: number) => Math.min(Math.max(place, 0), count * cell_size);
    return numbers.map((place, at) => {
      if (before && place === this.shown(before, at)) return before[at]!;
      return within(place - this.corner[at % 2]!, at % 2 ? rows : columns);
    }) as SectionLine;
  }

  /** What is added to places within the field. */
  private get corner(): [number, number] {
    const { place } = this;
    return place && this.element.value === "map" ? [place.west, place.south] : [0, 0];
  }
}
