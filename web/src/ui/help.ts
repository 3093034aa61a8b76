/** Keyboard shortcuts: one table for what the keys do and for the sheet that lists them. */

import { dialog } from "./dialog";
import { h } from "./dom";

export interface Shortcut {
  keys: string;
  does: string;
  matches: (event: KeyboardEvent) => boolean;
  act: () => void;
}

/** A shortcut of one key, without Ctrl. */
export function key(name: string, does: string, act: () => void, shown = name): Shortcut {
  const matches = (event: KeyboardEvent) => event.key.toLowerCase() === name.toLowerCase() && !event.ctrlKey && !event.metaKey && !event.altKey;
  return { keys: shown, does, matches, act };
}

/** A shortcut with Ctrl (or Command). */
export function control(name: string, shift: boolean, does: string, act: () => void): Shortcut {
  const matches = (event: KeyboardEvent) =>
    (event.ctrlKey || event.metaKey) && event.shiftKey === shift && event.key.toLowerCase() === name;
  return { keys: `Ctrl ${shift ? "Shift " : ""}${name.toUpperCase()}`, does, matches, act };
}

/** Listen to the keys, except where one writes or moves a control. */
export function listen(shortcuts: Shortcut[]): void {
  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    const busy = /^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName) && !(target as HTMLInputElement).matches("[type=checkbox],[type=button]");
    const presses = target.matches("button, summary, [role=slider]") && /^( |Enter|Arrow)/.test(event.key);
    if (busy || presses || document.querySelector("dialog[open]")) return;
    const shortcut = shortcuts.find((one) => one.matches(event));
    if (!shortcut) return;
    event.preventDefault();
    shortcut.act();
  });
}

export function help(shortcuts: Shortcut[]): void {
  const mouse = [
    ["drag", "turn the view"],
    ["right drag, or Shift drag", "move the view"],
    ["wheel", "come nearer, go back"],
    ["point", "read position, elevation, slope and depth of the material"],
    ["drop a file", "load a scenario (.json) or use an image, array or elevation model as ground"],
  ];
  const rows = [...shortcuts.map((one) => [one.keys, one.does]), ...mouse];
  dialog("Keys and mouse", "small key-sheet", h("dl", { className: "keys" }, ...rows.map(([keys, does]) => h("div", {}, h("dt", {}, keys!), h("dd", {}, does!)))));
}
