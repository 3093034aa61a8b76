/** The page of moments: bookmarks of the run, to go to, to name otherwise, to remove. */

import type { App } from "../core/app";
import { type Bookmark, Bookmarks } from "../core/bookmarks";
import type { JsonObject } from "../core/protocol";
import { labelOf } from "../core/labels";
import type { Standpoint } from "../scene/camera";
import { plainFields } from "../scene/colouring";
import type { Stage } from "../scene/stage";
import { formDialog } from "./dialog";
import { button, h, short } from "./dom";
import { icon } from "./icons";

export class Moments {
  readonly element: HTMLElement;
  private readonly bookmarks: Bookmarks;
  private readonly list = h("ol", { className: "moments" });
  private readonly none = h("p", { className: "hint" }, "None yet. Mark what you want to come back to, or to show: the horns that grow, the moment before the wind turns.");
  private shown = "";

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    this.bookmarks = new Bookmarks(app);
    this.element = h(
      "div",
      { className: "forms" },
      h("button", { type: "button", className: "wide", onclick: () => void this.mark() }, "mark this moment (K)"),
      this.none,
      this.list,
      h("p", { className: "hint" }, "A moment keeps its state to the bit, where you look from, and what colours the surface. The browser keeps it for runs of the same scenario and seed, a saved run for whoever opens it. A run that has not come so far goes on to it."),
    );
    app.described.watch(() => this.show());
    app.changed.watch(() => this.show());
  }

  /** Set a bookmark at what is shown. */
  async mark(): Promise<void> {
    const { status } = this.app.current ?? {};
    if (!status) return;
    const name = `moment ${this.bookmarks.list.length + 1}`;
    const known = new Set(this.bookmarks.list.map(({ id }) => id));
    await this.bookmarks.add(name, this.app.view.look.field, this.stage.standpoint() as unknown as JsonObject);
    const set = this.bookmarks.list.find(({ id }) => !known.has(id));
    if (set) this.app.notices.confirm(`Marked as “${name}” at step ${short(set.step, 9)}; see Moments in the panel.`);
  }

  private async visit(bookmark: Bookmark): Promise<void> {
    this.app.view.set({ field: bookmark.colour_by || this.app.view.look.field });
    this.stage.stand(bookmark.camera as unknown as Standpoint);
    await this.bookmarks.visit(bookmark);
  }

  private rename(bookmark: Bookmark): void {
    const name = h("input", { type: "text", required: true, maxLength: 120, value: bookmark.name, "aria-label": "Name of the moment" });
    formDialog("Name of the moment", "name it", () => this.bookmarks.rename(bookmark, name.value.trim()), h("div", { className: "row" }, h("span", {}, "name"), name));
    name.select();
  }

  private show(): void {
    const { list } = this.bookmarks;
    const text = JSON.stringify([list, this.app.current?.description?.branches.length]);
    if (text === this.shown) return;
    this.shown = text;
    this.none.hidden = list.length > 0;
    this.list.replaceChildren(...list.map((bookmark) => this.row(bookmark)));
  }

  /** What coloured the surface, in words: fields have short names of their own. */
  private colours(name: string): string {
    const run = this.app.current!;
    return [...plainFields(run.material), ...run.description!.fields].find((field) => field.name === name)?.meaning ?? labelOf(name);
  }

  private row(bookmark: Bookmark): HTMLElement {
    const branches = this.app.current!.description!.branches.length > 1 && `branch ${bookmark.branch}`;
    const facts = [`step ${short(bookmark.step, 9)}`, branches, this.colours(bookmark.colour_by)].filter(Boolean).join(" · ");
    return h(
      "li",
      {},
      h("button", { type: "button", className: "moment", title: `Go to ${bookmark.name}`, onclick: () => void this.visit(bookmark) }, h("b", {}, bookmark.name), h("small", {}, facts)),
      button(`Name ${bookmark.name} otherwise`, icon("pen"), () => this.rename(bookmark)),
      button(`Remove ${bookmark.name}`, icon("remove"), () => void this.bookmarks.remove(bookmark)),
    );
  }
}
