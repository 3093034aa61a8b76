/** Which files a sheet takes: one of another kind is refused in words that say where it belongs. */

import type { App } from "./app";

/** What a sheet asks for. */
export type Wanted = "ground" | "record" | "overlay";

/** What each of them is called, and where in the studio a file of the kind is chosen. */
const TERRAIN = { name: "a terrain", place: "choose it in the panel under Ground, as “file”" };
const RECORD = { name: "a record of winds", place: "choose it in the panel under Wind, as “record”" };
const SCENARIO = { name: "a scenario", place: "choose it under File, “Load a scenario …”" };

const PHOTOGRAPHS = [".webp"];

/** Whether a file's name ends in one of some suffixes. */
export const ends = (name: string, suffixes: string[]): boolean => suffixes.some((suffix) => name.toLowerCase().endsWith(suffix));

/** The suffixes of the files that a sheet takes. */
export function suffixesOf({ files }: App, wanted: Wanted): string[] {
  if (wanted === "record") return files.records;
  return wanted === "ground" ? files.heights : [...files.heights, ...PHOTOGRAPHS];
}

/** Throw where a file's name tells that it is not of the kind that is wanted. */
export function refuseName(app: App, name: string, wanted: Wanted): void {
  const own = suffixesOf(app, wanted);
  if (ends(name, own)) return;
  if (wanted === "record" && ends(name, app.files.heights)) throw other(name, TERRAIN, RECORD);
  if (wanted !== "record" && ends(name, app.files.records)) throw other(name, RECORD, TERRAIN);
  if (ends(name, [".json"])) throw other(name, SCENARIO, wanted === "record" ? RECORD : TERRAIN);
  throw new Error(`${name} is of an unknown kind. Allowed here: ${own.join(", ")}.`);
}

/** Throw where what a file holds tells that it is not of the kind that is wanted: a suffix may be that of both kinds. */
export function refuseContent(name: string, holds: { heights: unknown; record: boolean }, wanted: Wanted): void {
  if (wanted === "record" && holds.heights) throw other(name, TERRAIN, RECORD);
  if (wanted !== "record" && !holds.heights && holds.record) throw other(name, RECORD, TERRAIN);
}

function other(name: string, is: typeof TERRAIN, wanted: typeof TERRAIN): Error {
  return new Error(`${name} is ${is.name}, not ${wanted.name}; ${is.place}. The run is as it was.`);
}
