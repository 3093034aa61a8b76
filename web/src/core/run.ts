/** One simulation as the browser knows it. */

import { differences } from "./beside";
import { commonTitle, readable } from "./labels";
import type { Description, Frame, JsonObject, Row, RunName, Status } from "./protocol";

export class Run {
  description: Description | null = null;
  status: Status | null = null;
  history: number[] = [];
  measures: Row[] = [];
  ground: Float32Array = new Float32Array(0);
  depth: Float32Array = new Float32Array(0);
  surface: Float32Array = new Float32Array(0);
  fields = new Map<string, Float32Array>();
  /** Paths of grains, as ``Frame.paths``. */
  paths: number[][] = [];
  rows = 0;
  columns = 0;
  lost = false;
  /** Whether it was painted on: it is drawn as steep from then on as when that began. */
  painted = false;
  /** The run that is to take this one's place, until its first frame comes: no data are shown under another run's name. */
  coming: { description: Description; since: number } | null = null;
  /** As of the frame that was taken last. */
  private loaded: number | undefined;

  constructor(readonly name: RunName) {}

  /** The material that the model moves: sand, unless the model declares another. */
  get material(): string {
    const { description } = this;
    return description?.materials[description.model.name] ?? "sand";
  }

  get ready(): boolean {
    return this.description !== null && this.status !== null && this.surface.length > 0 && this.fits;
  }

  /** Whether the fields belong to the lattice that was described last. */
  get fits(): boolean {
    const lattice = this.description?.lattice;
    return lattice !== undefined && lattice.rows === this.rows && lattice.columns === this.columns;
  }

  /** Whether a description is of another run than the one whose data are shown. */
  isOther(description: Description): boolean {
    return this.surface.length > 0 && description.loaded !== this.loaded;
  }

  take(frame: Frame): void {
    if (frame.loaded !== this.loaded) this.painted = false;
    this.loaded = frame.loaded;
    this.rows = frame.rows;
    this.columns = frame.columns;
    this.status = frame.status;
    this.lost = false;
    if (frame.history) this.history = frame.history;
    if (frame.paths) this.paths = frame.paths;
    if (frame.measures_replaced) this.measures = [];
    if (frame.measures) this.measure(frame.measures);
    this.ground = frame.fields.get("ground") ?? this.ground;
    this.depth = frame.fields.get("depth") ?? this.depth;
    const count = frame.rows * frame.columns;
    if (this.surface.length !== count) this.surface = new Float32Array(count);
    for (let i = 0; i < count; i++) this.surface[i] = this.ground[i]! + this.depth[i]!;
    const kept = frame.shown.filter((name) => this.fields.get(name)?.length === count);
    this.fields = new Map([...kept.map((name) => [name, this.fields.get(name)!] as const), ...frame.fields]);
  }

  private measure(rows: Row[]): void {
    const byStep = new Map([...this.measures, ...rows].map((row) => [row.step, row]));
    this.measures = [...byStep.values()].sort((one, other) => one.step - other.step);
  }
}

/** The title of a scenario as the page shows it. */
export function titleOf({ scenario, models }: { scenario: JsonObject; models: Description["models"] | undefined }): string {
  return readable(String(scenario.title || "Untitled scenario"), models);
}

/** The title of what is shown: of two runs side by side without what tells them apart. */
export function titleOfShown(runs: Run[], current: Run | undefined): string {
  if (!current?.description) return "";
  const titles = [current, ...runs].flatMap(({ description }) => (description ? [titleOf(description)] : []));
  return titles.reduce(commonTitle);
}

/** Steps of which all runs keep a state, from the first on: models whose states are larger keep fewer. */
export function commonHistory(runs: Run[]): number[] {
  const [first, ...others] = runs.map((run) => run.history);
  const known = others.map((steps) => new Set(steps));
  return (first ?? []).filter((step) => known.every((steps) => steps.has(step)));
}

/** Steps of the states that are kept of all runs up to the one that is shown, and of that. */
export function shownSteps(runs: Run[]): number[] {
  const status = runs[0]?.status;
  return status ? [...commonHistory(runs).filter((step) => step < status.step), status.step] : [];
}

/** Groups of a scenario by which two runs of one model can differ, those first that tell more. */
const GROUPS = ["model", "wind", "sand", "ground", "plants", "weather", "lattice", "run"];

/** How a run is named beside another: by its model, or where both have the same, by what differs; two that are alike by their sides. */
export function nameBeside(run: Run, other: Run | undefined): string {
  const [own, others] = [run.description, other?.description];
  if (!own || !others || own.model.name !== others.model.name) return own?.model.title ?? "";
  for (const group of GROUPS) {
    const [values, beside] = [own, others].map(({ scenario }) => ({ [group]: scenario[group] ?? null }));
    const differ = differences(values!, beside!);
    if (differ.length) return differ.slice(0, 2).join(", ");
  }
  return `${own.model.title}, ${run.name === "a" ? "left" : "right"}`;
}

/** How the runs of the page are named: by what tells them apart, one alone by its model. */
export function namesOf(runs: Run[]): string[] {
  return runs.map((run, at) => nameBeside(run, runs[1 - at]));
}
