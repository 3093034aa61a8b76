/** Another model beside: the same ground, wind and seed. */

import type { App } from "../core/app";
import { h } from "./dom";

export class Compare {
  readonly element: HTMLElement;
  private readonly select = h("select", { "aria-label": "Compare with another model", title: "Run another model beside, on the same ground, under the same wind, from the same seed" });
  private shown = "";

  constructor(private readonly app: App) {
    this.select.addEventListener("change", () => this.choose());
    this.element = h("div", { className: "compare" }, this.select);
    app.described.watch(() => this.draw());
    app.changed.watch(() => this.draw());
  }

  private choose(): void {
    const model = this.select.value;
    if (model === "") {
      this.app.send({ command: "alone" });
      this.app.view.set({ side: "surface" });
    } else void this.begin(model);
  }

  private async begin(model: string): Promise<void> {
    if (await this.app.ask({ command: "compare", model })) return;
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
      h("option", { value: "", selected: second === "" }, second ? "alone again" : "compare …"),
      ...Object.entries(models).map(([name, title]) => h("option", { value: name, selected: name === second }, title)),
    );
  }
}
