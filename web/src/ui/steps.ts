/** The step that is shown in words. */

import type { Status } from "../core/protocol";
import { short } from "./dom";

/** The step of the runs that are shown; where two stand apart both steps, the left one's first. */
export function stepsOf(statuses: (Status | null | undefined)[]): string {
  return [...new Set(statuses.flatMap((status) => (status ? [short(status.step, 9)] : [])))].join(" | ");
}
