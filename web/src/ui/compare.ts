/** Another model beside: the same ground, wind and seed. */

import type { App } from "../core/app";
import type { Json } from "../core/protocol";
import { h, short } from "./dom";

/** Start two runs that are compared, both at step 0; returns whether they run. The run that is alone now is set aside. */
export async function compare(app: App, other: { model: string } | { key: string; value: Json }): Promise<boolean> {
  const alone = app.runs.length === 1 ? app.current?.status?.live : undefined;
  if (!(await app.ask({ command: "compare", ...other }))) return false;
  if (alone !== undefined) void app.wayBack.compared();
  const aside = alone ? ` The run up to step ${short(alone, 9)} is set aside with its moments; ‘alone again’ leads back to it.` : "";
  app.note("info", `Two runs are compared, both from step 0.${aside}`);
  return true;
}

export class Compare {
  readonly element: HTMLElement;
  private readonly select = h("select", { "aria-label": "Compare with another model", title: "Run another model beside, on the same ground, under the same wind, from the same seed. Both start at step 0; the run until now is set aside with its moments." });
  private shown = "";

  constructor(private readonly app: App) {
    this.select.addEventListener("change", () => this.choose());
    this.element = h("div", { className: "compare" }, this.select);
    app.described.watch(() => this.draw());
    app.changed.watch(() => this.draw());
  }

  private choose(): void {
    const model = this.select.value;
    if (model === "") void this.alone();
    else void this.begin(model);
  }

  private async alone(): Promise<void> {
    const answer = await this.app.ask({ command: "alone" });
    if (!answer) return;
    this.app.view.set({ side: "surface" });
    this.app.note("info", answer.stays ? "The left run is alone; the right one has ended." : "The run is alone again, as it was before the comparison; the one that was compared is a branch of it.");
  }

  private async begin(model: string): Promise<void> {
    if (await compare(this.app, { model })) return;
    this.shown = ""; // what was chosen was refused: show what is
    this.draw();
  }

  private draw(): void {
    const models = this.app.runs[0]?.description?.models ?? {};
    const second = this.app.run("b")?.description?.model.name ?? "";
    const key = JSON.stringify([models, second]);
    if (key === this.shown) return;
    this.shown = key;
    this.select.replaceChildren(
      h("option", { value: "", selected: second === "" }, second ? "alone again: the run as it was" : "compare …"),
      ...Object.entries(models).map(([name, title]) => h("option", { value: name, selected: name === second }, title)),
    );
  }
}
