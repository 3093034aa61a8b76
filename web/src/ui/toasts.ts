/** Refusals, and ways back, on the page: each stays until it is dismissed; a refusal leads to the row that it concerns. */

import type { App } from "../core/app";
import type { Entry } from "../core/notices";
import { h } from "./dom";

/** Refusals that are shown at once; the rest is counted. */
const MOST = 4;

export class Toasts {
  readonly element: HTMLElement;
  private readonly list = h("ul", { className: "toasts", "aria-label": "Refusals" });
  private readonly said = h("p", { className: "unseen", role: "status" });
  private readonly shown = new Map<Entry, HTMLElement>();
  private readonly rest = h("li", { className: "rest" });

  constructor(
    private readonly app: App,
    private readonly lead: (key: string) => void,
  ) {
    this.element = h("div", { className: "said" }, this.list, this.said);
    app.notices.changed.watch(() => this.show());
    app.connection.state.watch(() => this.enable());
    app.notices.logged.watch((entry) => {
      if (entry.level !== "error") this.said.textContent = entry.text;
    });
  }

  private show(): void {
    const standing = this.app.notices.standing;
    const wanted = standing.slice(-MOST);
    for (const [entry, element] of this.shown) {
      if (wanted.includes(entry)) continue;
      element.remove();
      this.shown.delete(entry);
    }
    for (const entry of wanted) {
      if (this.shown.has(entry)) continue;
      const element = this.toast(entry);
      this.shown.set(entry, element);
      this.list.append(element);
    }
    const more = standing.length - wanted.length;
    this.rest.textContent = `${more} more in the log`;
    if (more) this.list.append(this.rest);
    else this.rest.remove();
  }

  /** What leads on asks the server, and cannot be used without it. */
  private enable(): void {
    for (const way of this.list.querySelectorAll<HTMLButtonElement>("button.lead-on")) way.disabled = !this.app.connected;
  }

  private toast(entry: Entry): HTMLElement {
    const dismiss = () => this.app.notices.dismiss(entry);
    const show = h("button", { type: "button", onclick: () => this.lead(entry.key) }, "show");
    const go = () => {
      dismiss();
      entry.way?.act();
    };
    return h(
      "li",
      { className: `toast ${entry.level}${entry.way ? " way" : ""}` },
      h("span", { role: entry.level === "error" ? "alert" : "status", title: entry.text }, entry.text),
      entry.way && h("button", { type: "button", className: "lead-on", disabled: !this.app.connected, onclick: go }, entry.way.name),
      entry.key !== "" && show,
      h("button", { type: "button", className: "close", title: "Dismiss", "aria-label": `Dismiss: ${entry.text}`, onclick: dismiss }, "×"),
    );
  }
}

/** Bring the row of a key, or of the group that holds it, into view. */
export function leadTo(key: string): void {
  for (let parts = key.split("."); parts.length; parts = parts.slice(0, -1)) {
    const path = CSS.escape(parts.join("."));
    const place = document.querySelector<HTMLElement>(`[data-trouble="${path}"]`) ?? document.getElementById(`group-${parts.join(".")}`);
    if (!place) continue;
    for (let at: HTMLElement | null = place; at; at = at.parentElement) if (at instanceof HTMLDetailsElement) at.open = true;
    const row = place.closest<HTMLElement>(".row") ?? place;
    row.scrollIntoView({ block: "center" });
    row.querySelector<HTMLElement>("[data-path]:not([type=range]), summary")?.focus();
    return;
  }
}
