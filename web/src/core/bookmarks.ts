/** Bookmarks of moments: those of the run, and those that the browser keeps for runs of the same scenario and seed. */

import type { App } from "./app";
import type { Json, JsonObject, RunName } from "./protocol";
import type { Run } from "./run";

export interface Bookmark {
  id: string;
  name: string;
  step: number;
  branch: number;
  /** Changes of the run before it; without any, the scenario alone leads there again. */
  events: number;
  /** The field that coloured the surface. */
  colour_by: string;
  camera: JsonObject;
}

const KEY = "barchan-bookmarks";
/** Scenarios whose bookmarks are kept, those that were used last. */
const MOST = 30;

export class Bookmarks {
  constructor(private readonly app: App) {
    if (!app.watching) app.described.watch((run) => this.agree(run));
  }

  /** The bookmarks of the run that the panel shows, by step. */
  get list(): Bookmark[] {
    return this.app.current?.description?.bookmarks ?? [];
  }

  /** Set a bookmark at what is shown now; the run's answer tells its step. */
  async add(name: string, colour_by: string, camera: JsonObject): Promise<void> {
    const id = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2, 8)}`;
    await this.app.ask({ command: "bookmark", bookmarks: [{ id, name, colour_by, camera }] });
  }

  async rename(bookmark: Bookmark, name: string): Promise<void> {
    for (const run of this.holding(bookmark)) await this.app.connection.ask({ command: "bookmark", run, bookmarks: [{ ...bookmark, name }] });
  }

  async remove(bookmark: Bookmark): Promise<void> {
    for (const run of this.app.runs) {
      const { identity } = run.description ?? {};
      if (identity) this.keep(identity, this.kept(identity).filter((one) => one.id !== bookmark.id));
    }
    for (const run of this.holding(bookmark)) await this.app.ask({ command: "unbookmark", run, bookmark: bookmark.id });
  }

  /** Go to a bookmark's moment; a run that has not come so far runs on to it. */
  async visit(bookmark: Bookmark): Promise<void> {
    if (this.app.running) this.app.send({ command: "pause" });
    const ahead = this.ahead(bookmark);
    if (ahead > 0) {
      this.app.send({ command: "run", until: bookmark.step });
      this.app.note("info", `The run goes on to step ${bookmark.step}, where ‘${bookmark.name}’ is.`);
      return;
    }
    for (const run of this.holding(bookmark)) {
      const answer = await this.app.ask({ command: "visit", run, bookmark: bookmark.id });
      if (answer && answer.step !== bookmark.step) this.app.note("info", `Of the steps around ${bookmark.step} the state after step ${answer.step} is kept.`);
    }
  }

  /** Steps that the run has still to do until a bookmark; 0 where it was there, on this branch or another one. */
  ahead(bookmark: Bookmark): number {
    const { description, status } = this.app.current ?? {};
    if (!description || !status) return 0;
    const branch = description.branches.find((one) => one.number === bookmark.branch);
    if (branch && branch.number !== description.branch && branch.step >= bookmark.step) return 0;
    return Math.max(0, bookmark.step - status.live);
  }

  private holding(bookmark: Bookmark): RunName[] {
    return this.app.runs.filter((run) => run.description?.bookmarks.some((one) => one.id === bookmark.id)).map((run) => run.name);
  }

  /** Bring what the run has and what the browser keeps together. */
  private agree(run: Run): void {
    const { identity, bookmarks } = run.description!;
    const known = new Set(bookmarks.map((one) => one.id));
    const missing = this.kept(identity).filter((one) => !known.has(one.id));
    if (bookmarks.length) this.keep(identity, [...bookmarks, ...missing]);
    // what was changed by hand before its moment cannot be reached from the scenario alone
    const again = missing.filter((one) => one.events === 0).map((one) => ({ ...one, branch: 1 }));
    if (again.length) void this.app.connection.ask({ command: "bookmark", run: run.name, bookmarks: again as unknown as Json }).catch(() => {});
  }

  private kept(identity: string): Bookmark[] {
    const list: unknown = all()[identity];
    return Array.isArray(list) ? list.filter(isBookmark) : [];
  }

  private keep(identity: string, bookmarks: Bookmark[]): void {
    const { [identity]: _, ...others } = all();
    const newest = Object.entries(others).slice(-(MOST - 1));
    try {
      localStorage.setItem(KEY, JSON.stringify(Object.fromEntries([...newest, ...(bookmarks.length ? [[identity, bookmarks]] : [])])));
    } catch {
      // private windows keep nothing
    }
  }
}

function all(): Record<string, unknown> {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return found !== null && typeof found === "object" ? (found as Record<string, unknown>) : {};
  } catch {
    return {};
  }
}

/** Whether something that the browser kept is a bookmark: an older version, or a hand, may have written something else. */
function isBookmark(value: unknown): value is Bookmark {
  const one = value as Partial<Bookmark> | null;
  return typeof one?.id === "string" && typeof one.name === "string" && Number.isInteger(one.step) && Number.isInteger(one.events);
}
