/** The panel of a scenario: made from the schema, every change taken at once. */

import type { App } from "../core/app";
import type { Json, JsonObject } from "../core/protocol";
import { compare } from "./compare";
import { type Schema, at, entryOf, replaced } from "../core/schema";
import { readable, withoutNames } from "../core/labels";
import { remaining } from "../core/restarts";
import { namesOf } from "../core/run";
import { h, id, later } from "./dom";
import { type FormContext, type Path, field, group, restartMark, variantField } from "./form";
import { noteRestart } from "./change_log";
import { changeList } from "./changes";
import { RefreshGuard } from "./refresh_guard";
import { RefusedTexts } from "./refused_texts";

/** The key of the loose layer at the start, which is named after the model's material. */
const LOOSE = "sand";
/** Groups that keep their values when all defaults are put back: the wind has a page of its own, the run its seed. */
const KEPT = new Set(["wind", "run", "weather"]);
/** Keys of a scenario that are shown elsewhere, or are no groups. */
const ELSEWHERE = new Set(["barchan", "note", "title", "citation", "look_for", "question", "wind", "model"]);

export class Panel {
  readonly element = h("div", { className: "forms" });
  private shown = "";
  private scenario: JsonObject = {};
  /** Changes that restart the run and are still to be sent. */
  private unsent: [Path, Json][] = [];
  /** The last request, so that each builds on what the one before it has changed. */
  private sent: Promise<void> = Promise.resolve();
  private readonly create = later(350, () => this.submit());
  private readonly guard: RefreshGuard;
  private readonly refused: RefusedTexts;

  /** ``fromFile`` asks for a file of heights. */
  constructor(
    private readonly app: App,
    private readonly fromFile: () => void,
  ) {
    this.guard = new RefreshGuard(this.element, () => this.show());
    this.refused = new RefusedTexts(app, this.element);
    app.described.watch(() => this.show());
    app.changed.watch(() => this.show());
    app.notices.changed.watch(() => this.refresh());
  }

  /** Show the scenario as it was accepted last, and what was refused beside it. */
  private refresh(): void {
    this.shown = "";
    this.show();
  }

  private show(): void {
    const description = this.app.current?.description;
    if (!description || !this.app.schema.properties || this.guard.busy || this.unsent.length) return;
    const text = JSON.stringify([description.scenario, description.changes, description.materials, description.facts, this.app.selected, namesOf(this.app.runs)]);
    if (text === this.shown) return;
    this.shown = text;
    this.scenario = description.scenario;
    const focused = (document.activeElement as HTMLElement | null)?.dataset?.path;
    const open = new Set([...this.element.querySelectorAll("details[open]")].map((one) => one.id));
    const scroll = this.element.parentElement?.scrollTop ?? 0;
    const first = !this.element.children.length;
    this.refused.through(() => this.element.replaceChildren(...this.sections()));
    for (const details of this.element.querySelectorAll("details")) {
      details.open = first ? details.id === "group-model" : open.has(details.id);
    }
    if (this.element.parentElement) this.element.parentElement.scrollTop = scroll;
    if (focused) this.element.querySelector<HTMLElement>(`[data-path="${focused}"]`)?.focus();
  }

  private sections(): HTMLElement[] {
    const root = this.app.schema;
    const context: FormContext = {
      root,
      change: (path, value, live) => this.change(path, value, live),
      drag: (path, value) => this.change(path, value, false),
      variant: (path, key, name) => void this.variant(path, key, name),
      keyOf: (path) => path.join("."),
      trouble: (key) => this.app.notices.troubles.get(key) ?? "",
      beside: this.app.runs.length > 1 ? null : (key, value) => void this.beside(key, value),
      live: (path, schema) => path[0] === "model" && !path.some(Number.isInteger) && schema.live === true,
    };
    const [look, question, citation] = ["look_for", "question", "citation"].map((name) => withoutNames(String(this.scenario[name] ?? "")));
    const about = h(
      "div",
      { className: "about" },
      look && h("p", {}, look),
      question && h("p", { className: "question" }, question),
      h("p", { className: "source" }, readable(citation!, this.app.current!.description!.models)),
    );
    return [
      ...this.whose(),
      about,
      this.model(context),
      ...Object.keys(root.properties ?? {})
        .filter((name) => !ELSEWHERE.has(name))
        .map((name) => this.group(context, name)),
      this.changes(),
      action("put all defaults back", () => void this.putDefaultsBack()),
      h("p", { className: "hint" }, restartMark(), " restarts the run; everything else changes at once. Point at a row to read what it means."),
    ];
  }

  /** Run another value beside; the panel then shows the parameters of the right one. */
  private async beside(key: string, value: Json): Promise<void> {
    if (!(await compare(this.app, { key, value }))) return;
    this.app.selected = "b";
    this.app.changed.send();
  }

  private whose(): HTMLElement[] {
    if (this.app.runs.length < 2) return [];
    const choose = (name: "a" | "b") => {
      this.app.selected = name;
      this.app.changed.send();
    };
    const names = namesOf(this.app.runs);
    const tabs = this.app.runs.map((run, at) =>
      h(
        "button",
        { type: "button", "aria-pressed": String(run.name === this.app.selected), onclick: () => choose(run.name) },
        `${at ? "right" : "left"}: ${names[at]}`,
      ),
    );
    return [h("div", { className: "whose", role: "group", "aria-label": "Whose parameters" }, ...tabs)];
  }

  private model(context: FormContext): HTMLElement {
    const root = this.app.schema;
    const model = (this.scenario.model ?? {}) as JsonObject;
    const entry = entryOf(root.properties!.model!, root);
    const { models, materials, model: own, facts } = this.app.current!.description!;
    const material = materials[own.name]!;
    const label = id("model");
    const choice = h(
      "select",
      { id: label, onchange: () => void this.variant(["model"], "name", choice.value) },
      ...Object.entries(models)
        .filter(([name]) => materials[name] === material)
        .map(([name, title]) => h("option", { value: name, selected: name === model.name }, title)),
    );
    choice.dataset.path = "model.name";
    const known = Object.entries(facts).map(([name, text]) => h("div", {}, h("dt", {}, name), h("dd", {}, text)));
    return details(
      "model",
      "Model",
      this.material(material, materials),
      h("div", { className: "row" }, h("label", { for: label }, "model", restartMark()), h("div", { className: "control" }, choice)),
      h("p", { className: "source" }, own.citation),
      ...group(context, entry.variants[String(model.name)] ?? {}, model, ["model"]),
      known.length > 0 && h("dl", { className: "facts" }, ...known),
    );
  }

  /** The material that the model moves: a choice if there are models of several materials. */
  private material(material: string, materials: Record<string, string>): HTMLElement {
    const label = id("material");
    const all = [...new Set(Object.values(materials))];
    const first = (wanted: string) => Object.keys(materials).find((name) => materials[name] === wanted)!;
    const choice = h(
      "select",
      { id: label, onchange: () => void this.variant(["model"], "name", first(choice.value)) },
      ...all.map((name) => h("option", { value: name, selected: name === material }, name)),
    );
    choice.dataset.path = "material";
    const shown = all.length > 1 ? choice : h("output", { id: label, "data-path": "material" }, material);
    return h("div", { className: "row" }, h("label", { for: label }, "material"), h("div", { className: "control" }, shown));
  }

  private group(context: FormContext, name: string): HTMLElement {
    const root = this.app.schema;
    const schema: Schema = root.properties![name]!;
    const entry = entryOf(schema, root);
    const value = (this.scenario[name] ?? {}) as JsonObject;
    const title = name === LOOSE ? `${capital(this.app.current!.material)} at the start` : capital(name);
    if (entry.nullable) return details(name, title, field(context, name, schema, this.scenario[name] ?? null, [name]));
    const another = value.kind === "file" && name === "ground" && action("use another file …", this.fromFile);
    if (entry.kind === "variant") return details(name, title, another, ...unwrapped(variantField(context, name, schema, value, [name])));
    return details(name, title, ...group(context, entry.schema, value, [name]));
  }

  private change(path: Path, value: Json, live: boolean): void {
    const before = at(this.scenario, path);
    if (Array.isArray(value) && Array.isArray(before) && value.length <= before.length) this.refused.forget(`${path.join(".")}.`);
    this.scenario = replaced(this.scenario, path, value) as JsonObject;
    if (live) void this.guard.during(this.set(path.join("."), value));
    else {
      this.unsent.push([path, value]);
      this.create();
    }
  }

  private async set(key: string, value: Json): Promise<void> {
    if (await this.app.ask({ command: "set", key, value, run: this.app.selected }, [key])) this.app.notices.settle([key]);
    else this.shown = ""; // the row shows the accepted value again
  }

  /** Send the changes that restart the run, once those sent before are answered. */
  private submit(): void {
    this.sent = this.sent.then(() => this.guard.during(this.begin(this.unsent.splice(0))));
  }

  /** Start the accepted scenario with these changes, and no others: a value refused before cannot hinder them. */
  private async begin(changes: [Path, Json][]): Promise<void> {
    const accepted = this.app.current?.description?.scenario;
    if (!accepted || !changes.length) return;
    const scenario = changes.reduce<Json>((data, [path, value]) => replaced(data, path, value), accepted);
    const keys = changes.map(([path]) => path.join("."));
    if (await this.app.create(scenario as JsonObject, true, true, keys)) {
      this.app.notices.settle(keys);
      const made = changes.map(([path, value]) => ({ path, before: at(accepted, path) ?? null, value }));
      this.app.restarts.push(...made);
      noteRestart(this.app, made);
    }
    this.shown = "";
  }

  private changes(): HTMLElement {
    const restart = (path: Path, value: Json) => {
      this.unsent.push([path, value]);
      this.submit();
    };
    const list = changeList(this.app, remaining(this.app.restarts, this.scenario), restart);
    return details("changes", "Changes", list);
  }

  /** The defaults of every group, under the same model, kinds of ground and sand, and seed. */
  private async putDefaultsBack(): Promise<void> {
    const own = ["kind", "name", "path", "lowest", "highest"]; // what makes a group what it is
    const { model, wind, clock, weather } = this.scenario;
    for (const [group, value] of Object.entries(this.scenario)) {
      if (KEPT.has(group) || value === null || typeof value !== "object" || Array.isArray(value)) continue;
      const kind = Object.fromEntries(Object.entries(value).filter(([key]) => own.includes(key)));
      const beside = { model: model ?? null, wind: wind ?? null, clock: clock ?? null, weather: weather ?? null };
      const answer = await this.app.ask({ command: "variant", group, value: kind, beside });
      if (answer) this.unsent.push([[group], answer.value as Json]);
    }
    this.submit();
  }

  private async variant(path: Path, key: string, name: string): Promise<void> {
    const whole = replaced(this.scenario, path, { [key]: name }) as JsonObject;
    const group = String(path[0]);
    const needsFile = name === "file";
    if (needsFile) {
      this.refresh();
      return this.fromFile();
    }
    const answer = await this.app.ask({ command: "variant", group, value: whole[group] ?? null }, [group]);
    if (!answer) return this.refresh();
    this.unsent.push([[group], answer.value as Json]);
    this.submit();
  }
}

function action(text: string, act: () => void): HTMLElement {
  return h("button", { type: "button", className: "quiet", onclick: act }, text);
}

function details(name: string, title: string, ...children: (Node | false | null)[]): HTMLElement {
  return h("details", { id: `group-${name}` }, h("summary", {}, title), ...children);
}

function unwrapped(fieldset: HTMLElement): HTMLElement[] {
  return ([...fieldset.children] as HTMLElement[]).filter((child) => child.tagName !== "LEGEND");
}

function capital(name: string): string {
  return name.charAt(0).toUpperCase() + name.slice(1);
}
