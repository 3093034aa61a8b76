/** Links of scenarios: made, opened, and offered when the page is opened with one; nothing starts without a click. */

import type { App } from "../core/app";
import { Refused } from "../core/connection";
import type { Command, JsonObject, Problem } from "../core/protocol";
import { valueLabel } from "../core/labels";
import { namesOf, titleOf } from "../core/run";
import { holdsScenario, scenarioLink, scenariosIn } from "../core/scenario_link";
import { copyRow } from "./copy_row";
import { dialog, formDialog } from "./dialog";
import { counted, h } from "./dom";
import type { Files } from "./files";

/** Where a page without a token hands its link on to a window of the studio that is open. */
const CHANNEL = "barchan-links";
const NAME = "the link";

/** A sheet with the link of the scenario that is shown; of two runs with that of both as well. */
export async function copyScenarioLink(app: App): Promise<void> {
  const { current, runs } = app;
  const scenario = current?.description?.scenario;
  if (!scenario) return;
  const own = await linkRow("Link of the scenario", [scenario]);
  const at = runs.indexOf(current!);
  const pair = runs.length > 1 ? [
    h("p", {}, "Both runs, which start side by side again:"),
    await linkRow("Link of both scenarios", runs.map((run) => run.description!.scenario)).catch((error: Error) => h("p", { className: "hint" }, error.message)),
    h("p", {}, `The ${at ? "right" : "left"} one alone, `, h("b", {}, namesOf(runs)[at]!), ", whose parameters the panel shows:"),
  ] : [];
  dialog(
    "A link of this scenario",
    "small",
    h("p", {}, "It holds every value, the seed included, and nothing of the run; opened, it offers to start the scenario. What stands behind the # stays in the browser: no server gets to see it."),
    ...pair,
    own,
    h("p", { className: "hint" }, `Who opens it needs a studio that runs at ${location.origin}; in one at another address, `, h("i", {}, "File, open a link of a scenario"), " takes it."),
  );
}

async function linkRow(label: string, scenarios: JsonObject[]): Promise<HTMLElement> {
  const link = await scenarioLink(scenarios, `${location.origin}/`);
  return h("div", {}, copyRow(label, link), h("p", { className: "hint" }, `${link.length} characters`));
}

/** A sheet that takes a link. */
export function askForLink(app: App, files: Files): void {
  const input = h("input", { type: "text", required: true, "aria-label": "Link of a scenario", autocomplete: "off", spellcheck: false });
  formDialog("Open a link of a scenario", "open it", () => offer(app, files, input.value), h("div", { className: "row" }, h("span", {}, "link"), input));
}

/** Offer to start the scenario of a link, or both of two. Throws where the link is damaged, or one of two has mistakes. */
async function offer(app: App, files: Files, link: string): Promise<void> {
  const texts = await scenariosIn(link);
  const answers = await Promise.all(texts.map((text) => app.connection.ask({ command: "check", name: NAME, text })));
  const problems = answers.flatMap((answer) => answer.problems as unknown as Problem[]);
  const [first] = answers;
  if (!problems.length && answers.every((answer) => answer.scenario)) show(app, answers.map((answer) => answer.scenario as JsonObject));
  else if (answers.length > 1) throw new Refused("the link of two scenarios", problems);
  else files.offer(NAME, problems, first!.scenario as JsonObject | null, first!.changes as string[] | undefined);
}

function titleIn(app: App, scenario: JsonObject): string {
  return titleOf({ scenario, models: app.current?.description?.models });
}

/** Title and facts of a scenario, and what to look for. */
function told(app: App, scenario: JsonObject, looks: boolean): HTMLElement {
  const { rows, columns, kind } = scenario.lattice as JsonObject;
  const model = String((scenario.model as JsonObject).name);
  const cells = rows === undefined ? `lattice ${String(kind)}` : `${String(columns)} × ${String(rows)} cells`;
  const { steps, seed } = scenario.run as { steps: number; seed: number | null };
  const facts = [valueLabel(model, app.current?.description?.models), cells, counted(steps, "step"), seed === null ? "no seed" : `seed ${seed}`];
  return h(
    "div",
    {},
    h("h3", {}, titleIn(app, scenario)),
    h("p", { className: "source" }, facts.join(" · ")),
    looks && scenario.look_for ? h("p", {}, String(scenario.look_for)) : false,
  );
}

function show(app: App, scenarios: JsonObject[]): void {
  const [first, beside] = scenarios as [JsonObject, JsonObject?];
  const title = scenarios.map((scenario) => titleIn(app, scenario)).join(" and ");
  const start = async () => {
    sheet.close();
    const command: Command = { command: "create", scenario: first, ...(beside ? { beside } : {}), running: true, changed: false, run: app.selected, aside: true };
    if (await app.open(command)) app.note("info", `Started ${title}, from a link.`);
  };
  const sheet: HTMLDialogElement = dialog(
    beside ? "Two scenarios from a link" : "A scenario from a link",
    "small",
    ...scenarios.map((scenario) => told(app, scenario, !beside)),
    h("p", { className: "hint" }, `${beside ? "They run side by side. They take" : "It takes"} the place of the run that is shown now, which is set aside with its moments.`),
    h(
      "div",
      { className: "buttons" },
      h("button", { type: "button", className: "primary", onclick: () => void start() }, beside ? "start both" : "start it"),
      h("button", { type: "button", onclick: () => sheet.close() }, beside ? "leave them" : "leave it"),
    ),
  );
}

/** Offer what links bring: the one that the page was opened with, those put into its address, those of other windows. */
export class ArrivingLinks {
  private readonly channel = new BroadcastChannel(CHANNEL);
  /** The link that waits for the run to be shown. */
  private waiting = "";
  private ready = false;

  constructor(
    private readonly app: App,
    private readonly files: Files,
  ) {
    this.channel.onmessage = (event: MessageEvent<{ link?: string; taken?: boolean }>) => this.onOther(event.data);
    addEventListener("hashchange", () => this.take());
    this.take();
  }

  /** From now on links can be offered. */
  open(): void {
    this.ready = true;
    if (this.waiting) this.present(this.waiting);
    this.waiting = "";
  }

  /** Take the link out of the page's address; without a token it stays there, for when the page has one. */
  private take(): void {
    if (!holdsScenario(location.hash)) return;
    const link = location.hash;
    if (!this.app.connection.allowed) return this.channel.postMessage({ link });
    history.replaceState(history.state, "", location.pathname + location.search);
    this.arrive(link);
  }

  private arrive(link: string): void {
    if (this.ready) this.present(link);
    else this.waiting = link;
  }

  private onOther({ link, taken }: { link?: string; taken?: boolean }): void {
    if (taken) {
      this.app.handedOn = !this.app.connection.allowed;
      this.app.changed.send();
    } else if (typeof link === "string" && this.ready && !this.app.watching) {
      this.channel.postMessage({ taken: true });
      this.present(link);
    }
  }

  private present(link: string): void {
    if (this.app.watching) return this.app.note("warning", "The link holds a scenario, which only the window that commands can start.");
    void offer(this.app, this.files, link).catch((error) => this.app.refused(error));
  }
}
