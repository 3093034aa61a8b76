/** The section of one run over time, as the page has seen it and as the server remembers it. */

import type { App } from "../core/app";
import type { Run } from "../core/run";
import { type SectionLine, along, samples } from "../core/section";

/** Places along the section. */
export const COLUMNS = 512;
const MOST_ROWS = 512;
/** Milliseconds after which the server is asked again for steps that the page has not seen. */
const RECALL = 4000;

interface Band {
  step: number;
  /** Elevations (m) along the section. */
  values: Float32Array;
}

export class Bands {
  rows: Band[] = [];
  private every = 1;
  private recalled = Number.NEGATIVE_INFINITY;
  /** What the rows are of. */
  private of = "";

  /** ``grown`` is called where there are other rows than before. */
  constructor(
    private readonly app: App,
    private readonly grown: () => void,
  ) {}

  /** Ask the server anew at the next step. */
  forget(): void {
    this.of = "";
  }

  /** Take the section of this moment in, if it is later than the last one; first of all those of the past. */
  collect(run: Run, line: SectionLine): void {
    const lattice = run.description!.lattice;
    const key = `${run.name} ${line.map((x) => x.toFixed(2))} ${run.rows} ${run.columns}`;
    const { step, looking } = run.status!;
    if (key !== this.of || (!looking && step < (this.rows.at(-1)?.step ?? 0))) {
      this.of = key;
      this.rows = [];
      this.every = 1;
      this.recalled = Number.NEGATIVE_INFINITY;
    }
    if (performance.now() - this.recalled > RECALL && !(looking && this.rows.length)) void this.recall(run, line, key);
    if (looking) return;
    if (this.rows.length && step - this.rows.at(-1)!.step < this.every) return;
    const values = along(run.surface, samples(line, lattice), lattice);
    this.rows.push({ step, values: resampled(values, COLUMNS) });
    this.thin();
    this.grown();
  }

  /** Lowest and highest elevation (m). */
  ends(): [number, number] {
    let low = Number.POSITIVE_INFINITY;
    let high = Number.NEGATIVE_INFINITY;
    for (const { values } of this.rows) {
      for (const value of values) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return [low, high];
  }

  /** Ask the server for the section over the run's past. */
  private async recall(run: Run, line: SectionLine, key: string): Promise<void> {
    this.recalled = performance.now();
    const answer = await this.app.ask({ command: "space_time", run: run.name, line });
    if (!answer || key !== this.of) return;
    const bytes = Uint8Array.from(atob(String(answer.values)), (sign) => sign.charCodeAt(0));
    const numbers = new Uint16Array(bytes.buffer);
    const [columns, low, scale] = [Number(answer.columns), Number(answer.low), Number(answer.scale)];
    const past = (answer.steps as number[]).map((step, row) => ({
      step,
      values: Float32Array.from(numbers.subarray(row * columns, (row + 1) * columns), (number) => low + scale * number),
    }));
    const steps = new Set(past.map((band) => band.step));
    this.rows = [...past, ...this.rows.filter((band) => !steps.has(band.step))].sort((a, b) => a.step - b.step);
    this.thin();
    this.grown();
  }

  private thin(): void {
    if (this.rows.length <= MOST_ROWS) return;
    this.rows = this.rows.filter((_, at) => at % 2 === 0);
    this.every = Math.max(2 * this.every, (this.rows.at(-1)!.step - this.rows[0]!.step) / this.rows.length);
  }
}

function resampled(values: Float32Array, count: number): Float32Array {
  const found = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    const at = (i / (count - 1)) * (values.length - 1);
    const low = Math.min(Math.floor(at), Math.max(values.length - 2, 0));
    const share = at - low;
    found[i] = values[low]! * (1 - share) + values[Math.min(low + 1, values.length - 1)]! * share;
  }
  return found;
}
