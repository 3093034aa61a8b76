/** Changes of a scenario in the words of the panel: `hop length 5 → 8 cells`. */

import type { App } from "../core/app";
import { valueLabel } from "../core/labels";
import { spokenKey } from "../core/notices";
import type { Change, Json, JsonObject } from "../core/protocol";
import { type Restart, same } from "../core/restarts";
import { schemaAt } from "../core/schema";
import { short } from "./dom";

/** A change during the run. */
export function changeWords(app: App, { key, before, value, summary }: Change): string {
  return key === "wind" ? `wind ${summary}` : words(app, key.split("."), before, value);
}

/** A change that restarted the run. */
export function restartWords(app: App, { path, before, value }: Restart): string {
  return words(app, path, before, value);
}

/** Each value in which a change of a whole group of one kind consists; any other change as it is. */
export function singly({ path, before, value }: Restart): Restart[] {
  if (same(before, value)) return [];
  if (!isGroup(before) || !isGroup(value) || nameOf(before) !== nameOf(value)) return [{ path, before, value }];
  const keys = [...new Set([...Object.keys(before), ...Object.keys(value)])];
  return keys.flatMap((key) => singly({ path: [...path, key], before: before[key] ?? null, value: value[key] ?? null }));
}

function words(app: App, path: (string | number)[], before: Json, value: Json): string {
  const unit = schemaAt(app.schema, app.current?.description?.scenario ?? null, path)?.unit;
  const named = path.length > 1 && path[0] === "model" ? path.slice(1) : path;
  const models = app.current?.description?.models ?? {};
  return `${spokenKey(named.join("."))} ${shown(before, models)} → ${shown(value, models)}${unit && unit !== "-" ? ` ${unit}` : ""}`;
}

function shown(value: Json, models: Record<string, string>): string {
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "on" : "off";
  if (typeof value === "string") return valueLabel(value, models);
  if (typeof value === "number") return short(value);
  return Array.isArray(value) ? `${value.length} items` : valueLabel(nameOf(value), models) || "on";
}

function isGroup(value: Json): value is JsonObject {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function nameOf(group: JsonObject): string {
  return String(group.kind ?? group.name ?? "");
}
