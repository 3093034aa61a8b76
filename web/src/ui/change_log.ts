/** A line of the log for every change of a parameter or of the wind. */

import type { App } from "../core/app";
import type { Entry } from "../core/notices";
import type { Json, RunName } from "../core/protocol";
import type { Restart } from "../core/restarts";
import type { Run } from "../core/run";
import { changeWords, restartWords, singly } from "./change_words";
import { short } from "./dom";

/** Milliseconds within which changes of one value, as of a dial that is dragged, are one line. */
const ONE_GESTURE = 2000;

interface Line {
  entry: Entry;
  key: string;
  /** The value before the first of the changes. */
  before: Json;
  at: number;
}

export class ChangeLog {
  private readonly newest = new Map<RunName, Line>();

  constructor(private readonly app: App) {
    app.altered.watch((run) => this.note(run));
  }

  private note(run: Run): void {
    const change = run.description?.changes.at(-1);
    if (!change) return;
    const last = this.newest.get(run.name);
    const goesOn = last && last.key === change.key && this.app.notices.log.slice(-this.app.runs.length).includes(last.entry) && performance.now() - last.at < ONE_GESTURE;
    const before = goesOn ? last.before : change.before;
    const side = this.app.runs.length < 2 ? "" : run === this.app.runs[0] ? "left run, " : "right run, ";
    const text = `${side}step ${short(change.step, 9)}: ${changeWords(this.app, { ...change, before })}`;
    const entry = goesOn ? this.app.notices.amend(last.entry, text) : this.app.notices.note("info", text);
    this.newest.set(run.name, { entry, key: change.key, before, at: performance.now() });
  }
}

/** Put changes that restarted the run into the log. */
export function noteRestart(app: App, changes: Restart[]): void {
  for (const change of changes.flatMap(singly)) app.note("info", `from the start: ${restartWords(app, change)}`);
}
