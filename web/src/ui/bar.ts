/** The bar at the top: the scenario, its controls, and the status of the run. */

import type { App } from "../core/app";
import type { Status } from "../core/protocol";
import { namesOf, titleOfShown } from "../core/run";
import { button, h, metres, short } from "./dom";
import { icon } from "./icons";
import { NumberField } from "./number_field";
import { Speed } from "./speed";
import { stepsOf, timesOf } from "./steps";
import { watchingNote } from "./watching";

export class Bar {
  readonly element: HTMLElement;
  private readonly title = h("h1", { className: "title" });
  private readonly model = h("span", { className: "model" });
  private readonly play: HTMLButtonElement;
  private readonly limit: Speed;
  private readonly count = new NumberField({ label: "Number of steps", value: 100, whole: true, least: 1, most: 1_000_000, props: { className: "count" } });
  private readonly numbers: Record<string, HTMLElement> = {};

  constructor(
    private readonly app: App,
    extras: HTMLElement[],
  ) {
    this.play = button("Run (space)", icon("run"), () => this.toggle(), { className: "primary" });
    this.limit = new Speed(app);
    this.element = h(
      "header",
      { className: "bar" },
      h("div", { className: "name" }, this.title, this.model),
      app.watching ? watchingNote() : this.controls(),
      h("dl", { className: "status", "aria-label": "Status" }, ...this.status()),
      h("div", { className: "extras" }, ...extras),
    );
    app.framed.watch(() => this.show());
    app.changed.watch(() => this.show());
    app.connection.state.watch(() => this.show());
  }

  private controls(): HTMLElement {
    return h(
      "div",
      { className: "controls", role: "group", "aria-label": "Run" },
      this.play,
      button("One step (.)", icon("step"), () => this.step(1)),
      this.count.element,
      button("do these steps", "do", () => this.count.number !== null && this.step(this.count.number)),
      this.limit.element,
      button("Restart with the same seed (R)", icon("restart"), () => this.restart()),
    );
  }

  toggle(): void {
    this.app.send({ command: this.app.running ? "pause" : "run" });
  }

  step(count: number): void {
    this.app.send({ command: "run", steps: Math.max(1, Math.round(count)) });
  }

  restart(): void {
    const scenario = this.app.current?.description?.scenario;
    if (scenario && this.app.runs.length > 1) void this.app.create(scenario, this.app.running, true);
    else this.app.send({ command: "restart" });
  }

  private status(): HTMLElement[] {
    const names = [
      ["step", "step"],
      ["rate", "steps/s"],
      ["clock", "time"],
      ["highest", "highest stack"],
      ["volume", "volume"],
    ];
    return names.map(([name, text]) => {
      const value = h("dd", { "data-status": name });
      this.numbers[name!] = value;
      return h("div", {}, h("dt", {}, text!), value);
    });
  }

  private showRunning(running: boolean): void {
    const label = running ? "Pause (space)" : "Run (space)";
    this.play.setAttribute("aria-pressed", String(running));
    if (this.play.title === label) return;
    this.play.replaceChildren(icon(running ? "pause" : "run"));
    this.play.title = label;
    this.play.setAttribute("aria-label", label);
  }

  /** A number of both runs, the left one's first; null where there is one run, or both have the same. */
  private ofRuns(told: (status: Status) => string): string | null {
    const [first, second] = this.app.runs.map((run) => run.status && told(run.status));
    return first && second && first !== second ? `${first} | ${second}` : null;
  }

  private show(): void {
    const run = this.app.current;
    const { description, status } = run ?? {};
    const title = titleOfShown(this.app.runs, run);
    this.title.textContent = this.title.title = title;
    this.model.textContent = this.model.title = namesOf(this.app.runs).filter(Boolean).join("  ·  ");
    document.title = title ? `${title} – Barchan studio` : "Barchan studio";
    const { running, connected } = this.app;
    this.showRunning(running);
    this.element.querySelectorAll<HTMLButtonElement>(".controls button").forEach((one) => (one.disabled = !connected));
    if (!status || !description) return;
    this.numbers.volume!.previousElementSibling!.textContent = run!.material;
    this.limit.show(status.limit);
    const statuses = this.app.runs.map((one) => one.status);
    const texts: Record<string, string> = {
      step: stepsOf(statuses),
      rate: connected ? (running ? short(status.rate, 3) : "paused") : "no server",
      clock: timesOf(statuses),
      highest: this.ofRuns((one) => short(one.highest)) ?? `${short(status.highest)} · ${metres(status.deepest, 3)}`,
      volume: `${this.ofRuns((one) => short(one.volume)) ?? short(status.volume)} m³`,
    };
    for (const [name, text] of Object.entries(texts)) {
      const value = this.numbers[name]!;
      if (value.textContent !== text) value.textContent = text;
      value.parentElement!.hidden = text === "";
    }
  }
}
