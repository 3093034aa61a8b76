/** A file of the user that the server keeps and the runs have read. */

import type { App } from "./app";
import type { Progress } from "./connection";

/** Milliseconds between two looks at whether a model is still being compiled. */
const LOOK_AGAIN = 500;

export interface KeptFile {
  path: string;
  /** The heights that it holds, if it does. */
  heights: { rows: number; columns: number; cell_size: number | null; codes: number[]; coloured: boolean } | null;
  /** Whether it can be read as a record of winds; not looked at where it holds heights. */
  record: boolean;
}

/**
 * Send a file, let every run read it, and use it; the server deletes it again where that is refused or broken off.
 *
 * `progress` takes the bytes that are sent, then 0 of 0 while the file is read; breaking either off leaves the runs as they are.
 */
export async function withKeptFile(app: App, file: File, progress: Progress, signal: AbortSignal, use: (kept: KeptFile) => Promise<void>): Promise<void> {
  const { path, name } = await app.connection.upload<{ path: string; name: string }>(`upload?name=${encodeURIComponent(file.name)}`, file, progress, signal);
  try {
    await use({ path, ...(await contentOf(app, path, progress, signal)) });
  } catch (error) {
    await app.connection.fetch(`upload?name=${encodeURIComponent(name)}`, { method: "DELETE" }).catch(() => {}); // the first reason counts
    throw error;
  }
}

async function contentOf(app: App, path: string, progress: Progress, signal: AbortSignal): Promise<Omit<KeptFile, "path">> {
  const reading = () => progress(0, 0, app.compiles ? { waits: "This waits until the model is compiled." } : {});
  reading();
  const again = setInterval(reading, LOOK_AGAIN);
  const asked = app.runs.map((run) => app.connection.ask({ command: "inspect", path, run: run.name }, undefined, signal));
  const answers = await Promise.all(asked).finally(() => clearInterval(again));
  signal.throwIfAborted();
  const { heights, record } = answers[0]!;
  return { heights: heights as unknown as KeptFile["heights"], record: record === true };
}
