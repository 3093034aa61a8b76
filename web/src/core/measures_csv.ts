/** Measures as a table of text. */

import { cell } from "./csv";
import { type Run, namesOf } from "./run";

/** The table of a run, as `barchan export` writes it. */
export interface MeasuresTable {
  run: Run;
  headings: string[];
  rows: string[][];
}

/** The rows of one run, or those of two below each other, each named by its letter, its model and what it differs by. */
export function measuresCsv(tables: MeasuresTable[]): string {
  const headings = [...new Set(tables.flatMap((table) => table.headings))];
  const several = tables.length > 1;
  const names = namesOf(tables.map(({ run }) => run));
  const lines = tables.flatMap(({ run, headings: own, rows }, at) => {
    const said = several ? [run.name.toUpperCase(), run.description!.model.name, cell(names[at]!)] : [];
    const places = headings.map((heading) => own.indexOf(heading));
    return rows.map((row) => [...said, ...places.map((place) => row[place] ?? "")].join());
  });
  return `${[[...(several ? ["run", "model", "name"] : []), ...headings].join(), ...lines].join("\n")}\n`;
}
