/** The controls of a view in a notebook: run, pause, step, speed, and the field that colours the surface. */

import type { App } from "../core/app";
import { plainFields } from "../scene/colouring";
import { button, duration, h, short } from "../ui/dom";
import { icon } from "../ui/icons";
import { Speed } from "../ui/speed";

export class Controls {
  readonly element: HTMLElement;
  private readonly title = h("span", { className: "title" });
  private readonly play: HTMLButtonElement;
  private readonly moving: HTMLElement;
  private readonly speed: Speed;
  private readonly step = h("output", { className: "step" });
  private readonly field = h("select", { "aria-label": "Field that colours the surface", title: "Field that colours the surface" });
  private offered = "";

  constructor(
    private readonly app: App,
    choose: (field: string) => void,
    private readonly looksOnly: boolean,
  ) {
    this.play = button("Run", icon("run"), () => app.send({ command: app.running ? "pause" : "run" }), { className: "primary" });
    this.speed = new Speed(app);
    this.field.addEventListener("change", () => choose(this.field.value));
    this.moving = h(
      "div",
      { className: "controls", role: "group", "aria-label": "Run", hidden: looksOnly },
      this.play,
      button("One step", icon("step"), () => app.send({ command: "run", steps: 1 })),
      this.speed.element,
      button("Restart with the same seed", icon("restart"), () => app.send({ command: "restart" })),
    );
    this.element = h("header", { className: "bar" }, this.moving, this.step, this.title, this.field);
    app.framed.watch(() => this.show());
    app.described.watch(() => this.offer());
  }

  private offer(): void {
    const { description, material } = this.app.current!;
    this.title.textContent = String(description!.scenario.title || description!.model.title);
    const fields = [...plainFields(material), ...description!.fields];
    const key = fields.map(({ name }) => name).join();
    if (key !== this.offered) this.field.replaceChildren(...fields.map(({ name, meaning }) => h("option", { value: name }, meaning)));
    this.offered = key;
    this.field.value = this.app.view.look.field;
  }

  private show(): void {
    const status = this.app.current?.status;
    if (!status) return;
    const label = status.running ? "Pause" : "Run";
    if (this.play.title !== label) {
      this.play.replaceChildren(icon(status.running ? "pause" : "run"));
      this.play.title = label;
      this.play.setAttribute("aria-label", label);
    }
    this.play.disabled = status.finished !== null && !this.looksOnly;
    this.play.title = status.finished ?? label;
    this.speed.show(status.limit);
    this.step.textContent = `step ${short(status.step, 9)}${status.time === null ? "" : ` · ${duration(status.time)}`}`;
    if (this.field.value !== this.app.view.look.field) this.field.value = this.app.view.look.field;
  }
}
