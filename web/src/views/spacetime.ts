/** The section over time: every step a row of the picture, crests that travel are slanted lines; of two runs both, or either. */

import type { App } from "../core/app";
import { nameOfRun } from "../core/file_name";
import { type Run, nameBeside } from "../core/run";
import type { RunName } from "../core/protocol";
import { button, counted, fitCanvas, h, lengthUnit, short } from "../ui/dom";
import { fetchFile } from "../ui/exports";
import { sideOf } from "../ui/sides";
import { Bands } from "./bands";
import type { SectionView } from "./section";
import { type Panel, drawPanels } from "./spacetime_picture";

const BOTH = "both";

export class SpaceTimeView {
  readonly title = "Space–time";
  readonly element: HTMLElement;
  private readonly canvas = h("canvas", { className: "plot", role: "img", "aria-label": "The section over time" });
  private readonly choice = h("select", { "aria-label": "Runs that are shown and saved", onchange: () => this.draw() });
  private readonly readout = h("output", { className: "readout" });
  private readonly bands: Record<RunName, Bands>;
  private visible = false;
  /** The names that the choice offers. */
  private offered = "";

  constructor(
    private readonly app: App,
    private readonly section: SectionView,
  ) {
    const bands = () => new Bands(app, () => this.draw());
    this.bands = { a: bands(), b: bands() };
    this.element = h(
      "div",
      { className: "view" },
      h(
        "div",
        { className: "tools" },
        h("span", {}, "Elevation along the section; time runs upwards."),
        this.choice,
        button("Save a picture with colour bar, of the kept states (PNG)", "save picture", () => void this.save(".png")),
        button("Save the elevations of the kept states as CSV", "save CSV", () => void this.save(".csv")),
        this.readout,
      ),
      this.canvas,
    );
    app.framed.watch(() => this.collect());
    app.changed.watch(() => {
      this.collect();
      this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  show(visible: boolean): void {
    this.visible = visible;
    for (const bands of Object.values(this.bands)) bands.forget();
    this.collect();
    this.draw();
  }

  /** The runs of which there are sections: those with the lattice of the one whose line it is. */
  private get runs(): Run[] {
    const { runs, current } = this.app;
    return current?.ready ? runs.filter((run) => run.ready && run.rows === current.rows && run.columns === current.columns) : [];
  }

  /** The runs that are shown and saved. */
  private chosen(): Run[] {
    const { runs } = this;
    return runs.length < 2 || this.choice.value === BOTH ? runs : runs.filter((run) => run.name === this.choice.value);
  }

  private collect(): void {
    if (!this.visible) return;
    this.offer();
    const { runs } = this;
    const current = this.app.current!;
    for (const run of runs) this.bands[run.name].collect(run, this.section.current(current));
    if (runs.length < 2) this.bands[current?.name === "b" ? "a" : "b"].forget();
  }

  /** Let both runs, or either, be chosen by their names. */
  private offer(): void {
    const { runs } = this;
    const names = runs.map((run) => this.name(run));
    this.choice.hidden = runs.length < 2;
    if (names.join("\n") === this.offered) return;
    this.offered = names.join("\n");
    const before = this.choice.value;
    this.choice.replaceChildren(h("option", { value: BOTH }, "both side by side"), ...runs.map((run, at) => h("option", { value: run.name }, names[at]!)));
    this.choice.value = runs.some((run) => run.name === before) ? before : BOTH;
    this.draw();
  }

  /** How a run is named beside another; empty where there is one. */
  private name(run: Run): string {
    const other = this.app.runs.find((one) => one !== run);
    return other ? nameBeside(run, other) : "";
  }

  /** Let the server write the section over all kept states up to the one that is shown: a file for each run, of two on one scale of colours. */
  private async save(suffix: string): Promise<void> {
    const current = this.app.current;
    if (!current?.ready) return;
    const [line, limits, pair] = [this.section.current(current), this.ends(), this.runs.length > 1];
    try {
      for (const run of this.chosen()) {
        const whose = pair ? `-${run.name === "a" ? "left" : "right"}-${plain(this.name(run))}` : "";
        const name = `${nameOfRun(run)}-space-time-${run.status!.step}${whose}${suffix}`;
        await fetchFile(this.app, { command: "space_time_file", name, line, run: run.name, ...(pair ? { beside: { name: this.name(run), limits } } : {}) });
      }
    } catch (error) {
      this.app.refused(error);
    }
  }

  private draw(): void {
    if (!this.visible || !this.canvas.clientWidth) return;
    const runs = this.runs.filter((run) => this.bands[run.name].rows.length);
    const panels: Panel[] = this.chosen().filter((run) => runs.includes(run)).map((run) => ({ name: this.name(run), colour: sideOf(run).colour, bands: this.bands[run.name], stepSeconds: run.description!.step_seconds }));
    if (!panels.length) return;
    const all = runs.flatMap((run) => this.bands[run.name].rows);
    const steps = all.map(({ step }) => step);
    const [x0, y0, x1, y1] = this.section.current(this.app.current!);
    const [low, high] = this.ends();
    const { context, width, height } = fitCanvas(this.canvas);
    drawPanels(
      context,
      panels,
      { colours: this.app.colours.perceptual ?? [[0, 0, 0], [255, 255, 255]], ends: [low, high], steps: [Math.min(...steps), Math.max(...steps)], length: Math.hypot(x1 - x0, y1 - y0) },
      width,
      height,
    );
    const what = this.runs.length > 1 ? "one scale:" : `${counted(panels[0]!.bands.rows.length, "section")},`;
    const [unit, factor] = lengthUnit(Math.max(Math.abs(low), Math.abs(high)));
    this.readout.textContent = `${what} ${short(factor * low)} to ${short(factor * high)} ${unit}`;
  }

  /** Lowest and highest elevation (m) of all runs, whichever are shown. */
  private ends(): [number, number] {
    const found = this.runs.map((run) => this.bands[run.name].ends());
    return [Math.min(...found.map(([low]) => low)), Math.max(...found.map(([, high]) => high))];
  }
}

/** A name as part of a file's name. */
function plain(name: string): string {
  return name.normalize("NFD").replaceAll(/[^A-Za-z0-9.]+/g, "-").replaceAll(/^-|-$/g, "").slice(0, 60);
}
