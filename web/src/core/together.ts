/** Frames of two runs that are compared, given on where both are of the same step, so that every picture shows both there. */

import type { Frame, RunName } from "./protocol";

/** Milliseconds that a frame waits for one of the other run, which may have ended or been lost. */
const PATIENCE = 2000;

export class Together {
  private held: Frame[] = [];
  /** The step of the frame of each run that was given on last. */
  private readonly given = new Map<RunName, number>();
  private late: ReturnType<typeof setTimeout> | undefined;

  /** `give` takes frames, those of a run in the order in which they came. */
  constructor(private readonly give: (frames: Frame[]) => void) {}

  /** Take a frame of one of `runs`. */
  take(frame: Frame, runs: RunName[]): void {
    this.held.push(frame);
    const others = runs.filter((name) => name !== frame.run);
    if (others.every((other) => this.meets(frame, other))) this.giveUpTo(frame.status.step);
    clearTimeout(this.late);
    if (this.held.length) this.late = setTimeout(() => this.giveAll(), PATIENCE);
  }

  /** Whether the other run has a frame of the same step, or needs none because one of both has ended. */
  private meets({ status }: Frame, other: RunName): boolean {
    const waiting = this.held.filter((one) => one.run === other);
    if (status.finished !== null || waiting.some((one) => one.status.finished !== null || one.status.step === status.step)) return true;
    return !waiting.length && this.given.get(other) === status.step;
  }

  /** Give on what is held of each run up to its newest frame of a step, and all of a run that has none. */
  private giveUpTo(step: number): void {
    const last = new Map<RunName, number>();
    this.held.forEach((one, at) => one.status.step === step && last.set(one.run, at));
    const goes = (one: Frame, at: number) => at <= (last.get(one.run) ?? this.held.length);
    const [now, later] = [this.held.filter(goes), this.held.filter((one, at) => !goes(one, at))];
    this.held = later;
    this.pass(now);
  }

  private giveAll(): void {
    this.pass(this.held.splice(0));
  }

  private pass(frames: Frame[]): void {
    for (const { run, status } of frames) this.given.set(run, status.step);
    this.give(frames);
  }
}
