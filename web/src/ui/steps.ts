/** The step, the time and the wind that are shown, in words; of two that differ the left one's first. */

import type { Status } from "../core/protocol";
import { duration, short } from "./dom";

type Statuses = (Status | null | undefined)[];

/** The step of the runs that are shown; where two stand apart both steps. */
export function stepsOf(statuses: Statuses): string {
  return each(statuses, ({ step }) => short(step, 9));
}

/** The time of the runs that are shown; empty where steps have no duration. */
export function timesOf(statuses: Statuses): string {
  return each(statuses, ({ time }) => (time === null || time === undefined ? null : duration(time)));
}

/** Where the winds of the runs that are shown come from; of several winds in one step where their mean transport does. */
export function windsOf(statuses: Statuses): string {
  return each(statuses, ({ wind, winds }) => `${short(wind, 3)}°${winds > 1 ? ` (mean of ${winds})` : ""}`);
}

function each(statuses: Statuses, told: (status: Status) => string | null): string {
  const all = statuses.flatMap((status) => (status ? (told(status) ?? []) : []));
  return [...new Set(all)].join(" | ");
}
