/** Sheets over the page, closed by Escape. */

import { h } from "./dom";

type Content = HTMLElement | false;

export function dialog(title: string, className: string, ...content: Content[]): HTMLDialogElement {
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

/** A sheet with a form, which Enter submits; where that is refused it stays open and says why. */
export function formDialog(title: string, action: string, submit: () => Promise<void>, ...content: Content[]): HTMLDialogElement {
  const trouble = h("output", { className: "trouble", role: "alert" });
  const button = h("button", { type: "submit", className: "primary" }, action);
  const send = async (event: Event) => {
    event.preventDefault();
    button.disabled = true;
    trouble.textContent = "";
    try {
      await submit();
      element.close();
    } catch (error) {
      trouble.textContent = error instanceof Error ? error.message : String(error);
    } finally {
      button.disabled = false;
    }
  };
  const form = h("form", { method: "dialog", onsubmit: (event: Event) => void send(event) }, ...content.filter((one) => one !== false), trouble, h("div", { className: "buttons" }, button));
  const element = dialog(title, "small", form);
  return element;
}
