/** Measures as a table of text. */

import type { Row } from "./protocol";
import type { Run } from "./run";

/** One row for each fixed step; of two runs one below the other, each named by its letter and its model. */
export function measuresCsv(tables: { run: Run; rows: Row[] }[]): string {
  const names = [...new Set(tables.flatMap(({ run }) => run.description!.measures.map((measure) => measure.name)))];
  const several = tables.length > 1;
  const head = [...(several ? ["run", "model"] : []), "step", ...names];
  const lines = tables.flatMap(({ run, rows }) => {
    const said = several ? [run.name.toUpperCase(), run.description!.model.name] : [];
    return rows.map((row) => [...said, row.step, ...names.map((name) => row.values[name] ?? "")].join());
  });
  return `${[head.join(), ...lines].join("\n")}\n`;
}
