/** How much longer something takes, by how long its parts have taken so far. */

import { duration } from "./dom";

/** Seconds that must have passed before anything is said, and below which nothing is left to be said. */
const KNOWN = 2;
const SHORT = 3;

export class TimeLeft {
  private readonly began = performance.now();

  /** In words; empty where nobody knows yet, or it is as good as over. */
  told(done: number, of: number, now = performance.now()): string {
    const passed = (now - this.began) / 1000;
    if (!done || of <= done || passed < KNOWN) return "";
    const left = (passed / done) * (of - done);
    return left < SHORT ? "" : `about ${duration(rounded(left))} left`;
  }
}

/** Seconds in steps that do not flicker: of 5 below two minutes, else of 30. */
function rounded(seconds: number): number {
  const step = seconds < 120 ? 5 : 30;
  return Math.max(step, Math.round(seconds / step) * step);
}
