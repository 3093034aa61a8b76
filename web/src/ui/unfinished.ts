/** Runs that an earlier studio left because it ended unexpectedly: each is offered, to be opened or discarded. */

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
  /** One run, or two side by side. */
  runs: Member[];
}

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
    if (!app.watching) app.connection.state.watch((state) => state === "open" && void this.look());
  }

  /** The offers over the scene, each of which can be put off. */
  overScene(): HTMLElement {
    return this.list(this.put, () => undefined);
  }

  /** All offers, in a sheet, those as well that were put off before it; `onOpen` is called when one was opened. */
  inSheet(onOpen: () => void): HTMLElement {
    return this.list(new Set(), onOpen);
  }

  /** A list of offers but those that were put off, which is hidden where there are none. */
  private list(put: Set<string>, onOpen: () => void): HTMLElement {
    const element = h("ul", { className: "unfinished", "aria-label": "Runs that stopped unexpectedly" });
    let shown = false;
    const draw = () => {
      if (shown && !element.isConnected) return this.changed.leave(draw); // its sheet was closed
      shown = element.isConnected;
      const offers = this.left.filter(({ name }) => !put.has(name));
      element.hidden = offers.length === 0;
      element.replaceChildren(...offers.map((one) => this.offer(one, put, onOpen)));
    };
    this.changed.watch(draw);
    draw();
    return element;
  }

  private async look(): Promise<void> {
    if (this.looked) return;
    this.looked = true;
    try {
      const { unfinished, broken } = await this.app.connection.fetch<Answer>("unfinished");
      for (const text of broken) this.app.note("warning", `A run that the studio kept cannot be read and is left as it is: ${text}`);
      this.set(unfinished);
    } catch (error) {
      this.looked = false;
      this.app.refused(error);
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
      h("button", { type: "button", onclick: () => this.putOff(one, put) }, "later"),
    );
  }

  private async open(one: Left, onOpen: () => void): Promise<void> {
    if (!(await this.app.open({ command: "open_unfinished", name: one.name }))) return;
    this.app.note("info", "The run goes on from where it stopped, with the branches, earlier states and moments that were kept.");
    this.set(this.left.filter((other) => other !== one));
    onOpen();
  }

  /** Take an offer from the scene, and from the list where that was said, for now. */
  private putOff(one: Left, put: Set<string>): void {
    put.add(one.name);
    this.put.add(one.name);
    this.changed.send();
    this.app.note("info", "The run is kept; Presets offers it further on, and so does the next start of the studio.");
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

function words({ runs, saved }: Left, models: Record<string, string>): string {
  const [first] = runs;
  const names = [...new Set(runs.map((run) => readable(run.title, models) || valueLabel(run.model, models)))].map((name) => `“${name}”`).join(" and ");
  const moment = new Date(saved).toLocaleString(undefined, { dateStyle: "long", timeStyle: "short" });
  const of = first!.steps > first!.step ? ` of ${short(first!.steps, 9)}` : "";
  const what = runs.length > 1 ? `Your two runs side by side of ${names}` : `Your run of ${names}`;
  return `${what} stopped at step ${short(first!.step, 9)}${of} on ${moment}, when the studio ended unexpectedly.`;
}
