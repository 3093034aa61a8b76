/** A menu of the bar: arrow keys move in it, Escape and a click beside it close it. */

import { h } from "./dom";

/** Text and action of an item; null draws a line. */
export type MenuItem = [text: string, action: () => void] | null;

export function menu(name: string, title: string, items: MenuItem[]): HTMLElement {
  const buttons: HTMLButtonElement[] = [];
  const rows = items.map((item) => {
    if (item === null) return h("hr", { role: "separator" });
    const [text, action] = item;
    const act = () => {
      element.open = false;
      action();
    };
    buttons.push(h("button", { type: "button", role: "menuitem", tabIndex: -1, onclick: act }, text));
    return buttons.at(-1)!;
  });
  const summary = h("summary", { title, "aria-haspopup": "menu" }, name);
  const element = h("details", { className: "menu" }, summary, h("div", { className: "menu-list", role: "menu", "aria-label": name }, ...rows));
  const focus = (at: number) => buttons.at(at % buttons.length)?.focus();
  element.addEventListener("toggle", () => {
    if (element.open) focus(0);
  });
  element.addEventListener("keydown", (event) => {
    if (!element.open) return;
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    const moves: Record<string, number> = { ArrowDown: at + 1, ArrowUp: Math.max(at, 0) - 1, Home: 0, End: -1 };
    if (event.key === "Escape") {
      element.open = false;
      summary.focus();
    } else if (event.key in moves) focus(moves[event.key]!);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  document.addEventListener("click", (event) => {
    if (!element.contains(event.target as Node)) element.open = false;
  });
  return element;
}
