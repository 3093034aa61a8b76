/** Changes on the page that restarted the run, and what is left of them. */

import type { Json } from "./protocol";
import { at } from "./schema";

/** A change of a value on the page that restarted the run. */
export interface Restart {
  path: (string | number)[];
  before: Json;
  value: Json;
}

export const same = (a: Json | undefined, b: Json | undefined): boolean => JSON.stringify(a) === JSON.stringify(b);

/** Each value that differs now from what it was at first: one entry a path, none for what was put back. */
export function remaining(restarts: Restart[], scenario: Json): Restart[] {
  const first = new Map<string, Restart>();
  for (const one of restarts) {
    const key = JSON.stringify(one.path);
    if (!first.has(key)) first.set(key, one);
  }
  return [...first.values()].flatMap(({ path, before }) => {
    const value = at(scenario, path);
    return value === undefined || same(value, before) ? [] : [{ path, before, value }];
  });
}
