/** Measures as a table of text. */

import type { Run } from "./run";

/** The table of a run, as `barchan export` writes it. */
export interface MeasuresTable {
  run: Run;
  headings: string[];
  rows: string[][];
}

/** The rows of one run, or those of two below each other, each named by its letter and its model. */
export function measuresCsv(tables: MeasuresTable[]): string {
  const headings = [...new Set(tables.flatMap((table) => table.headings))];
  const several = tables.length > 1;
  const lines = tables.flatMap(({ run, headings: own, rows }) => {
    const said = several ? [run.name.toUpperCase(), run.description!.model.name] : [];
    const places = headings.map((heading) => own.indexOf(heading));
    return rows.map((row) => [...said, ...places.map((place) => row[place] ?? "")].join());
  });
  return `${[[...(several ? ["run", "model"] : []), ...headings].join(), ...lines].join("\n")}\n`;
}
