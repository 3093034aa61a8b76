/** Two runs whose steps last differently are compared at equal steps, not at equal times: said once, with a way out. */

import type { App } from "../core/app";
import type { Entry } from "../core/notices";
import type { JsonObject } from "../core/protocol";
import { namesOf } from "../core/run";
import { noteRestart } from "./change_log";
import { duration } from "./dom";

/** Shares by which durations differ that are equal but for rounding. */
const ROUNDING = 1e-9;

export class EqualTimes {
  private entry: Entry | null = null;
  /** The durations that were told of. */
  private told = "";

  constructor(private readonly app: App) {
    app.described.watch(() => this.look());
    app.changed.watch(() => this.look());
  }

  private look(): void {
    const lasting = this.app.runs.map((run) => run.description?.step_seconds ?? null);
    const [left, right] = lasting;
    const differ = typeof left === "number" && typeof right === "number" && Math.abs(left - right) > ROUNDING * left;
    const told = differ ? lasting.join() : "";
    if (told === this.told) return;
    this.told = told;
    if (this.entry) this.app.notices.dismiss(this.entry);
    this.entry = differ ? this.note(left, right) : null;
  }

  private note(left: number, right: number): Entry {
    const [first, second] = namesOf(this.app.runs);
    const text =
      `Both runs are at equal steps, not at equal times: a step of “${first}” lasts ${duration(left)}, one of “${second}” ${duration(right)}. ` +
      "Where the wind changes with time, they are under different winds.";
    const clock = this.app.runs[0]?.description?.scenario.clock as JsonObject | null | undefined;
    const way = clock ? { name: "give both the same duration", act: () => void this.equal(left) } : undefined;
    return this.app.notices.note("warning", text, "", true, way);
  }

  /** Begin both again, with steps of one duration; the reference wind then has no effect. */
  private async equal(seconds: number): Promise<void> {
    const { scenario } = this.app.current!.description!;
    const { reference_speed: _, ...clock } = scenario.clock as JsonObject;
    if (!(await this.app.create({ ...scenario, clock: { ...clock, step_seconds: seconds } }, true, true))) return;
    const made = [{ path: ["clock", "step_seconds"], before: clock.step_seconds ?? null, value: seconds }];
    this.app.restarts.push(...made);
    noteRestart(this.app, made);
    this.app.note("info", `A step of both runs lasts ${duration(seconds)}; both began again.`);
  }
}
