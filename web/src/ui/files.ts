/** Scenarios, runs and pictures in and out; files dropped onto the page. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import { type Wanted, ends, refuseContent, refuseName } from "../core/file_kinds";
import { nameOf, nameOfRun } from "../core/file_name";
import { isImage } from "../core/image_ground";
import { withKeptFile } from "../core/kept_file";
import { problemText } from "../core/notices";
import type { JsonObject, Problem } from "../core/protocol";
import type { Stage } from "../scene/stage";
import { type Submit, dialog, formDialog, working } from "./dialog";
import { counted, download, h } from "./dom";
import { exportRun, reportSheet } from "./exports";
import { filmSheet } from "./film";
import { type ImageChoice, beginOn, groundSheet } from "./ground_file";
import { menu } from "./menu";
import { overlaySheet } from "./overlay";
import { pictureSheet } from "./picture";
import { SHIPPED, SHIPPED_NAME, blow, needsClock, offerToBlow } from "./record";
import type { Recorder } from "./recorder";
import { askForLink, copyScenarioLink } from "./scenario_links";
import { letOthersWatch } from "./watching";

export class Files {
  readonly menu: HTMLElement;

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
    private readonly recorder: Recorder,
  ) {
    this.menu = menu("File", "Files", [
      ["Load a scenario …", () => this.choose()],
      ["Save the scenario", () => this.saveScenario()],
      ["Copy a link of this scenario …", () => void copyScenarioLink(this.app).catch((error) => this.app.refused(error))],
      ["Open a link of a scenario …", () => askForLink(this.app, this)],
      null,
      ["Open a saved run …", () => void this.open()],
      ["Save the run …", () => this.saveRun()],
      ["Export for other programs …", () => void exportRun(this.app).catch((error) => this.app.refused(error))],
      ["Comparison report of both runs …", () => reportSheet(this.app)],
      ["Compare with a terrain or photograph …", () => overlaySheet(this.app)],
      null,
      ["Save a picture (P)", () => void this.savePicture()],
      ["Picture with title and scale …", () => pictureSheet(this.app, this.stage)],
      ["Record the scene … (V)", () => this.recorder.toggle()],
      ["Film of what was just seen …", () => void filmSheet(this.app, this.stage).catch((error) => this.app.refused(error))],
      null,
      ["Let others watch …", () => void letOthersWatch(this.app).catch((error) => this.app.refused(error))],
    ]);
  }

  /** Take what is dropped onto the page. */
  accept(host: HTMLElement): void {
    host.addEventListener("dragover", (event) => {
      event.preventDefault();
      host.classList.add("dropping");
    });
    host.addEventListener("dragleave", () => host.classList.remove("dropping"));
    host.addEventListener("drop", (event) => {
      event.preventDefault();
      host.classList.remove("dropping");
      const file = event.dataTransfer?.files[0];
      if (file) void this.take(file);
    });
  }

  async take(file: File): Promise<void> {
    const { heights, records } = this.app.files;
    if (ends(file.name, [".json"])) await this.load(file.name, await file.text());
    else if (isImage(file.name)) this.askForGround(file);
    else if (ends(file.name, [...heights, ...records])) await this.dropped(file);
    else {
      const kinds = [["scenarios", ".json"], ["grounds", heights.join(", ")], ["records of wind", records.join(", ")]];
      this.app.note("error", `${file.name} is of an unknown kind. Allowed: ${kinds.map((kind) => kind.join(" ")).join("; ")}.`);
    }
  }

  /** Use a file that was dropped; where reading it takes long, a sheet shows how far it is. */
  private async dropped(file: File): Promise<void> {
    await working(`Reading ${file.name}`, (progress, signal) => this.keep(file, null, progress, signal, offerToBlow)).catch((error) => this.app.refused(error));
  }

  async savePicture(): Promise<void> {
    const step = this.app.current?.status?.step ?? 0;
    download(`${nameOfRun(this.app.current)}-${step}.png`, await this.stage.picture());
  }

  saveScenario(): void {
    const scenario = this.app.current?.description?.scenario;
    if (!scenario) return;
    download(`${nameOf(String(scenario.title ?? ""), "scenario")}.json`, `${JSON.stringify(scenario, null, 2)}\n`);
  }

  /** Load a scenario; of a broken one every bad key is listed, and is only used in part when asked. */
  async load(name: string, text: string): Promise<void> {
    const answer = await this.app.ask({ command: "check", name, text });
    if (!answer) return;
    const problems = answer.problems as unknown as Problem[];
    const scenario = answer.scenario as JsonObject | null;
    for (const problem of problems) this.app.notices.note("error", problemText(problem), problem.key, false);
    if (scenario && !problems.length) {
      if (await this.app.create(scenario)) this.app.note("info", `Loaded ${name}.`);
    } else this.offer(name, problems, scenario, answer.changes as string[] | undefined);
  }

  /** List what is wrong with a scenario, and load the rest of it where that is asked for. */
  offer(name: string, problems: Problem[], scenario: JsonObject | null, changes: string[] = []): void {
    const rest = async () => {
      sheet.close();
      if (await this.app.create(scenario!)) this.app.note("warning", [`Loaded ${name} without what was wrong`, ...changes].join("; ") + ".");
    };
    const sheet: HTMLDialogElement = dialog(
      `${name}: ${counted(problems.length, "problem")}`,
      "small",
      h("ul", { className: "problems" }, ...problems.map((problem) => h("li", {}, problemText(problem)))),
      scenario !== null && changes.length > 0 && h("p", {}, "Loaded without what is wrong, the scenario is another one than the file says:"),
      scenario !== null && changes.length > 0 && h("ul", { className: "problems" }, ...changes.map((one) => h("li", {}, one))),
      h(
        "div",
        { className: "buttons" },
        scenario !== null && h("button", { type: "button", onclick: () => void rest() }, "load the rest"),
        h("button", { type: "button", onclick: () => sheet.close() }, "leave it"),
      ),
    );
  }

  /** Ask for a file of heights and use it, or use an image in the way that is asked for. */
  askForGround(image?: File): void {
    groundSheet(this.app, (file, choice, progress, signal) => this.keep(file, "ground", progress, signal, blow, choice), image);
  }

  /** Ask for a record of winds, and let it blow. */
  async askForWind(): Promise<void> {
    const { records } = this.app.files;
    const title = "Wind from a record";
    const input = h("input", { type: "file", accept: records.join(), required: true, "aria-label": title });
    const use: Submit = async (progress, signal) => {
      const file = input.files?.[0];
      if (file) await this.keep(file, "record", progress, signal, blow);
    };
    const text = `One of ${records.join(", ")}. Files can be dropped onto the scene as well.`;
    const sheet: HTMLDialogElement = formDialog(title, "use it", use, h("p", {}, text), input, ...(await this.ofRecords(() => sheet.close())));
  }

  /** What the sheet for a record says and offers beside the file. */
  private async ofRecords(close: () => void): Promise<HTMLElement[]> {
    const shipped = () => {
      close();
      void blow(this.app, SHIPPED, SHIPPED_NAME).catch((error) => this.app.refused(error));
    };
    const clock = (await needsClock(this.app)) ? [h("p", { className: "hint" }, "A record blows by a clock, which this scenario does not have: it gets one with its defaults, and the run begins again.")] : [];
    return [...clock, h("p", {}, "Or try it out with ", h("button", { type: "button", className: "quiet inline", onclick: shipped }, SHIPPED_NAME), ".")];
  }

  private choose(): void {
    const input = h("input", {
      type: "file",
      accept: [".json", ...this.app.files.heights, ...this.app.files.records].join(),
      onchange: () => {
        const file = input.files?.[0];
        if (file) void this.take(file);
      },
    });
    input.click();
  }

  /** Use a file as what is wanted, or where that is not said as ground, or record of winds where it holds no heights; a refusal is thrown. */
  private async keep(file: File, wanted: Wanted | null, progress: Progress, signal: AbortSignal, use: typeof blow, image: ImageChoice | null = null): Promise<void> {
    if (wanted) refuseName(this.app, file.name, wanted);
    await withKeptFile(this.app, file, progress, signal, async (kept) => {
      if (wanted) refuseContent(file.name, kept, wanted);
      if (wanted !== "ground" && ends(file.name, this.app.files.records) && !kept.heights) await use(this.app, { kind: "record", path: kept.path }, file.name);
      else await beginOn(this.app, file, kept, image);
    });
  }

  private saveRun(): void {
    const name = h("input", { type: "text", value: `run-${new Date().toISOString().slice(0, 16).replaceAll(/[T:]/g, "-")}`, "aria-label": "Name of the run" });
    const pair = this.app.runs.length > 1;
    const save: Submit = async (progress, signal) => {
      const answer = await this.app.connection.ask({ command: "save", name: name.value }, progress, signal);
      this.app.notices.confirm(`Saved ${counted(Number(answer.frames), "frame")} up to step ${answer.step} in the folder “${name.value}”.`);
    };
    formDialog(
      "Save the run",
      "save",
      save,
      h("p", {}, "A folder with the scenario, the states that are kept, and all it takes to go on; the command line reads it too."),
      pair && h("p", { className: "hint" }, "Both runs are saved at the same step, in two folders named by their models, and open side by side again."),
      h("div", { className: "row" }, h("label", {}, "name ", name)),
    );
    name.select();
  }

  private async open(): Promise<void> {
    const answer = await this.app.ask({ command: "saved" });
    if (!answer) return;
    const names = answer.saved as string[];
    const begin = async (name: string) => {
      sheet.close();
      if (await this.app.open({ command: "open", name })) this.app.note("info", `Opened ${name}; it goes on from its newest state.`);
    };
    const list = names.map((name) => h("li", {}, h("button", { type: "button", onclick: () => void begin(name) }, name)));
    const sheet: HTMLDialogElement = dialog(
      "Open a saved run",
      "small",
      h("p", {}, `In ${answer.folder}:`),
      names.length ? h("ul", { className: "runs" }, ...list) : h("p", {}, "There is none yet."),
    );
  }
}
