/** The profile of the other of two runs, along the same line, in the section of the first. */

import type { App } from "../core/app";
import { cell } from "../core/csv";
import { type Profile, ends, profile, showsCells } from "../core/profile";
import { type Run, nameBeside } from "../core/run";
import type { SectionLine } from "../core/section";
import { metres } from "../ui/dom";

export interface Second {
  run: Run;
  profile: Profile;
  ends: [number, number];
}

/** The other run along a line; null where there is none, or it has another lattice for the moment. */
export function secondProfile(app: App, run: Run, line: SectionLine): Second | null {
  const other = app.runs.find((one) => one !== run && one.ready);
  if (!other || other.rows !== run.rows || other.columns !== run.columns) return null;
  const found = profile(other, line, showsCells(run)); // point by point as the first
  return { run: other, profile: found, ends: ends(found.surface) };
}

/** What the other profile is at a point, in words, named beside the first run. */
export function placed({ run, profile: p }: Second, first: Run, at: number): string {
  const lee = p.shadow && p.shadow[at]! > 0.5 ? ", in shadow" : "";
  return `${nameBeside(run, first)}: elevation ${metres(p.surface[at])}, slope ${p.slope[at]!.toFixed(1)}°${lee}`;
}

type Column = [string, (i: number) => string];

/** The profiles of one run, or of two along the same line, as a table of text: distance, place, then each run. */
export function sectionCsv(run: Run, own: Profile, second: Second | null): string {
  const values = (p: Profile, mark: string): Column[] => [
    [`elevation${mark}_m`, (i) => p.surface[i]!.toFixed(4)],
    [`ground${mark}_m`, (i) => p.ground[i]!.toFixed(4)],
    [`slope${mark}_degrees`, (i) => p.slope[i]!.toFixed(4)],
    [`shadow${mark}`, (i) => (p.shadow ? String(Number(p.shadow[i]! > 0.5)) : "")],
  ];
  const named = (one: Run, other: Run): Column => [`name_${one.name}`, () => cell(nameBeside(one, other))];
  const runs = second
    ? [named(run, second.run), ...values(own, `_${run.name}`), named(second.run, run), ...values(second.profile, `_${second.run.name}`)]
    : values(own, "");
  const columns: Column[] = [["distance_m", (i) => own.distance[i]!.toFixed(4)], ...places(run, own), ...runs];
  const rows = Array.from(own.distance, (_, i) => columns.map(([, value]) => value(i)).join());
  return `${[columns.map(([name]) => name).join(), ...rows].join("\n")}\n`;
}

/** Where each point lies: within the field, and in the ground's reference system where it has one. */
function places(run: Run, { x, y }: Profile): Column[] {
  const place = run.description!.place;
  const within: Column[] = [["x_m", (i) => x[i]!.toFixed(3)], ["y_m", (i) => y[i]!.toFixed(3)]];
  if (!place) return within;
  return [...within, ["easting_m", (i) => (place.west + x[i]!).toFixed(3)], ["northing_m", (i) => (place.south + y[i]!).toFixed(3)]];
}
