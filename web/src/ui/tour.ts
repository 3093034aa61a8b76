/** The first minute: three steps that each wait for their reader. */

import type { App } from "../core/app";
import type { Status } from "../core/protocol";
import type { Signal } from "../core/signal";
import { h } from "./dom";

interface Step {
  text: string;
  /** What stands behind the text once what it waits for is there. */
  ready?: string;
  /** What the button does for those who would rather watch. */
  label: string;
  act: () => void;
  /** Whether what it waits for is there: without words of its own for that the next step begins. */
  done: () => boolean;
}

const TURN = 90;
/** Steps after which crescents stand, and within which they follow another wind. */
const GROWN = 250;
const FOLLOWED = 150;

export class Tour {
  readonly element = h("section", { className: "tour", "aria-label": "Tour", hidden: true });
  private at = -1;
  private windAtStart = 0;
  /** The status of the run in the picture that was drawn last: one that has come may not be seen yet. */
  private drawn: Status | null = null;
  private readonly text = h("p", { role: "status" });

  constructor(
    private readonly app: App,
    private readonly openWind: () => void,
    painted: Signal<void>,
  ) {
    painted.watch(() => {
      this.drawn = app.current?.status ?? null;
      this.follow();
    });
  }

  begin(): void {
    this.choose(0);
  }

  end(): void {
    this.at = -1;
    this.element.hidden = true;
  }

  private steps(): Step[] {
    const { drawn } = this;
    return [
      {
        text: `Wait until dunes stand: sand that the wind moves gathers in heaps with a steep side in the lee. The arrow shows where the wind blows${this.steady ? "" : "; it comes from several sides in turn"}.`,
        ready: "Dunes stand now.",
        label: "go on",
        act: () => this.choose(1),
        done: () => drawn !== null && drawn.step >= Math.min(GROWN, drawn.end),
      },
      {
        text: `Turn the wind: ${this.steady ? "drag the head of the dial in the panel, or let it be turned by a right angle." : "the winds in the panel blow one after the other; let a steady one take their place, turned by a right angle."}`,
        label: `turn it by ${TURN}°`,
        act: () => this.turn(),
        done: () => Math.abs(((((drawn?.wind ?? this.windAtStart) - this.windAtStart) % 360) + 540) % 360 - 180) > 30,
      },
      {
        text: "Watch the horns: under one wind slip faces move to the new lee side, and low ends run ahead as horns. Press 2 for the direction of the crests, drag the slider below to compare.",
        label: "done",
        act: () => this.end(),
        done: () => false,
      },
    ];
  }

  private choose(at: number): void {
    this.at = at;
    if (at === 0) this.app.send({ command: "run", until: GROWN });
    if (at === 1) {
      this.windAtStart = this.app.current?.status?.wind ?? 0;
      this.openWind();
    }
    if (at === 2) this.app.send({ command: "run", until: (this.app.current?.status?.step ?? 0) + FOLLOWED });
    const step = this.steps()[at]!;
    this.text.textContent = step.text;
    this.element.hidden = false;
    this.element.replaceChildren(
      h("b", {}, `${at + 1} of ${this.steps().length}`),
      this.text,
      h("button", { type: "button", className: "primary", onclick: step.act }, step.label),
      h("button", { type: "button", className: "close", "aria-label": "End the tour", title: "End the tour", onclick: () => this.end() }, "×"),
    );
  }

  /** The wind turned by a right angle; a wind of several regimes becomes one of a single direction. */
  private get steady(): boolean {
    return (this.app.current?.description?.scenario.wind as { kind?: string } | undefined)?.kind === "steady";
  }

  private turn(): void {
    const direction = ((this.app.current?.status?.wind ?? 0) + TURN) % 360;
    const wind = this.app.current?.description?.scenario.wind as { kind?: string } | undefined;
    const steady = wind?.kind === "steady" ? wind : { kind: "steady" };
    void this.app.ask({ command: "wind", wind: { ...steady, direction } });
    this.app.note("info", `A steady wind blows from ${Math.round(direction)}° now.`);
  }

  private follow(): void {
    if (this.at < 0 || !this.app.current?.ready) return;
    const { done, ready, text } = this.steps()[this.at]!;
    if (done() && ready === undefined) return this.choose(this.at + 1);
    const told = done() ? `${text} ${ready}` : text;
    if (this.text.textContent !== told) this.text.textContent = told;
  }
}
