/** A sheet over the page, closed by Escape. */

import { h } from "./dom";

export function dialog(title: string, className: string, ...content: (HTMLElement | false)[]): HTMLDialogElement {
  const close = h("button", { type: "button", className: "close", "aria-label": "Close", title: "Close (Esc)", onclick: () => element.close() }, "×");
  const element = h("dialog", { className, "aria-label": title }, h("header", {}, h("h2", {}, title), close), ...content);
  element.addEventListener("click", (event) => {
    if (event.target === element) element.close();
  });
  element.addEventListener("close", () => element.remove());
  document.body.append(element);
  element.showModal();
  return element;
}
