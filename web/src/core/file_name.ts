/** The names under which files are offered: they come of the title of what they hold. */

import { withoutChanges } from "./labels";
import type { Run } from "./run";

/** Signs of a name at most. */
const MOST = 48;

/** A title as a name that every system takes, without accents and cut between words; another name where nothing is left of it. */
export function nameOf(title: string, otherwise: string): string {
  const plain = title.normalize("NFKD").replaceAll(/\p{M}/gu, "").toLowerCase();
  const name = (plain.match(/[a-z0-9]+/g) ?? []).join("-");
  const cut = name.length > MOST ? name.slice(0, MOST + 1).replace(/-[^-]*$/, "").slice(0, MOST) : name;
  return cut || otherwise;
}

/** The name of files of a run, by its title without what was changed. */
export function nameOfRun(run: Run | undefined): string {
  return nameOf(withoutChanges(String(run?.description?.scenario.title ?? "")), "run");
}
