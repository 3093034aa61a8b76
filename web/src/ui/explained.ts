/** What a parameter means, within what bounds, and whose number it is: a button beside its name shows that below its row. */

import { h, id } from "./dom";

/** Rows whose text is open: forms are drawn again after each change. */
const opened = new Set<string>();

/** The button beside the name of the row at a path, and the text below, which also describes the ``field`` to who does not see it. */
export function explanation(path: string, name: string, text: string, field: Element | undefined): { button: HTMLElement; text: HTMLElement } {
  const said = h("p", { className: "explained", id: id("explained"), hidden: !opened.has(path) }, text);
  const button = h("button", { type: "button", className: "explain", title: text, "aria-label": `What ${name} means`, "aria-controls": said.id, onclick: () => toggle() }, "i");
  const show = (open: boolean) => {
    said.hidden = !open;
    button.setAttribute("aria-expanded", String(open));
  };
  const toggle = () => {
    if (!opened.delete(path)) opened.add(path);
    show(opened.has(path));
  };
  show(opened.has(path));
  field?.setAttribute("aria-describedby", said.id);
  return { button, text: said };
}
