/** What all parts of the studio share: the line, the runs, what is shown, the log. */

import { Line, Refused } from "./line";
import { type Description, type JsonObject, type RunName, type Told, readFrame } from "./protocol";
import { Run } from "./run";
import { Signal } from "./signal";
import { type Schema } from "./schema";
import { View } from "./view";

export type Level = "info" | "warning" | "error";

export interface Entry {
  time: Date;
  level: Level;
  text: string;
}

export class App {
  readonly line: Line;
  readonly view = new View();
  runs: Run[] = [];
  /** The run whose parameters the panel shows. */
  selected: RunName = "a";
  schema: Schema = {};
  colours: Record<string, [number, number, number][]> = {};
  /** Whether two runs that are led together run; null where there is one. */
  pairRuns: boolean | null = null;
  readonly log: Entry[] = [];
  readonly logged = new Signal<Entry>();
  readonly described = new Signal<Run>();
  readonly framed = new Signal<Run>();
  readonly changed = new Signal<void>();
  readonly compiling = new Signal<void>();
  private readonly unconfirmed: RunName[] = [];

  constructor(token: string) {
    this.line = new Line(token);
    this.line.told.watch((told) => this.hear(told));
    this.line.framed.watch((data) => this.see(data));
    this.view.changed.watch(() => this.refreshFields());
  }

  async start(): Promise<void> {
    this.line.connect();
    [this.schema, this.colours] = await Promise.all([
      this.line.fetch<Schema>("schema"),
      this.line.fetch<App["colours"]>("colours"),
    ]);
    this.changed.send();
  }

  run(name: RunName): Run | undefined {
    return this.runs.find((run) => run.name === name);
  }

  /** The run that single views show. */
  get current(): Run | undefined {
    return this.run(this.selected) ?? this.runs[0];
  }

  get running(): boolean {
    return this.pairRuns ?? this.runs[0]?.status?.running ?? false;
  }

  note(level: Level, text: string): void {
    const entry = { time: new Date(), level, text };
    this.log.push(entry);
    if (this.log.length > 1000) this.log.shift();
    this.logged.send(entry);
  }

  /** Give an order; without a run's name all runs carry it out. */
  order(order: JsonObject): void {
    this.line.send(order);
  }

  /** Ask for something; what is refused goes to the log. */
  async ask(order: JsonObject): Promise<Told | null> {
    try {
      return await this.line.ask(order);
    } catch (error) {
      this.refused(error);
      return null;
    }
  }

  /** Begin a scenario anew. */
  create(scenario: JsonObject, running = true): void {
    this.order({ do: "create", scenario, running, run: this.selected });
  }

  refused(error: unknown): void {
    if (error instanceof Refused && error.problems.length) {
      for (const problem of error.problems) this.note("error", problemText(problem));
    } else this.note("error", error instanceof Error ? error.message : String(error));
  }

  /** Confirm the frames that were drawn, so that others may come. */
  confirm(): void {
    for (const run of this.unconfirmed.splice(0)) this.order({ do: "confirm", run });
  }

  private hear(told: Told): void {
    const run = typeof told.run === "string" ? this.run(told.run as RunName) : undefined;
    if (told.tell === "hello") {
      this.setRuns(told.runs as RunName[]);
      this.pairRuns = this.runs.length > 1 ? Boolean(told.running) : null;
      this.askForFields();
      this.changed.send();
    } else if (told.tell === "runs") {
      this.setRuns(told.runs as RunName[]);
      this.askForFields();
      this.changed.send();
    } else if (told.tell === "pair") {
      this.pairRuns = Boolean(told.running);
      this.changed.send();
    } else if (told.tell === "compiling") {
      this.note("info", "Compiling kernels; only the first run of a model does.");
      this.compiling.send();
    } else if (told.tell === "scenario" && run) this.describe(run, told as unknown as Description);
    else if (told.tell === "refused") {
      this.refused(new Refused(String(told.text), told.problems as never));
      if (this.current) this.described.send(this.current);
    } else if (told.tell === "lost" && run) {
      run.lost = true;
      this.note("error", `The simulation's process ended (code ${told.code}). The server lives; restart the run.`);
      this.changed.send();
    }
  }

  private setRuns(names: RunName[]): void {
    this.runs = names.map((name) => this.run(name) ?? new Run(name));
    if (!names.includes(this.selected)) this.selected = "a";
    if (names.length === 1) this.pairRuns = null;
  }

  private describe(run: Run, description: Description): void {
    const before = run.description;
    run.description = description;
    if (!description.paths) run.paths = [];
    run.lost = false;
    for (const remark of description.remarks) {
      if (!before?.remarks.includes(remark)) this.note("warning", remark);
    }
    this.askForFields();
    this.described.send(run);
    this.changed.send();
  }

  private see(data: ArrayBuffer): void {
    const frame = readFrame(data);
    const run = this.run(frame.run);
    this.unconfirmed.push(frame.run);
    if (!run) return;
    run.take(frame);
    this.framed.send(run);
  }

  private asked = "";

  /** Let the server send the fields that are shown, and no others. */
  private askForFields(): void {
    for (const run of this.runs) {
      const known = new Set(run.description?.fields.map((field) => field.name));
      const fields = this.view.fields().filter((name) => known.has(name));
      this.order({ do: "view", run: run.name, fields });
      this.order({ do: "paths", run: run.name, count: this.view.look.paths });
    }
    this.asked = this.shown;
  }

  /** Ask anew where what is shown has changed. */
  private refreshFields(): void {
    if (this.asked !== this.shown) this.askForFields();
  }

  /** All that the server must be asked for, as a text. */
  private get shown(): string {
    return JSON.stringify([this.view.fields(), this.view.look.paths]);
  }
}

export function problemText(problem: { key: string; message: string; place: string }): string {
  const place = problem.place ? ` (${problem.place})` : "";
  return problem.key ? `${problem.key}: ${problem.message}${place}` : `${problem.message}${place}`;
}
