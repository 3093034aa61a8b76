/** Those who watch: the link that lets them, how many they are, and what their own window says and leaves out. */

import type { App } from "../core/app";
import { watchQuery } from "../core/token";
import { copyRow } from "./copy_row";
import { dialog } from "./dialog";
import { h } from "./dom";
import { icon } from "./icons";

const NETWORK = "barchan studio --host 0.0.0.0";

/** What the server says of those who watch. */
interface Watching {
  token: string;
  /** Addresses under which other computers reach the server. */
  addresses: string[];
}

/** A sheet with the link by which others watch. */
export async function letOthersWatch(app: App): Promise<void> {
  const { token, addresses } = await app.connection.fetch<Watching>("watching");
  const links = (addresses.length ? addresses : [location.origin]).map((address) => `${address}/${watchQuery(token)}`);
  const reach = addresses.length
    ? h("p", { className: "hint" }, "Whoever has this link and is in the same network can watch; the network carries it unencrypted. Where there are several links, one of them is the way from the others’ computers.")
    : h("p", { className: "hint" }, "The studio serves this computer only: the link opens further windows here, for a second screen, say. To let others in your network watch, start it with ", h("code", {}, NETWORK), ".");
  const count = h("p", { role: "status" }, told(app.sharing.watchers));
  dialog(
    "Let others watch",
    "small",
    h("p", {}, "Who opens this link sees the run as you do, with a camera of their own, and can change nothing. The link holds as long as the studio runs."),
    ...links.map((link) => copyRow("Link to watch", link)),
    reach,
    count,
  );
  app.changed.watch(() => (count.textContent = told(app.sharing.watchers)));
}

/** A button that says how many watch, and leads to the link. */
export function watcherCount(app: App): HTMLElement {
  const number = h("span", {});
  const element = h("button", { type: "button", className: "watchers", hidden: true, onclick: () => void letOthersWatch(app).catch((error) => app.refused(error)) }, icon("eye"), number);
  app.changed.watch(() => {
    const { watchers } = app.sharing;
    element.hidden = !watchers;
    element.title = told(watchers);
    element.setAttribute("aria-label", told(watchers));
    number.textContent = String(watchers);
  });
  return element;
}

/** What stands in place of the controls in a window that watches. */
export function watchingNote(): HTMLElement {
  return h("p", { className: "watching-note", title: "Only the window that opened the studio runs, changes and paints. Your view is your own: turn, move and zoom it." }, "You watch. ", h("span", {}, "The view is yours to turn; another window commands the run."));
}

/** Let nothing in an element be changed, whatever it comes to show; groups open and close as usual. */
export function readOnly(element: HTMLElement): void {
  const disable = () => {
    for (const control of element.querySelectorAll<HTMLInputElement>("input, select, textarea, button")) {
      if (!control.closest(".whose, .tabs, .explain")) control.disabled = true;
    }
  };
  new MutationObserver(disable).observe(element, { childList: true, subtree: true });
  disable();
}

function told(count: number): string {
  return count === 1 ? "1 window watches" : `${count || "no"} windows watch`;
}
