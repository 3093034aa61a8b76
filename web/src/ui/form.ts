/** Forms made from the schema of scenarios: no parameter is written down twice. */

import type { Json, JsonObject } from "../core/protocol";
import { otherValue } from "../core/beside";
import { type Entry, type Schema, allowedIn, entryOf, initial } from "../core/schema";
import { h, id, short } from "./dom";
import { explanation } from "./explained";
import { numberIn } from "../core/number_text";
import { numberControl } from "./number";
import { icon } from "./icons";
import { labelOf } from "../core/labels";
import { isCurve, isRamp, rampEditor } from "./ramp";

export type Path = (string | number)[];

export interface FormContext {
  root: Schema;
  /** Take a new value at a path. */
  change: (path: Path, value: Json, live: boolean) => void;
  /** Take a value while it is being dragged, without drawing the form again. */
  drag: (path: Path, value: Json) => void;
  /** Ask for a variant with all its defaults. */
  variant: (path: Path, key: string, name: string) => void;
  /** The key of a path within the scenario. */
  keyOf: (path: Path) => string;
  /** Why the value of a key was refused last; empty where it was not. */
  trouble: (key: string) => string;
  /** Run another value of a key beside the one now; null where two runs are shown already. */
  beside: ((key: string, value: Json) => void) | null;
  /** Whether a path can change while the run goes on. */
  live: (path: Path, schema: Schema) => boolean;
}

/** What it means that a text is left out, by its key. */
const NOTHING: Record<string, string> = { path: "bundled example" };

const HIDDEN = new Set(["note", "barchan"]);

/** The rows of a group of parameters, gathered under the headings that they declare. */
export function group(context: FormContext, schema: Schema, value: JsonObject, path: Path, skip: string[] = []): HTMLElement[] {
  const gathered = new Map<string, HTMLElement[]>();
  for (const [name, property] of Object.entries(schema.properties ?? {})) {
    const entry = entryOf(property, context.root);
    if (HIDDEN.has(name) || skip.includes(name) || entry.schema.const !== undefined) continue;
    if (entry.kind === "choice" && entry.choices.length === 1) continue;
    const under = property.group || entry.schema.group || "";
    const rows = gathered.get(under) ?? [];
    const ramp = isRamp(entry) && isCurve((value[name] ?? null) as JsonObject | null);
    rows.push(ramp ? rampField(context, name, schema, value, path) : field(context, name, property, value[name] ?? null, [...path, name]));
    gathered.set(under, rows);
  }
  return [...gathered].flatMap(([heading, rows]) => (heading ? [h("h2", {}, heading), ...rows] : rows));
}

/** A change in time as a curve between the values that stand beside it. */
function rampField(context: FormContext, name: string, schema: Schema, values: JsonObject, path: Path): HTMLElement {
  const first = schema.properties?.[name.endsWith("_ramp") ? name.slice(0, -"_ramp".length) : "first"];
  const unit = first && entryOf(first, context.root).schema.unit;
  const own = unit?.includes(" or ") ? String(values.unit ?? "") : unit;
  return rampEditor(name, values, own && own !== "-" ? ` ${own}` : "", (ramp) => context.drag([...path, name], ramp));
}

/** One parameter, whatever it is. */
export function field(context: FormContext, name: string, given: Schema, value: Json, path: Path): HTMLElement {
  const entry = entryOf(given, context.root);
  if (entry.kind === "variant") return variantField(context, name, given, value as JsonObject, path);
  if (entry.kind === "group" && !entry.nullable) {
    const rows = group(context, entry.schema, (value ?? {}) as JsonObject, path);
    return h("details", { className: "inner", id: `group-${path.join(".")}` }, h("summary", {}, labelOf(name)), ...rows);
  }
  if (entry.kind === "list") return listField(context, name, entry.schema, (value ?? []) as Json[], path);
  if (entry.kind === "group") return optionalGroup(context, name, entry.schema, value as JsonObject | null, path);
  return row(context, name, given, value, path);
}

/** A group of which there are several kinds, with a choice between them. */
export function variantField(context: FormContext, name: string, given: Schema, value: JsonObject, path: Path): HTMLElement {
  const entry = entryOf(given, context.root);
  const kind = String(value?.[entry.key] ?? "");
  const label = id("kind");
  const choice = h(
    "select",
    {
      id: label,
      onchange: (event: Event) => context.variant(path, entry.key, (event.target as HTMLSelectElement).value),
    },
    ...Object.keys(entry.variants).map((one) => h("option", { value: one, selected: one === kind }, labelOf(one))),
  );
  choice.dataset.path = path.join(".");
  const variant = entry.variants[kind] ?? {};
  const meaning = kindsTold(path, name, entry, choice);
  return h(
    "fieldset",
    {},
    h("legend", {}, labelOf(name)),
    h(
      "div",
      { className: "row" },
      h("div", { className: "named" }, h("label", { for: label }, "kind"), meaning.button),
      h("div", { className: "control" }, choice),
      trouble(context, path),
      meaning.text,
    ),
    ...group(context, variant, value ?? {}, path),
  );
}

/** What each of several kinds is. */
export function kindsTold(path: Path, name: string, entry: Entry, choice: Element): ReturnType<typeof explanation> {
  const kinds = Object.entries(entry.variants).map(([kind, { properties }]) => `${labelOf(kind)}: ${properties?.[entry.key]?.description ?? ""}`);
  return explanation(path.join("."), labelOf(name), kinds.join("\n"), choice);
}

function optionalGroup(context: FormContext, name: string, schema: Schema, value: JsonObject | null, path: Path): HTMLElement {
  const { default: _, ...filled } = schema;
  const box = h("input", {
    type: "checkbox",
    checked: value !== null,
    id: id("group"),
    onchange: () => context.change(path, box.checked ? initial(filled, context.root) : null, false),
  });
  const rows = value === null ? [] : group(context, schema, value, path);
  const meaning = told(path, name, schema, box);
  const head = h("div", { className: "row" }, h("div", { className: "named" }, h("label", { for: box.id, title: schema.description ?? "" }, labelOf(name)), meaning?.button), box, meaning?.text);
  return h("div", {}, head, ...rows);
}

/** What a group, a list or a kind is, where its schema tells it. */
function told(path: Path, name: string, schema: Schema, field?: Element): ReturnType<typeof explanation> | null {
  return schema.description ? explanation(path.join("."), labelOf(name), schema.description, field) : null;
}

function listField(context: FormContext, name: string, schema: Schema, value: Json[], path: Path): HTMLElement {
  const put = (items: Json[]) => context.change(path, items, false);
  const items = value.map((item, number) => {
    const move = (by: number) => {
      const moved = [...value];
      moved.splice(number, 1);
      moved.splice(number + by, 0, item);
      put(moved);
    };
    const tools = [
      number > 0 && h("button", { type: "button", title: "Up", "aria-label": "Up", onclick: () => move(-1) }, icon("up")),
      number < value.length - 1 &&
        h("button", { type: "button", title: "Down", "aria-label": "Down", onclick: () => move(1) }, icon("down")),
      h("button", { type: "button", title: "Remove", "aria-label": "Remove", onclick: () => put(value.toSpliced(number, 1)) }, icon("remove")),
    ];
    const inner = field(context, `${name} ${number + 1}`, schema.items ?? {}, item, [...path, number]);
    return h("div", { className: "item" }, inner, h("div", { className: "tools" }, ...tools));
  });
  const add = () => put([...value, initial(schema.items ?? {}, context.root)]);
  const most = (schema as { maxItems?: number }).maxItems ?? Number.POSITIVE_INFINITY;
  const meaning = told(path, name, schema);
  return h(
    "fieldset",
    { title: schema.description ?? "" },
    h("legend", { className: "named" }, labelOf(name), meaning?.button),
    meaning?.text,
    ...items,
    value.length < most && h("button", { type: "button", onclick: add, className: "quiet" }, `+ add to ${labelOf(name)}`),
  );
}

function row(context: FormContext, name: string, given: Schema, value: Json, path: Path): HTMLElement {
  const entry = entryOf(given, context.root);
  const { schema } = entry;
  const live = context.live(path, schema);
  const known = schema.default !== undefined;
  const label = id("row");
  const take = (next: Json) => context.change(path, next, live);
  const unit = schema.unit && schema.unit !== "-" ? schema.unit : "";
  const controls = control(entry, value, take, label, path);
  const changed = known && JSON.stringify(value) !== JSON.stringify(schema.default);
  const putBack = `Put the default of ${labelOf(name)} back: ${shown(schema.default ?? null)}`;
  const reset = h(
    "button",
    {
      type: "button",
      className: "reset",
      hidden: !changed,
      title: putBack,
      "aria-label": putBack,
      onclick: () => take(schema.default ?? null),
    },
    icon("back"),
  );
  const said = explained(schema, live);
  const meaning = explanation(path.join("."), labelOf(name), said, controls.find((one) => one.id === label));
  return h(
    "div",
    { className: "row", title: said },
    h("div", { className: "named" }, h("label", { for: label }, labelOf(name), unit && h("span", { className: "unit" }, unit), !live && restartMark()), meaning.button),
    h("div", { className: "control" }, ...controls, reset, besideButton(context, entry, name, value, path)),
    trouble(context, path),
    meaning.text,
  );
}

/** The mark of what restarts the run when it is changed. */
export function restartMark(): HTMLElement {
  return h("span", { className: "restarts", role: "img", "aria-label": "restarts the run" }, icon("restart"));
}

/** One click that shows another value of a model's parameter beside the one now. */
function besideButton(context: FormContext, entry: Entry, name: string, value: Json, path: Path): HTMLElement | false {
  const { beside } = context;
  const other = otherValue(entry, value);
  if (!beside || other === null || path[0] !== "model" || path.length !== 2) return false;
  const label = `Show ${labelOf(name)} ${shown(value)} and ${shown(other)} side by side; both start at step 0, and ‘alone again’ leads back to the run as it is now`;
  return h("button", { type: "button", className: "beside", title: label, "aria-label": label, onclick: () => beside(context.keyOf(path), other) }, icon("beside"));
}

/** The place where it stands why a value was refused. */
function trouble(context: FormContext, path: Path): HTMLElement {
  const key = context.keyOf(path);
  return h("output", { className: "trouble", "data-trouble": key }, context.trouble(key));
}

function control(
  entry: ReturnType<typeof entryOf>,
  value: Json,
  take: (value: Json) => void,
  label: string,
  path: Path,
): HTMLElement[] {
  const mark = <T extends HTMLElement>(element: T): T => {
    element.id = label;
    element.dataset.path = path.join(".");
    return element;
  };
  if (entry.kind === "boolean") {
    const box = h("input", { type: "checkbox", checked: value === true, onchange: () => take(box.checked) });
    return [mark(box)];
  }
  if (entry.kind === "choice") {
    const none = entry.nullable ? [null] : [];
    const options = [...none, ...entry.choices];
    const select = h(
      "select",
      { onchange: () => take(options[select.selectedIndex] ?? null) },
      ...options.map((one) => h("option", { selected: one === value }, shown(one))),
    );
    return [mark(select)];
  }
  if (entry.kind === "number" || entry.kind === "integer") return numberControl(entry, value, take, mark, path);
  const text = h("input", {
    type: "text",
    value: value === null ? "" : String(value),
    placeholder: entry.nullable ? (NOTHING[String(path.at(-1))] ?? "none") : "",
    onchange: () => take(readText(text.value, entry.nullable, entry.choices.length > 0)),
  });
  if (!entry.choices.length) return [mark(text)];
  const choices = h("datalist", { id: id("choices") }, ...entry.choices.map((one) => h("option", { value: String(one) })));
  text.setAttribute("list", choices.id);
  return [mark(text), choices];
}

function readText(text: string, nullable: boolean, mixed: boolean): Json {
  if (text === "" && nullable) return null;
  return (mixed ? numberIn(text) : null) ?? text;
}

function explained(schema: Schema, live: boolean): string {
  const bounds = allowedIn(schema, (value) => short(value, 9));
  const allowed = bounds && `Allowed: ${bounds}. `;
  const source = schema.source ? `Source: ${schema.source}. ` : "";
  const when = live ? "Changes at once." : "Changing it restarts the run.";
  return `${schema.description ?? ""}\n${allowed}${source}${when}`;
}

function shown(value: Json): string {
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "on" : "off";
  return typeof value === "string" ? labelOf(value) : typeof value === "number" ? short(value, 9) : JSON.stringify(value);
}
