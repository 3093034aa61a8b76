/** Sheets over the page, closed by Escape. */

import type { Progress } from "../core/connection";
import { h } from "./dom";

type Content = HTMLElement | false;

export function dialog(title: string, className: string, ...content: Content[]): HTMLDialogElement {
  const close = h("button", { type: "button", className: "close", "aria-label": "Close", title: "Close (Esc)", onclick: () => leave(element) }, "×");
  const element = h("dialog", { className, "aria-label": title }, h("header", {}, h("h2", {}, title), close), ...content);
  element.addEventListener("click", (event) => {
    if (event.target === element) leave(element);
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

/** A sheet with a form, which Enter submits; where that is refused it stays open and says why. While it works, Escape breaks that off and leaves the sheet open, which says so. */
export function formDialog(title: string, action: string, submit: Submit, ...content: Content[]): HTMLDialogElement {
  const trouble = h("output", { className: "trouble", role: "alert" });
  const button = h("button", { type: "submit", className: "primary" }, action);
  const stop = h("button", { type: "button", hidden: true, onclick: () => work?.abort() }, "cancel");
  const bar = h("progress", { hidden: true, "aria-label": "Progress" });
  let work: AbortController | null = null;
  const progress = (done: number, of: number) => {
    bar.hidden = stop.hidden = false;
    showOn(bar, done, of);
  };
  const send = async (event: Event) => {
    event.preventDefault();
    button.disabled = true;
    trouble.textContent = "";
    const own = (work = new AbortController());
    try {
      await submit(progress, own.signal);
      element.close();
    } catch (error) {
      trouble.textContent = own.signal.aborted ? "Broken off; nothing was written." : error instanceof Error ? error.message : String(error);
    } finally {
      button.disabled = false;
      bar.hidden = stop.hidden = true;
      work = null;
    }
  };
  const form = h("form", { method: "dialog", onsubmit: (event: Event) => void send(event) }, ...content.filter((one) => one !== false), trouble, bar, h("div", { className: "buttons" }, button, stop));
  const element = dialog(title, "small", form);
  element.addEventListener("cancel", (event) => {
    if (!work) return;
    event.preventDefault();
    work.abort();
  });
  element.addEventListener("close", () => work?.abort());
  return element;
}

/** Do what may take long; where it does, a sheet shows how far it is, and closing it breaks it off. A refusal is thrown. */
export async function working(title: string, work: Submit): Promise<void> {
  const own = new AbortController();
  const bar = h("progress", { "aria-label": "Progress" });
  const stop = h("button", { type: "button", onclick: () => own.abort() }, "cancel");
  let sheet: HTMLDialogElement | undefined;
  const soon = setTimeout(() => {
    sheet = dialog(title, "small", bar, h("div", { className: "buttons" }, stop));
    sheet.addEventListener("close", () => own.abort());
  }, SOON);
  try {
    await work((done, of) => showOn(bar, done, of), own.signal);
  } catch (error) {
    if (!own.signal.aborted) throw error;
  } finally {
    clearTimeout(soon);
    sheet?.close();
  }
}

/** Show how much is done, of how much; of 0 where nobody knows how long it takes. */
function showOn(bar: HTMLProgressElement, done: number, of: number): void {
  if (of > 0) Object.assign(bar, { value: done, max: of });
  else bar.removeAttribute("value");
}
