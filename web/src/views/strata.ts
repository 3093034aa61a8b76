/** The layers of a bed in a section: what colours them, and the layers of the line that is shown. */

import type { App } from "../core/app";
import type { Strata } from "../core/protocol";
import type { Run } from "../core/run";
import type { SectionLine } from "../core/section";
import { h, short, themeColour } from "../ui/dom";
import { labelOf } from "../core/labels";

/** Milliseconds from one request to the next, at least. */
const PAUSE = 150;
/** Greatest over least value from which colours follow the logarithm. */
const WIDE = 10;
const LEAST = 0.1;
/** The colours of the first and the last state, as shares of the map. */
const STATES: [number, number] = [0.1, 0.8];

/** The colour of values that are all alike, as a share of the map. */
const MIDDLE = 0.5;

interface Layers {
  step: number;
  place: number[];
  ground: number[];
  thickness: number[][];
  values: number[][];
}

export class SectionLayers {
  /** The choice of what colours the layers; hidden where the model keeps none. */
  readonly choice: HTMLElement;
  private readonly select = h("select", { "aria-label": "Colour of the layers", "data-strata": "" });
  private offered = "";
  private layers: Layers | null = null;
  private of = "";
  private asking = false;
  private askedAt = 0;

  constructor(
    private readonly app: App,
    private readonly redraw: () => void,
  ) {
    this.choice = h("label", { hidden: true }, "layers by ", this.select);
    this.select.onchange = () => {
      this.layers = null;
      this.askedAt = 0;
      this.redraw();
    };
    if (app.watching) return; // who watches can ask for nothing
    app.described.watch((run) => run === app.current && this.offer(run.description!.strata));
    app.changed.watch(() => this.offer(app.current?.description?.strata ?? []));
  }

  private offer(strata: Strata[]): void {
    const names = strata.map((one) => one.name).join();
    if (names === this.offered) return;
    this.offered = names;
    this.layers = null;
    this.choice.hidden = !strata.length;
    this.select.replaceChildren(...strata.map((one) => h("option", { value: one.name }, labelOf(one.name))));
  }

  private chosen(run: Run): Strata | undefined {
    return run.description!.strata.find((one) => one.name === this.select.value);
  }

  /** The highest surface (m) of the layers under a line; minus infinity where there are none yet. */
  highest(run: Run, line: SectionLine): number {
    if (!this.layers || this.of !== this.wanted(run, line)) return Number.NEGATIVE_INFINITY;
    const { ground, thickness } = this.layers;
    return Math.max(...ground.map((base, i) => thickness.reduce((sum, heights) => sum + heights[i]!, base)));
  }

  /** What is asked for: a line of a run, and what colours its layers. */
  private wanted(run: Run, line: SectionLine): string {
    return JSON.stringify([run.name, line, this.select.value]);
  }

  /** Draw the layers under a line, and ask for newer ones; false where there are none yet. */
  draw(c: CanvasRenderingContext2D, run: Run, line: SectionLine, x: (d: number) => number, y: (z: number) => number, low: number): boolean {
    const strata = this.chosen(run);
    if (!strata) return false;
    const wanted = this.wanted(run, line);
    void this.ask(run, line, strata.name, wanted);
    if (!this.layers || this.of !== wanted) return false;
    const { place, ground, thickness, values } = this.layers;
    const colour = this.scale(strata);
    const base = [...ground];
    thickness.forEach((heights, at) => {
      heights.forEach((height, i) => {
        if (height <= 0) return;
        const [from, to] = [Math.max(base[i]!, low), base[i]! + height];
        base[i] = to;
        if (to <= low) return;
        c.fillStyle = colour(values[at]![i]!);
        c.fillRect(x(place[i]!), y(to), x(place[i + 1]!) - x(place[i]!) + 0.5, y(from) - y(to) + 0.5);
      });
    });
    this.outline(c, base, x, y);
    return true;
  }

  /** The surface of the cells that the layers are read from. */
  private outline(c: CanvasRenderingContext2D, tops: number[], x: (d: number) => number, y: (z: number) => number): void {
    const { place } = this.layers!;
    c.beginPath();
    tops.forEach((top, i) => {
      c.lineTo(x(place[i]!), y(top));
      c.lineTo(x(place[i + 1]!), y(top));
    });
    c.strokeStyle = themeColour("ink");
    c.lineWidth = 1;
    c.stroke();
  }

  /** The key of the colours, in the section's lower corner. */
  legend(c: CanvasRenderingContext2D, run: Run, left: number, top: number): void {
    const strata = this.chosen(run);
    if (!strata || !this.layers) return;
    const colour = this.scale(strata);
    const [low, high] = this.ends();
    const unit = strata.unit === "-" ? "" : ` ${strata.unit}`;
    c.textAlign = "left";
    if (strata.states.length) {
      strata.states.forEach((state, value) => {
        c.fillStyle = colour(value);
        c.fillRect(left, top - 8, 10, 8);
        this.text(c, state, left + 14, top);
        left += 26 + c.measureText(state).width;
      });
      return;
    }
    const wide = 90;
    for (let i = 0; i < wide; i++) {
      c.fillStyle = colour(this.wide ? low * (high / low) ** (i / wide) : low + ((high - low) * i) / wide);
      c.fillRect(left + i, top - 8, 1.5, 8);
    }
    const values = this.alike ? short(low, 3) : `${short(low, 3)} to ${short(high, 3)}`;
    this.text(c, `${strata.title}: ${values}${unit}`, left + wide + 6, top);
  }

  /** The layers at a place, from the top down, for people to read. */
  under(distance: number, run: Run): string {
    const strata = this.chosen(run);
    if (!strata || !this.layers) return "";
    const { place, thickness, values } = this.layers;
    const i = Math.max(place.findLastIndex((edge) => edge <= distance), 0);
    const told = thickness.flatMap((heights, at) => {
      const height = heights[i] ?? 0;
      if (height <= 0) return [];
      const value = values[at]![i]!;
      const unit = strata.unit === "-" ? "" : ` ${strata.unit}`;
      return [`${short(1000 * height, 3)} mm ${strata.states[value] ?? `${short(value, 3)}${unit}`}`];
    });
    return told.length ? ` · from the top: ${told.reverse().join(", ")}` : "";
  }

  private text(c: CanvasRenderingContext2D, text: string, x: number, y: number): void {
    c.fillStyle = themeColour("ink");
    c.fillText(text, x, y);
  }

  private get wide(): boolean {
    const [low, high] = this.ends();
    return high > WIDE * low;
  }

  /** Whether all values read the same: colours are not to part what the numbers do not. */
  private get alike(): boolean {
    const [low, high] = this.ends();
    return short(low, 3) === short(high, 3);
  }

  /** Least and greatest value of the layers that there are. */
  private ends(): [number, number] {
    let [low, high] = [Number.POSITIVE_INFINITY, 0];
    this.layers!.thickness.forEach((heights, at) =>
      heights.forEach((height, i) => {
        if (height <= 0) return;
        const value = Math.max(this.layers!.values[at]![i]!, LEAST);
        [low, high] = [Math.min(low, value), Math.max(high, value)];
      }),
    );
    return high > 0 ? [low, Math.max(high, 2 * LEAST)] : [LEAST, 1];
  }

  private scale(strata: Strata): (value: number) => string {
    const map = this.app.colours.strata ?? [];
    const [low, high] = this.ends();
    const { alike } = this;
    const share = (value: number): number => {
      if (strata.states.length) return STATES[0] + ((STATES[1] - STATES[0]) * value) / Math.max(strata.states.length - 1, 1);
      const held = Math.max(value, LEAST);
      if (alike) return MIDDLE;
      return this.wide ? Math.log(held / low) / Math.log(high / low) : (held - low) / (high - low);
    };
    return (value) => `rgb(${(map[Math.round(Math.min(Math.max(share(value), 0), 1) * (map.length - 1))] ?? [200, 210, 225]).join()})`;
  }

  private async ask(run: Run, line: SectionLine, by: string, wanted: string): Promise<void> {
    const fresh = this.of === wanted && this.layers?.step === run.status!.step && this.balance === this.painted(run);
    if (this.asking || fresh || (this.of === wanted && performance.now() - this.askedAt < PAUSE)) return;
    this.asking = true;
    this.askedAt = performance.now();
    const painted = this.painted(run);
    const answer = await this.app.ask({ command: "strata", run: run.name, line, by });
    this.asking = false;
    if (!answer) return;
    this.layers = answer as unknown as Layers;
    this.of = wanted;
    this.balance = painted;
    this.redraw();
  }

  private balance = "";

  /** What brushes change between two steps. */
  private painted(run: Run): string {
    return JSON.stringify([run.status!.balance.parts, run.status!.undo, run.status!.redo, run.status!.volume]);
  }
}
