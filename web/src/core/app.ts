/** The state that all parts of the studio share: the connection, the runs, the view, the log. */

import type { MessageType } from "./commands";
import { Connection, type ConnectionState, Refused } from "./connection";
import { COMPILING, type Level, Notices, problemText } from "./notices";
import { Overlay } from "./overlay";
import { type Command, type Description, type JsonObject, type Message, type RunName, readFrame, type Frame } from "./protocol";
import type { Restart } from "./restarts";
import { Run } from "./run";
import { Sharing } from "./sharing";
import { Signal } from "./signal";
import { Together } from "./together";
import { type Schema } from "./schema";
import { View } from "./view";
import { WayBack } from "./way_back";

/** Milliseconds after which the page says that a run is being prepared. */
export const PREPARING = 300;

export class App {
  runs: Run[] = [];
  /** The run whose parameters the panel shows. */
  selected: RunName = "a";
  schema: Schema = {};
  colours: Record<string, [number, number, number][]> = {};
  /** Suffixes of the files that can be uploaded, as ground and as a wind record. */
  files: { heights: string[]; records: string[] } = { heights: [], records: [] };
  /** What was changed since the scenario was loaded, and restarted the run. */
  readonly restarts: Restart[] = [];
  /** The version of Barchan that serves the page. */
  version = "";
  /** Whether the surface is shown as a map, because the browser has no WebGL. */
  flat = false;
  /** Whether the browser has taken the graphics card away from the page for the moment. */
  graphicsLost = false;
  /** Whether a model is being compiled, for which everything asked of its run waits. */
  compiles = false;
  /** Whether two runs that are led together run; null where there is one. */
  pairRuns: boolean | null = null;
  /** Whether the server has told that it cannot keep all of the runs on disk. */
  unkept = false;
  /** The step that the server kept last of all runs, after one was lost; null where there is none. */
  kept: number | null = null;
  readonly sharing: Sharing;
  /** Whether the scenario of this page's link is offered in another window, so that this one can be closed. */
  handedOn = false;
  readonly notices = new Notices();
  readonly overlay = new Overlay();
  readonly wayBack = new WayBack(this);
  /** Another scenario or run has taken the place of the one before: its first frame is there. */
  readonly opened = new Signal<void>();
  readonly described = new Signal<Run>();
  readonly framed = new Signal<Run>();
  /** A parameter or the wind of a run was changed while it went on. */
  readonly altered = new Signal<Run>();
  readonly changed = new Signal<void>();
  readonly compiling = new Signal<number>();
  private readonly unconfirmed: RunName[] = [];

  /** A window that is ``watching`` commands nothing. */
  constructor(
    readonly connection: Connection,
    readonly view: View,
    readonly watching = false,
  ) {
    this.sharing = new Sharing(view, (command) => this.send(command));
    this.connection.message.watch((message) => this.onMessage(message));
    this.connection.frame.watch((data) => this.onFrame(data));
    this.connection.state.watch((state) => this.onState(state));
    this.view.changed.watch(() => this.refreshFields());
  }

  start(): void {
    this.connection.connect();
    if (this.connection.allowed) void this.load();
  }

  private state: ConnectionState = "connecting";
  private loading = false;

  /** Whether there is a connection to the server. */
  get connected(): boolean {
    return this.state === "open";
  }

  private onState(state: ConnectionState): void {
    const cut = this.connected && state !== "open";
    this.state = state;
    if (cut) this.changed.send();
    if (state === "open" && !this.schema.properties) void this.load();
  }

  /** Fetch what is needed once; where the connection failed, its state tells why. */
  private async load(): Promise<void> {
    if (this.loading) return;
    this.loading = true;
    try {
      [this.schema, this.colours, this.files] = await Promise.all([
        this.connection.fetch<Schema>("schema"),
        this.connection.fetch<App["colours"]>("colours"),
        this.connection.fetch<App["files"]>("files"),
      ]);
      this.changed.send();
    } catch (error) {
      if (this.connected) this.refused(error);
    } finally {
      this.loading = false;
    }
  }

  run(name: RunName): Run | undefined {
    return this.runs.find((run) => run.name === name);
  }

  /** The run that single views show. */
  get current(): Run | undefined {
    return this.run(this.selected) ?? this.runs[0];
  }

  /** Whether the runs go on, as far as the page can know: without a connection nothing on it does. */
  get running(): boolean {
    return this.connected && (this.pairRuns ?? this.runs[0]?.status?.running ?? false);
  }

  note(level: Level, text: string): void {
    this.notices.note(level, text);
  }

  /** Send a command; without a run's name all runs carry it out. A window that watches has none but this to say: a frame is drawn. */
  send(command: Command): void {
    if (!this.watching || command.command === "confirm") this.connection.send(command);
  }

  /** Send a command and wait for its answer; null where it was refused, which the page then says of the keys that it is about. */
  async ask(command: Command, about: string[] = []): Promise<Message | null> {
    return this.orSay(this.connection.ask(command), about);
  }

  /** Start a scenario; returns whether it runs. What is refused is said, of the changes of the keys that it is about, and leaves the run as it was. */
  async create(scenario: JsonObject, running = true, changed = false, about: string[] = []): Promise<boolean> {
    return (await this.orSay(this.begin(scenario, running, changed), about)) ?? false;
  }

  /** Start a scenario; ``changed`` where it came of the one that runs, else that is set aside. Returns whether that was wanted; throws where it is refused. */
  async begin(scenario: JsonObject, running = true, changed = false): Promise<boolean> {
    const create: Command = { command: "create", scenario, running, changed, run: this.selected };
    return (await (changed ? this.connection.ask(create) : this.wayBack.replace({ ...create, aside: true }))) !== null;
  }

  /** Open a run in place of the one that there is, which is set aside; null where it was refused, which the page then says, or not wanted. */
  async open(command: Command): Promise<Message | null> {
    return this.orSay(this.wayBack.replace(command));
  }

  /** An answer; null where it was refused, which the page then says. */
  private async orSay<T>(answer: Promise<T>, about: string[] = []): Promise<T | null> {
    try {
      return await answer;
    } catch (error) {
      this.refused(error, about);
      return null;
    }
  }

  /** Say why something was refused, at the places that it concerns, in place of what was said of the same keys before. */
  refused(error: unknown, about: string[] = []): void {
    this.notices.settle(about);
    const found = error instanceof Refused && error.problems.length ? error.problems.map((one) => [problemText(one), one.key] as const) : [];
    const said = found.length ? found : [[error instanceof Error ? error.message : String(error), about[0] ?? ""] as const];
    for (const [text, key] of said) this.notices.note("error", text, key).about = about;
  }

  /** Confirm the frames that were drawn, so that others may come. */
  confirm(): void {
    for (const run of this.unconfirmed.splice(0)) this.send({ command: "confirm", run });
  }

  private readonly handlers: Partial<Record<MessageType, (message: Message, run: Run | undefined) => void>> = {
    hello: (message) => {
      this.version = String(message.version);
      this.setRuns(message.runs as RunName[]);
      this.pairRuns = this.runs.length > 1 ? Boolean(message.running) : null;
      this.askForFields();
      this.changed.send();
    },
    runs: (message) => {
      this.setRuns(message.runs as RunName[]);
      this.askForFields();
      this.changed.send();
    },
    lockstep: (message) => {
      this.pairRuns = Boolean(message.running);
      this.changed.send();
    },
    watchers: (message) => {
      this.sharing.count(message);
      this.changed.send();
    },
    look: (message) => this.sharing.follow(message),
    compiling: (message) => {
      const functions = Number(message.functions);
      this.compiles = true;
      if (functions === 0) this.note("info", `${COMPILING}.`);
      this.compiling.send(functions);
    },
    scenario: (message, run) => {
      if (run) this.onDescription(run, message as unknown as Description, message.changed === true);
    },
    refused: (message) => {
      if (message.command === "keep_in") this.unkept = true;
      this.refused(new Refused(String(message.text), message.problems as never));
    },
    lost: (message, run) => {
      if (!run) return;
      run.lost = true;
      this.kept = message.kept as number | null;
      const text = `The simulation’s process ended by itself (code ${message.code}).`;
      this.notices.note("error", text, "", false); // the scene says so for as long as it lasts
      this.connection.abandon(text, run.name);
      this.changed.send();
    },
  };

  private onMessage(message: Message): void {
    const run = typeof message.run === "string" ? this.run(message.run as RunName) : undefined;
    this.handlers[message.type]?.(message, run);
  }

  private setRuns(names: RunName[]): void {
    this.runs = names.map((name) => this.run(name) ?? new Run(name));
    if (!names.includes(this.selected)) this.selected = "a";
    if (names.length === 1) this.pairRuns = null;
  }

  private onDescription(run: Run, description: Description, changed: boolean): void {
    if (run.isOther(description)) return this.await(run, description);
    this.describe(run, description);
    if (changed) this.altered.send(run);
  }

  /** Show another run when its first frame comes: its kernels may have to be compiled before. */
  private await(run: Run, description: Description): void {
    run.coming = { description, since: performance.now() };
    run.lost = false;
    this.askForFields();
    setTimeout(() => this.changed.send(), PREPARING);
  }

  private describe(run: Run, description: Description): void {
    run.coming = null;
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

  private readonly together = new Together((frames) => this.show(frames));

  private onFrame(data: ArrayBuffer): void {
    const frame = readFrame(data);
    this.unconfirmed.push(frame.run);
    this.together.take(frame, this.runs.map((run) => run.name));
  }

  /** Take frames over into their runs, all before anything is drawn of them. */
  private show(frames: Frame[]): void {
    const taken = new Set<Run>();
    this.compiles = false;
    let opened = false;
    for (const frame of frames) {
      const run = this.run(frame.run);
      if (run?.coming?.description.loaded === frame.loaded) {
        this.describe(run, run.coming.description);
        opened = true;
      }
      run?.take(frame);
      if (run) taken.add(run);
    }
    if (opened) this.opened.send();
    for (const run of taken) this.framed.send(run);
  }

  private asked = "";

  /** Let the server send the fields that are shown, and no others. */
  private askForFields(): void {
    for (const run of this.runs) {
      const known = new Set((run.coming?.description ?? run.description)?.fields.map((field) => field.name));
      const fields = this.view.fields().filter((name) => known.has(name));
      this.send({ command: "view", run: run.name, fields });
      this.send({ command: "paths", run: run.name, count: this.view.look.paths });
    }
    this.asked = this.shown;
  }

  /** Ask for other fields where the view has changed. */
  private refreshFields(): void {
    if (this.asked !== this.shown) this.askForFields();
  }

  /** All that the server must be asked for, as a text. */
  private get shown(): string {
    return JSON.stringify([this.view.fields(), this.view.look.paths]);
  }
}
