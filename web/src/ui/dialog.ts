/** Sheets over the page, closed by Escape; one that works asks before it breaks that off. */

import type { Progress } from "../core/connection";
import { h } from "./dom";
import { TimeLeft } from "./time_left";

type Content = HTMLElement | false;

export function dialog(title: string, className: string, ...content: Content[]): HTMLDialogElement {
  const close = h("button", { type: "button", className: "close", "aria-label": "Close", title: "Close (Esc)", onclick: () => leave(element) }, "×");
  const element = h("dialog", { className, "aria-label": title }, h("header", {}, h("h2", {}, title), close), ...content);
  element.addEventListener("click", (event) => {
    if (event.target === element) leave(element);
  });
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    event.preventDefault(); // browsers let a sheet refuse only the first of several Escapes
    leave(element);
  });
  element.addEventListener("close", () => element.remove());
  document.body.append(element);
  element.showModal();
  return element;
}

/** Close a sheet, unless it does not let go now: as Escape does. */
function leave(sheet: HTMLDialogElement): void {
  if (sheet.dispatchEvent(new Event("cancel", { cancelable: true }))) sheet.close();
}

/** Milliseconds that work may take before a sheet shows how far it is. */
const SOON = 300;

/** Does what a sheet asks for; `progress` shows how far it is, `signal` says that it was broken off. */
export type Submit = (progress: Progress, signal: AbortSignal) => Promise<void>;

/** What stands at the foot of a sheet while it works: how far that is, and the ways to break it off. */
class Work {
  private readonly bar = h("progress", { "aria-label": "Progress" });
  private readonly count = h("span", { className: "unit", role: "status" });
  /** How far it is. */
  readonly shown = h("div", { className: "work" }, this.bar, this.count);
  readonly stop = h("button", { type: "button", onclick: () => this.breakOff() }, "cancel");
  /** Shown where somebody is about to leave the sheet. */
  readonly question: HTMLElement;
  private readonly stay = h("button", { type: "button", className: "primary", onclick: () => this.ask(false) }, "go on");
  private running: AbortController | null = null;
  private left = new TimeLeft();

  constructor() {
    const give = h("button", { type: "button", onclick: () => this.breakOff() }, "break it off");
    this.question = h("div", { className: "notice", role: "alertdialog", "aria-label": "Break it off?", hidden: true }, h("span", {}, "This is not finished. Break it off? Nothing of it is kept then."), this.stay, give);
    this.end();
  }

  begin(): AbortSignal {
    this.running = new AbortController();
    this.left = new TimeLeft();
    this.count.textContent = "";
    return this.running.signal;
  }

  readonly progress: Progress = (done, of, words = {}) => {
    this.show();
    showOn(this.bar, done, of);
    const counted = words.counted ? `${words.counted} ${Math.min(done + 1, of)} of ${of}` : "";
    const told = words.waits ?? [counted, this.left.told(done, of)].filter(Boolean).join(" · ");
    if (this.count.textContent !== told) this.count.textContent = told;
  };

  show(): void {
    this.shown.hidden = this.stop.hidden = false;
  }

  end(): void {
    this.running = null;
    this.shown.hidden = this.stop.hidden = true;
    this.ask(false);
  }

  breakOff(): void {
    this.running?.abort();
    this.ask(false);
  }

  /** Let a sheet be left only where nothing runs: whoever wants to leave is asked, and wanting that again means to go on. */
  guard(sheet: HTMLDialogElement): void {
    sheet.addEventListener("cancel", (event) => {
      if (!this.running) return;
      event.preventDefault();
      if (!this.running.signal.aborted) this.ask(this.question.hidden === true);
    });
    sheet.addEventListener("close", () => this.running?.abort());
  }

  private ask(asked: boolean): void {
    this.question.hidden = !asked;
    if (asked) this.stay.focus();
  }
}

/** A sheet with a form, which Enter submits; where that is refused it stays open and says why. What is broken off leaves it open, too. */
export function formDialog(title: string, action: string, submit: Submit, ...content: Content[]): HTMLDialogElement {
  const trouble = h("output", { className: "trouble", role: "alert" });
  const button = h("button", { type: "submit", className: "primary" }, action);
  const work = new Work();
  const send = async (event: Event) => {
    event.preventDefault();
    button.disabled = true;
    trouble.textContent = "";
    const signal = work.begin();
    try {
      await submit(work.progress, signal);
      element.close();
    } catch (error) {
      trouble.textContent = signal.aborted ? "Broken off; nothing was written." : error instanceof Error ? error.message : String(error);
    } finally {
      button.disabled = false;
      work.end();
    }
  };
  const form = h("form", { method: "dialog", onsubmit: (event: Event) => void send(event) }, ...content.filter((one) => one !== false), trouble, work.shown, h("div", { className: "buttons" }, button, work.stop), work.question);
  const element = dialog(title, "small", form);
  work.guard(element);
  return element;
}

/** Do what may take long; where it does, a sheet shows how far it is, and can break it off. A refusal is thrown. */
export async function working(title: string, act: Submit): Promise<void> {
  const work = new Work();
  const signal = work.begin();
  let sheet: HTMLDialogElement | undefined;
  const soon = setTimeout(() => {
    work.show();
    sheet = dialog(title, "small", work.shown, h("div", { className: "buttons" }, work.stop), work.question);
    work.guard(sheet);
  }, SOON);
  try {
    await act(work.progress, signal);
  } catch (error) {
    if (!signal.aborted) throw error;
  } finally {
    clearTimeout(soon);
    work.end();
    sheet?.close();
  }
}

/** Show how much is done, of how much; of 0 where nobody knows how long it takes. */
function showOn(bar: HTMLProgressElement, done: number, of: number): void {
  if (of > 0) Object.assign(bar, { value: done, max: of });
  else bar.removeAttribute("value");
}
