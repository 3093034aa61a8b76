/** The heights of black and white in an image, as a row of a sheet. */

import { type Heights, usualHeights } from "../core/image_ground";
import type { Run } from "../core/run";
import { h } from "./dom";
import { NumberField } from "./number_field";

export class HeightEnds {
  private readonly lowest: NumberField;
  private readonly highest: NumberField;
  readonly element: HTMLElement;

  constructor(run: Run) {
    const { lowest, highest } = usualHeights(run);
    this.lowest = new NumberField({ label: "Height of black (m)", signed: true, value: lowest });
    this.highest = new NumberField({ label: "Height of white (m)", signed: true, value: highest });
    this.element = sheetRow("black and white (m)", this.lowest.element, this.highest.element);
  }

  get values(): Heights {
    return { lowest: this.lowest.number!, highest: this.highest.number! };
  }
}

/** A row of a sheet: what it is of, and its controls. */
export function sheetRow(text: string, ...controls: HTMLElement[]): HTMLElement {
  return h("div", { className: "row" }, h("span", {}, text), h("div", { className: "control" }, ...controls));
}
