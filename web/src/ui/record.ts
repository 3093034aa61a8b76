/** The winds of a record: they blow by a clock, which a scenario without one gets with its defaults. */

import type { App } from "../core/app";
import type { Json, JsonObject } from "../core/protocol";
import { noteRestart } from "./change_log";

/** The record that ships with Barchan. */
export const SHIPPED: JsonObject = { kind: "record" };
export const SHIPPED_NAME = "the made-up record that ships with Barchan";

/** Whether records blow only where the scenario gets a clock. */
export async function needsClock(app: App): Promise<boolean> {
  const { model = null, clock = null } = app.current!.description!.scenario;
  const allowed = (own: Json) => {
    const asked = app.connection.ask({ command: "variant", group: "wind", value: SHIPPED, beside: { model, clock: own } });
    return asked.then(() => true, () => false);
  };
  return clock === null && !(await allowed(null)) && (await allowed({}));
}

/** Let a record blow from now on; where that takes a clock the run begins again with one. Throws where it is refused. */
export async function blow(app: App, wind: JsonObject, name: string): Promise<void> {
  if (await needsClock(app)) return withClock(app, wind, name);
  await app.connection.ask({ command: "wind", wind, run: app.selected });
  app.notices.settle(["wind"]);
  app.note("info", `The winds of ${name} blow now.`);
}

/** Let a record blow from now on; where that takes a clock ask first, for the run would begin again. */
export async function offerToBlow(app: App, wind: JsonObject, name: string): Promise<void> {
  if (!(await needsClock(app))) return blow(app, wind, name);
  const act = () => void withClock(app, wind, name).catch((error) => app.refused(error, ["wind"]));
  app.notices.note("warning", `The winds of ${name} blow by a clock, which this scenario does not have.`, "wind", true, { name: "add a clock and begin again", act });
}

async function withClock(app: App, wind: JsonObject, name: string): Promise<void> {
  const { scenario } = app.current!.description!;
  await app.begin({ ...scenario, wind, clock: {} }, true, true);
  const made = [
    { path: ["clock"], before: null, value: {} },
    { path: ["wind"], before: scenario.wind ?? null, value: wind },
  ];
  app.restarts.push(...made);
  noteRestart(app, made);
  app.notices.settle(["wind", "clock"]);
  app.note("info", `The winds of ${name} blow from the start, by a clock with its defaults; see Clock in the panel.`);
}
