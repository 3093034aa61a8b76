/** Measures over the steps of the run. */

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { App } from "../core/app";
import { centreOf, crestMarks, named, nearest, reachOf } from "../core/crests";
import { nameOfRun } from "../core/file_name";
import { type MeasuresTable, measuresCsv } from "../core/measures_csv";
import { spokenKey } from "../core/notices";
import type { JsonObject, Measure } from "../core/protocol";
import { type Run, namesOf } from "../core/run";
import { BalanceTable } from "./balance";
import { CHART_FONT, download, button, h, short, themeColour } from "../ui/dom";
import { type Side, sideOf } from "../ui/sides";

const FIRST = ["highest_stack", "spacing", "crest_azimuth", "speed", "flux"];
const CREST = "crest_azimuth";
const PAUSE = 200;
/** Height (pixels) of a chart with its axis, at least: where not all have it, they are scrolled. */
const LEAST = 136;

export class SeriesView {
  readonly title = "Measures";
  readonly element: HTMLElement;
  private readonly plots = h("div", { className: "plots", tabIndex: 0, role: "group", "aria-label": "Measures over the steps" });
  private readonly choice = h("div", { className: "choices", role: "group", "aria-label": "Measures shown" });
  /** Which line is which run's, where there are two. */
  private readonly names = h("div", { className: "run-names" });
  private readonly when = h("span", { className: "readout" });
  private chosen = new Set(FIRST);
  private charts: { measure: Measure; chart: uPlot; box: HTMLElement; value: HTMLElement }[] = [];
  private declared = "";
  private visible = false;
  private late: ReturnType<typeof setTimeout> | null = null;
  private drawnAt = 0;

  constructor(private readonly app: App) {
    this.element = h(
      "div",
      { className: "view series" },
      h("div", { className: "tools" }, h("details", { className: "picker" }, h("summary", {}, "measures shown"), this.choice), !app.watching && button("Save the measures as CSV", "save CSV", () => void this.save()), this.names, this.when),
      new BalanceTable(app).element,
      this.plots,
    );
    app.framed.watch(() => this.update());
    app.changed.watch(() => this.update(true));
    app.view.changed.watch(() => this.rebuild());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.rebuild());
    new ResizeObserver(() => this.fit()).observe(this.plots);
  }

  show(visible: boolean): void {
    this.visible = visible;
    this.update(true);
  }

  private measures(): Measure[] {
    return this.app.current?.description?.measures ?? [];
  }

  /** Save the measures of all runs at every fixed step and where they rest; those that are not measured yet are waited for. */
  private async save(): Promise<void> {
    const { runs } = this.app;
    const answers = await Promise.all(runs.map((run) => this.app.ask({ command: "measured", run: run.name })));
    if (answers.includes(null)) return;
    const tables = answers.map((answer, at) => ({ ...(answer as unknown as Omit<MeasuresTable, "run">), run: runs[at]! }));
    download(`${nameOfRun(this.app.current)}-measures.csv`, measuresCsv(tables));
  }

  /** At which steps the measures are taken: in short, and in full where one points at it. */
  private intervals(): void {
    const { measured_every: every = 0, measured_rows: rows = 0 } = this.app.current?.description ?? {};
    const from = every * rows;
    this.when.textContent = every ? `every ${every === 1 ? "step" : `${every} steps`}; from step ${short(from, 9)} fewer` : "";
    this.when.title = every ? `From step ${short(from, 9)} every ${2 * every} steps, from ${short(2 * from, 9)} every ${4 * every}, and so on` : "";
  }

  private update(at_once = false): void {
    if (!this.visible) return;
    const declared = this.measures().map((measure) => measure.name).join() + this.app.runs.length;
    if (declared !== this.declared) {
      this.declared = declared;
      this.choices();
      this.rebuild();
    }
    this.intervals();
    this.plots.classList.toggle("two", this.app.runs.length > 1);
    const wait = this.drawnAt + PAUSE - performance.now();
    if (!at_once && wait > 0) {
      this.late ??= setTimeout(() => this.update(true), wait); // no other frame may come
      return;
    }
    clearTimeout(this.late ?? undefined);
    this.late = null;
    this.drawnAt = performance.now();
    this.centreCrests();
    this.names.replaceChildren(...namesWithLines(this.app.runs));
    for (const { measure, box, chart, value } of this.charts) {
      const data = this.data(measure.name);
      box.classList.toggle("bare", !data.slice(1).some((values) => Array.from(values!).some((one) => one != null)));
      chart.setData(data);
      const found = this.app.runs.map((run) => lastOf(run, measure));
      const parts = found.map(({ text }, at) => h("b", { className: this.app.runs.length > 1 ? `run-${at}` : "" }, text));
      value.replaceChildren(...parts.flatMap((part, at) => (at ? [" | ", part] : [part])), measure.unit === "-" || found.every(({ none }) => none) ? "" : ` ${measure.unit}`);
      value.title = [measure.reference, ...found.map(({ doubt }) => doubt)].filter(Boolean).join("; ");
    }
  }

  /** The steps of all runs, and each run's values there. */
  private data(name: string): uPlot.AlignedData {
    const tables = this.app.runs.map(
      (run) => [run.measures.map((row) => row.step), run.measures.map((row) => this.plotted(name, row.values[name] ?? null))] as uPlot.AlignedData,
    );
    if (tables.length === 1) return tables[0]!;
    return uPlot.join(tables);
  }

  /** The middle of the plot of crests, and how far it reaches to either side (degrees). */
  private centre = 90;
  private reach = 90;
  /** The run of which that is the middle, and its last measured step then. */
  private centred: { identity: string; step: number } | null = null;

  /** A value as it is plotted: crests on the side of their line that is nearest to the plot's middle. */
  private plotted(name: string, value: number | null): number | null {
    return name === CREST && value !== null ? nearest(value, this.centre) : value;
  }

  private readonly crestAxis: uPlot.Axis = {
    splits: () => crestMarks(this.centre, this.reach),
    values: (_, marks) => marks.map((mark) => `${named(mark)}°`),
  };

  private centreCrests(): void {
    const found = this.app.runs.flatMap((run) => run.measures.map((row) => row.values[CREST])).filter((value) => value != null);
    const { description, measures = [], status } = this.app.runs[0] ?? {};
    const now = { identity: description?.identity ?? "", step: measures.at(-1)?.step ?? 0 };
    const same = this.centred?.identity === now.identity && this.centred.step <= now.step;
    this.centre = centreOf(found, status?.wind ?? 0, same ? this.centre : null);
    this.reach = reachOf(found, this.centre);
    this.centred = now;
  }

  private choices(): void {
    this.choice.replaceChildren(
      ...this.measures().map((measure) => {
        const box = h("input", {
          type: "checkbox",
          checked: this.chosen.has(measure.name),
          onchange: () => {
            if (box.checked) this.chosen.add(measure.name);
            else this.chosen.delete(measure.name);
            this.rebuild();
          },
        });
        return h("label", {}, box, ` ${measure.title}${measure.unit === "-" ? "" : ` (${measure.unit})`}`);
      }),
    );
  }

  private rebuild(): void {
    for (const { chart } of this.charts) chart.destroy();
    this.plots.replaceChildren();
    this.charts = this.measures()
      .filter((measure) => this.chosen.has(measure.name))
      .map((measure) => {
        const value = h("span", { className: "values" });
        const box = h("figure", {}, h("figcaption", {}, `${measure.title} `, value));
        this.plots.append(box);
        return { measure, box, value, chart: new uPlot(this.options(measure), this.data(measure.name), box) };
      });
    this.fit();
    if (this.visible) this.update(true);
  }

  private options(measure: Measure): uPlot.Options {
    const axis = { font: CHART_FONT, stroke: themeColour("faint"), grid: { stroke: themeColour("line"), width: 1 }, ticks: { show: false } };
    const dots = measure.unit === "degrees";
    return {
      width: 200,
      height: 120,
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { size: 6 } },
      scales: { x: { time: false }, ...(measure.name === CREST ? { y: { range: () => [this.centre - this.reach, this.centre + this.reach] } } : {}) },
      axes: [
        { ...axis, size: 28, space: 55, values: (_, marks) => marks.map((mark) => short(mark)) },
        { ...axis, size: 54, space: 24, values: (_, marks) => marks.map((mark) => short(mark, 3)), ...(measure.name === CREST ? this.crestAxis : {}) },
      ],
      series: [
        {},
        ...this.app.runs.map((run) => line(sideOf(run), dots)),
      ],
    } as uPlot.Options;
  }

  private fit(): void {
    const count = Math.max(this.charts.length, 1);
    const { clientWidth, clientHeight } = this.plots;
    if (!clientWidth) return;
    const across = Math.max(1, Math.min(count, Math.floor(clientWidth / 205)));
    const down = Math.ceil(count / across);
    for (const { chart, box } of this.charts) {
      box.style.width = `${Math.floor(clientWidth / across) - 10}px`;
      chart.setSize({ width: Math.floor(clientWidth / across) - 12, height: Math.max(LEAST, Math.floor(clientHeight / down) - 26) });
    }
  }
}

/** The last value of a measure of a run, and why it should not be quoted, or why there is none. */
function lastOf(run: Run, measure: Measure): { text: string; doubt: string; none?: boolean } {
  const last = run.measures.findLast((row) => row.values[measure.name] != null)?.values[measure.name];
  const row = run.measures.at(-1);
  const doubt = row?.doubts[measure.name] ?? row?.failed ?? "";
  if (last != null) return { text: `${short(last, 3)}${doubt && " ?"}`, doubt };
  const never = neverOf(run, measure);
  const why = never || doubt;
  return { text: `${never || isOver(run) ? "no value" : "no value yet"}${why && `: ${why}`}`, doubt: why, none: true };
}

/** What the remarks of a run say of measures that never have a value: the words before the reason, as the scenario's are. */
const NEVER = "migration will have no value: ";

/** Why a measure will have no value at all, which the scenario tells; empty where it may have one. */
function neverOf({ description }: Run, { title }: Measure): string {
  const saved = (description?.scenario.run as JsonObject | undefined)?.save_every;
  if (!title.startsWith("migration") || description?.measured_every !== saved) return ""; // it is measured at other steps than are saved
  const said = description?.remarks.find((remark) => remark.startsWith(NEVER)) ?? "";
  return said.slice(NEVER.length).replaceAll(/\brun\.save_every\b/g, spokenKey("run.save_every"));
}

/** Whether a run has come to its end, and is measured no more. */
function isOver({ status }: Run): boolean {
  return status !== null && !status.running && (Boolean(status.finished) || status.live >= (status.end ?? Infinity));
}

/** The line of a run in a chart; where it is of ``dots`` every value stands alone. */
function line({ colour, dashes }: Side, dots: boolean): uPlot.Series {
  const stroke = themeColour(colour);
  return {
    stroke,
    width: 1.5,
    dash: dashes,
    points: { show: true, size: 3, fill: stroke, ...(dots ? {} : { filter: (chart: uPlot, series: number) => alone(chart.data[series]!) }) },
    ...(dots ? { paths: () => null } : {}),
  };
}

/** The names of two runs, each with the line that its measures have; none where there is one run. */
function namesWithLines(runs: Run[]): HTMLElement[] {
  if (runs.length < 2) return [];
  return namesOf(runs).map((name, at) => h("span", { className: `run-${at}` }, h("i", {}), name));
}

/** Where values stand that a line cannot show, as neither side of them has one; what a run has no row for is no gap. */
export function alone(values: ArrayLike<number | null | undefined>): number[] {
  const rows = Array.from(values, (value, at) => ({ value, at })).filter(({ value }) => value !== undefined);
  const has = (row: number) => rows[row]?.value != null;
  return rows.flatMap(({ at }, row) => (has(row) && !has(row - 1) && !has(row + 1) ? [at] : []));
}
