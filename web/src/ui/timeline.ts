/** The run's past: look back, play, return to now, go on from an earlier state. */

import type { App } from "../core/app";
import { commonHistory, shownSteps } from "../core/run";
import { button, counted, h, isActive, short } from "./dom";

const PLAY_PAUSE = 90;

export class Timeline {
  readonly element: HTMLElement;
  private readonly slider = h("input", { type: "range", min: "0", max: "0", step: "1", value: "0", "aria-label": "Look back through the run" });
  private readonly label = h("output", {});
  private readonly play: HTMLButtonElement;
  private readonly now: HTMLButtonElement;
  private readonly branches = h("select", {
    "aria-label": "Branch",
    title: "Go back to another branch",
    hidden: true,
    onchange: () => this.app.send({ command: "switch", branch: Number(this.branches.value) }),
  });
  private readonly branch: HTMLButtonElement;
  private playing: ReturnType<typeof setInterval> | null = null;
  private waiting = false;

  /** ``mark`` sets a bookmark at what is shown, where there are bookmarks. */
  constructor(
    private readonly app: App,
    mark?: () => void,
  ) {
    this.play = button("replay from here", "replay", () => this.togglePlay());
    this.now = button("Return to now (End)", "now", () => this.live());
    this.branch = button("Go on from here; what came later stays as a branch", "go on from here", () => void this.goOn());
    this.slider.addEventListener("input", () => this.look(Number(this.slider.value)));
    this.element = h("div", { className: "timeline" }, this.play, this.slider, this.label, mark && button("Mark this moment (K)", "mark", mark), this.branches, this.branch, this.now);
    this.slider.disabled = app.watching;
    app.framed.watch(() => this.show());
    app.changed.watch(() => this.show());
    app.described.watch(() => this.offer());
  }

  live(): void {
    this.stop();
    this.app.send({ command: "look", step: null });
  }

  /** Look one remembered state back or on. */
  nudge(by: number): void {
    const { history, at } = this.place();
    this.look(Math.min(Math.max(at + by, 0), history.length - 1));
  }

  private async goOn(): Promise<void> {
    this.stop();
    const answer = await this.app.ask({ command: "branch" });
    if (answer) this.app.note("info", `A new branch begins at step ${answer.step}.`);
  }

  private offer(): void {
    const { branches, branch } = this.app.current!.description!;
    const text = (one: (typeof branches)[number]) => `branch ${one.number} ${one.began ? `from ${short(one.began)}` : ""}`;
    this.branches.replaceChildren(...branches.map((one) => h("option", { value: String(one.number), selected: one.number === branch }, text(one))));
    this.branches.hidden = branches.length < 2;
  }

  private place(): { history: number[]; at: number } {
    const history = commonHistory(this.app.runs);
    const step = this.app.current?.status?.step ?? 0;
    let at = history.findLastIndex((one) => one <= step);
    if (at < 0) at = 0;
    return { history, at };
  }

  private look(at: number): void {
    const step = commonHistory(this.app.runs)[at];
    if (step === undefined) return;
    this.waiting = true;
    this.app.send({ command: "look", step });
  }

  private togglePlay(): void {
    if (this.playing !== null) return this.stop();
    const { history, at } = this.place();
    if (at >= history.length - 1) this.look(0);
    this.play.textContent = "stop";
    this.playing = setInterval(() => {
      if (this.waiting) return; // the picture of the last order is still on its way
      const { history: steps, at: here } = this.place();
      if (here >= steps.length - 1) this.stop();
      else this.look(here + 1);
    }, PLAY_PAUSE);
  }

  /** End a replay. */
  stop(): void {
    if (this.playing !== null) clearInterval(this.playing);
    this.playing = null;
    this.play.textContent = "replay";
  }

  private show(): void {
    this.waiting = false;
    const status = this.app.current?.status;
    if (!status) return;
    const { history, at } = this.place();
    this.slider.max = String(Math.max(history.length - 1, 0));
    if (!isActive(this.slider) || !status.looking || this.playing !== null) {
      this.slider.value = String(status.looking ? at : history.length - 1);
    }
    this.slider.setAttribute("aria-valuetext", `step ${status.step}`);
    const kept = shownSteps(this.app.runs).length; // the present one as well
    this.label.textContent = status.looking ? `step ${short(status.step, 9)} of ${short(status.live, 9)}` : `${counted(kept, "state")} kept`;
    this.element.classList.toggle("looking", status.looking);
    this.now.hidden = !status.looking;
    this.branch.hidden = !status.looking;
    this.branch.disabled = !status.can_branch;
    this.play.disabled = history.length < 2;
  }
}
