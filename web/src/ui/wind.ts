/** The wind: a dial, the list of regimes, and forms for every other kind. */

import { type App, PREPARING } from "../core/app";
import type { Json, JsonObject } from "../core/protocol";
import { entryOf, replaced } from "../core/schema";
import { Dial } from "./dial";
import { h, later } from "./dom";
import { type FormContext, group, kindsTold } from "./form";
import { type Icon, icon } from "./icons";
import { SHIPPED_NAME } from "./record";
import { RefreshGuard } from "./refresh_guard";
import { RefusedTexts } from "./refused_texts";
import { roses } from "./rose";
import { windWords } from "./wind_words";
import { labelOf } from "../core/labels";
import { lasting } from "./ramp";

export class WindPanel {
  readonly element = h("div", { className: "forms" });
  private wind: JsonObject = {};
  private shown = "";
  /** The wind whose roses were asked for last. */
  private asked = "";
  private chosen = 0;
  private readonly guard: RefreshGuard;
  private readonly refused: RefusedTexts;
  /** Roses, drift potential and remarks of the wind that the panel names. */
  private readonly rose = h("div", { "data-rose": "" });
  /** Whether a change made here is still to be sent. */
  private unsent = false;
  private readonly send = later(60, () => {
    this.unsent = false;
    void this.guard.during(this.tell());
  });

  /** ``fromFile`` asks for a record. */
  constructor(
    private readonly app: App,
    private readonly fromFile: () => void,
  ) {
    this.guard = new RefreshGuard(this.element, () => this.follow());
    this.refused = new RefusedTexts(app, this.element);
    app.described.watch(() => this.follow());
    app.changed.watch(() => this.follow());
    app.notices.changed.watch(() => this.refresh());
  }

  /** Let the wind blow; one that is refused leaves the one that blew before. */
  private async tell(): Promise<void> {
    if (await this.app.ask({ command: "wind", wind: this.wind }, ["wind"])) this.app.notices.settle(["wind"]);
    else this.refresh();
  }

  /** Show the accepted wind, and what was refused beside it. */
  private refresh(): void {
    this.shown = "";
    this.wind = {};
    this.follow();
  }

  /** Show the run's wind, unless it is being changed here. */
  private follow(): void {
    const wind = this.app.current?.description?.scenario.wind as JsonObject | undefined;
    if (!wind || !this.app.schema.properties || this.guard.busy || this.unsent) return;
    const text = JSON.stringify(wind);
    if (text !== this.shown) {
      this.shown = text;
      const known = text === JSON.stringify(this.wind);
      this.wind = wind;
      if (!known) this.draw();
    }
    if (text !== this.asked && this.app.connected) void this.drawRose(text);
  }

  private get kind(): string {
    return String(this.wind.kind);
  }

  private draw(): void {
    const entry = entryOf(this.app.schema.properties!.wind!, this.app.schema);
    const kinds = h(
      "select",
      { "aria-label": "Kind of wind", onchange: () => void this.become(kinds.value) },
      ...Object.keys(entry.variants).map((kind) => h("option", { value: kind, selected: kind === this.kind }, labelOf(kind))),
    );
    kinds.dataset.path = "wind.kind";
    const meaning = kindsTold(["wind"], "wind", entry, kinds);
    const body =
      "regimes" in this.wind ? this.regimes() : "direction" in this.wind ? this.steady() : this.form(this.kind, []);
    const open = new Set([...this.element.querySelectorAll("details[open]")].map((one) => one.id));
    const another: HTMLElement[] = this.kind === "record" ? [h("button", { type: "button", className: "quiet", onclick: this.fromFile }, "use another record …")] : [];
    if (another.length && !this.wind.path) another.unshift(h("p", { className: "hint" }, `The winds are of ${SHIPPED_NAME}.`));
    const turned = "regimes" in this.wind || "direction" in this.wind;
    const hint = h("p", { className: "hint" }, `Changes blow at once.${turned ? " Drag the dial’s head to where the wind comes from; with Shift it turns by less than 5°." : ""}`);
    const rows = [
      h("div", { className: "row" }, h("div", { className: "named" }, h("span", {}, "kind"), meaning.button), h("div", { className: "control" }, kinds), meaning.text),
      ...another,
      ...(turned ? [...body, hint, this.rose] : [this.rose, ...body, hint]),
    ];
    this.refused.through(() => this.element.replaceChildren(...rows));
    for (const details of this.element.querySelectorAll("details")) details.open = open.has(details.id);
  }

  /** Show the roses of the wind that blows, and until they come none of another wind. */
  private async drawRose(wind: string): Promise<void> {
    this.asked = wind;
    const details = this.rose.querySelector("details")?.open;
    this.rose.classList.add("coming");
    const late = setTimeout(() => {
      if (wind === this.asked) this.rose.replaceChildren(h("p", { className: "hint", role: "status" }, "The roses of this wind are being prepared …"));
      this.rose.classList.remove("coming");
    }, PREPARING);
    const answer = await this.app.connection.ask({ command: "rose", run: this.app.selected }).catch((error) => this.roseRefused(error));
    clearTimeout(late);
    if (wind !== this.asked) return;
    const rose = answer?.rose as JsonObject | null | undefined;
    this.rose.replaceChildren(...(rose ? [roses(rose), windWords(rose, details ?? true)] : []));
    this.rose.classList.remove("coming");
  }

  /** Say why there are no roses; where the connection was lost they are asked for again once it is back. */
  private roseRefused(error: unknown): null {
    if (this.app.connected) this.app.refused(error);
    else this.asked = "";
    return null;
  }

  private steady(): HTMLElement[] {
    const dial = new Dial("Direction the wind comes from (degrees)", ["direction"], (direction) => this.put(["direction"], direction));
    dial.show(Number(this.wind.direction));
    return [dial.element, ...this.form(this.kind, ["direction"])];
  }

  private form(kind: string, skip: string[]): HTMLElement[] {
    const entry = entryOf(this.app.schema.properties!.wind!, this.app.schema);
    return group(this.context(), entry.variants[kind] ?? {}, this.wind, [], skip);
  }

  private context(): FormContext {
    return {
      root: this.app.schema,
      change: (path, value) => {
        this.put(path, value);
        this.draw();
      },
      drag: (path, value) => this.put(path, value),
      variant: (path, key, name) => {
        this.put(path, { [key]: name });
        this.shown = "";
      },
      keyOf: (path) => ["wind", ...path].join("."),
      trouble: (key) => this.app.notices.troubles.get(key) ?? "",
      beside: null,
      live: () => true,
    };
  }

  private regimes(): HTMLElement[] {
    const list = this.wind.regimes as JsonObject[];
    this.chosen = Math.min(this.chosen, list.length - 1);
    const rows = list.map((regime, number) => this.summary(regime, number, list));
    return [
      h("ol", { className: "regimes", "aria-label": "Regimes" }, ...rows),
      h("button", { type: "button", className: "quiet", onclick: () => this.add() }, "+ add a regime"),
      ...this.form(this.kind, ["regimes"]),
      this.detail(list[this.chosen]!, this.chosen),
    ];
  }

  private summary(regime: JsonObject, number: number, list: JsonObject[]): HTMLElement {
    // Buttons take the list as it is when they are pressed: curves change it without redrawing it.
    const tool = (label: string, sign: Icon, change: (now: JsonObject[]) => JsonObject[], enabled: boolean) => {
      const act = () => {
        this.refused.forget("regimes.");
        this.reorder(change(this.wind.regimes as JsonObject[]));
      };
      return h("button", { type: "button", title: label, "aria-label": `${label}: regime ${number + 1}`, disabled: !enabled, onclick: act }, icon(sign));
    };
    const moved = (by: number) => (now: JsonObject[]) => {
      const order = now.toSpliced(number, 1);
      order.splice(number + by, 0, now[number]!);
      if (this.chosen === number) this.chosen += by;
      return order;
    };
    const speed = regime.speed === null || regime.speed === undefined ? "" : `, ${regime.speed}${regime.final_speed ? ` → ${regime.final_speed}` : ""}`;
    return h(
      "li",
      { className: number === this.chosen ? "chosen" : "" },
      h(
        "button",
        {
          type: "button",
          className: "regime",
          "aria-pressed": String(number === this.chosen),
          onclick: () => {
            this.chosen = number;
            this.draw();
          },
        },
        h("span", { className: "way", style: `transform: rotate(${Number(regime.direction)}deg)` }, icon("down")),
        ` ${regime.direction}°, ${lasting(regime)}${speed}`,
      ),
      tool("Up", "up", moved(-1), number > 0),
      tool("Down", "down", moved(1), number < list.length - 1),
      tool("Remove", "remove", (now) => now.toSpliced(number, 1), list.length > 1),
    );
  }

  private detail(regime: JsonObject, number: number): HTMLElement {
    const entry = entryOf(this.app.schema.properties!.wind!, this.app.schema);
    const schema = entryOf(entry.variants[this.kind]!.properties!.regimes!.items!, this.app.schema).schema;
    const path = ["regimes", number];
    const own = [...path, "direction"];
    const dial = new Dial(`Direction of regime ${number + 1} (degrees)`, own, (direction) => this.put(own, direction), 96);
    dial.show(Number(regime.direction));
    return h(
      "fieldset",
      {},
      h("legend", {}, `regime ${number + 1}`),
      dial.element,
      ...group(this.context(), schema, regime, path, ["direction"]),
    );
  }

  private add(): void {
    const list = this.wind.regimes as JsonObject[];
    this.chosen = list.length;
    this.reorder([...list, { ...list.at(-1)! }]);
  }

  private reorder(list: JsonObject[]): void {
    this.put(["regimes"], list as Json);
    this.draw();
  }

  private put(path: (string | number)[], value: Json): void {
    this.wind = replaced(this.wind, path, value) as JsonObject;
    this.unsent = true;
    this.send();
  }

  private async become(kind: string): Promise<void> {
    if (kind === "record") {
      this.refresh();
      return this.fromFile();
    }
    const direction = Number((this.wind.regimes as JsonObject[] | undefined)?.[0]?.direction ?? this.wind.direction ?? 270);
    const first: JsonObject = kind === "regimes" ? { regimes: [{ direction, steps: 100 }] } : {};
    const { model, clock } = this.app.current!.description!.scenario;
    const beside = { model: model ?? null, clock: clock ?? null };
    const answer = await this.app.ask({ command: "variant", group: "wind", value: { kind, ...first }, beside }, ["wind"]);
    if (!answer) return this.refresh();
    this.wind = answer.value as JsonObject;
    if ("direction" in this.wind) this.wind = { ...this.wind, direction };
    this.unsent = true;
    this.send();
    this.draw();
  }
}
