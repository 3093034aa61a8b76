/** Runs that are on disk because an earlier studio ended unexpectedly, or another run took their place: each is offered, to be opened or discarded. */

import type { App } from "../core/app";
import { readable, valueLabel } from "../core/labels";
import { Signal } from "../core/signal";
import { h, short } from "./dom";

interface Member {
  title: string;
  model: string;
  step: number;
  steps: number;
}

interface Left {
  name: string;
  /** When its state was kept, as an ISO date and time. */
  saved: string;
  /** Whether it was set aside for another run. */
  aside: boolean;
  /** Whether that was in this studio, which has told of it then. */
  here: boolean;
  /** One run, or two side by side. */
  runs: Member[];
}

/** Of how many runs offers are shown; a row tells of the others. */
const FIRST = 1;

/** How often, and after how many milliseconds each time more, the server is asked for a run that it may still be writing. */
const TRIES = 4;
const WAIT = 500;

interface Answer {
  unfinished: Left[];
  /** What is damaged, each with its file. */
  broken: string[];
}

export class Unfinished {
  private left: Left[] = [];
  private readonly changed = new Signal<void>();
  private looked = false;
  /** Names of those that are not offered over the scene any more. */
  private readonly put = new Set<string>();

  constructor(private readonly app: App) {
    app.described.watch(() => this.left.length && this.changed.send()); // which tells the titles of models
    if (app.watching) return;
    app.connection.state.watch((state) => state === "open" && void this.begin());
    app.wayBack.kept = (title) => this.keeps(title);
  }

  /** The offers over the scene, each of which can be put off. */
  overScene(): HTMLElement {
    return this.list(this.put, () => undefined, ({ here }) => !here);
  }

  /** Whether a run whose place aside another one has just taken is on disk; it is offered in sheets. */
  private async keeps(title: string): Promise<boolean> {
    const known = new Set(this.left.map(({ name }) => name));
    for (let tries = 0; tries < TRIES; tries += 1) {
      await new Promise((done) => setTimeout(done, tries * WAIT));
      await this.look();
      const come = this.left.filter(({ name, aside }) => aside && !known.has(name));
      if (come.some(({ runs }) => runs[0]!.title === title)) return true;
    }
    return false;
  }

  /** All offers, in a sheet, those as well that were put off before it; `onOpen` is called when one was opened. */
  inSheet(onOpen: () => void): HTMLElement {
    return this.list(new Set(), onOpen);
  }

  /** A list of offers but those that were put off, of those that are to be told of; it is hidden where there are none. */
  private list(put: Set<string>, onOpen: () => void, told: (one: Left) => boolean = () => true): HTMLElement {
    const element = h("ul", { className: "unfinished", "aria-label": "Runs that are kept" });
    let shown = false;
    let all = false;
    const draw = () => {
      if (shown && !element.isConnected) return this.changed.leave(draw); // its sheet was closed
      shown = element.isConnected;
      const offers = this.left.filter((one) => !put.has(one.name) && told(one));
      element.hidden = offers.length === 0;
      const rest = all ? [] : offers.slice(FIRST);
      const showAll = () => {
        all = true;
        draw();
      };
      const rows = offers.slice(0, offers.length - rest.length).map((one) => this.offer(one, put, onOpen));
      element.replaceChildren(...rows, ...(rest.length ? [this.others(rest, put, showAll)] : []));
    };
    this.changed.watch(draw);
    draw();
    return element;
  }

  private async begin(): Promise<void> {
    if (this.looked) return;
    this.looked = true;
    if (!(await this.look())) this.looked = false;
  }

  /** Ask what there is; returns whether that was answered. */
  private async look(): Promise<boolean> {
    try {
      const { unfinished, broken } = await this.app.connection.fetch<Answer>("unfinished");
      for (const text of broken) this.app.note("warning", `A run that the studio kept cannot be read and is left as it is: ${text}`);
      this.set(unfinished);
      return true;
    } catch (error) {
      this.app.refused(error);
      return false;
    }
  }

  private set(left: Left[]): void {
    this.left = left;
    this.changed.send();
  }

  private offer(one: Left, put: Set<string>, onOpen: () => void): HTMLElement {
    const discard = h("button", { type: "button", onclick: () => this.confirm(discard, one) }, "discard it");
    return h(
      "li",
      {},
      h("span", {}, words(one, this.app.current?.description?.models ?? {})),
      h("button", { type: "button", className: "primary", onclick: () => void this.open(one, onOpen) }, "open it"),
      discard,
      h("button", { type: "button", onclick: () => this.putOff([one], put) }, "later"),
    );
  }

  /** The row that stands for offers that are not shown. */
  private others(rest: Left[], put: Set<string>, onShow: () => void): HTMLElement {
    const text = rest.length === 1 ? "One earlier run is kept as well." : `${rest.length} earlier runs are kept as well.`;
    return h(
      "li",
      {},
      h("span", {}, text),
      h("button", { type: "button", onclick: onShow }, rest.length === 1 ? "show it" : "show them"),
      h("button", { type: "button", onclick: () => this.putOff(rest, put) }, "later"),
    );
  }

  private async open(one: Left, onOpen: () => void): Promise<void> {
    if (!(await this.app.open({ command: "open_unfinished", name: one.name }))) return;
    this.app.note("info", "The run goes on from where it stopped, with the branches, earlier states and moments that were kept.");
    this.set(this.left.filter((other) => other !== one));
    onOpen();
  }

  /** Take offers from the scene, and from the list where that was said, for now. */
  private putOff(some: Left[], put: Set<string>): void {
    for (const { name } of some) put.add(name) && this.put.add(name);
    this.changed.send();
    const [are, them] = some.length === 1 ? ["The run is", "it"] : ["The runs are", "them"];
    this.app.note("info", `${are} kept; Presets offers ${them} further on, and so does the next start of the studio.`);
  }

  /** The first click asks, the second deletes. */
  private confirm(button: HTMLButtonElement, one: Left): void {
    button.textContent = "discard it for good";
    button.onclick = () => void this.discard(one);
  }

  private async discard(one: Left): Promise<void> {
    if (await this.app.ask({ command: "discard_unfinished", name: one.name })) this.set(this.left.filter((other) => other !== one));
  }
}

function words({ runs, saved, aside }: Left, models: Record<string, string>): string {
  const [first] = runs;
  const names = [...new Set(runs.map((run) => readable(run.title, models) || valueLabel(run.model, models)))].map((name) => `“${name}”`).join(" and ");
  const moment = new Date(saved).toLocaleString(undefined, { dateStyle: "long", timeStyle: "short" });
  const of = first!.steps > first!.step ? ` of ${short(first!.steps, 9)}` : "";
  const what = runs.length > 1 ? `Your two runs side by side of ${names}` : `Your run of ${names}`;
  if (aside) return `${what} was set aside at step ${short(first!.step, 9)}${of} on ${moment}.`;
  return `${what} stopped at step ${short(first!.step, 9)}${of} on ${moment}, when the studio ended unexpectedly.`;
}
