/** Records the scene while it runs, as it is seen: the browser makes the film, of which a bar in the scene tells how long it is. */

import type { App } from "../core/app";
import { nameOfRun } from "../core/file_name";
import { isDusk } from "../scene/light";
import type { Shot } from "../scene/shots";
import type { Stage } from "../scene/stage";
import { type Submit, formDialog } from "./dialog";
import { download, h } from "./dom";
import { type Words, drawWords } from "./picture_words";
import { wordsRows } from "./words_rows";

/** Pictures a second at most, and bits a second. */
const RATE = 30;
const BITS = 16_000_000;
/** Formats by their suffix, the first that a browser can write is taken: those that cost the processor least first. */
const KINDS: [string, string][] = [
  ["webm", "video/webm;codecs=vp8"],
  ["webm", "video/webm"],
  ["mp4", "video/mp4"],
];

/** Suffix and type of the films that this browser records; null where it records none. */
export function recordable(): [string, string] | null {
  if (!("MediaRecorder" in window) || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  return KINDS.find(([, type]) => MediaRecorder.isTypeSupported(type)) ?? null;
}

export class Recorder {
  readonly element = h("div", { className: "recording", role: "group", "aria-label": "Recording", hidden: true });
  private readonly time = h("span", {});
  private readonly canvas = document.createElement("canvas");
  private recorder: MediaRecorder | null = null;
  private words: Words = { title: false, heading: "", scale: false, legend: false };
  private began = 0;
  private drawnAt = 0;

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    const end = (label: string, act: () => void) => h("button", { type: "button", onclick: act }, label);
    this.element.append(h("span", { className: "dot", "aria-hidden": "true" }), this.time, end("stop and save", () => this.end(true)), end("discard", () => this.end(false)));
    stage.painted.watch(() => this.draw());
  }

  /** Ask what is to be written over the film and begin, or end one that is being recorded. */
  toggle(): void {
    if (this.recorder) return this.end(true);
    const kind = recordable();
    if (!kind) {
      this.app.note("error", "This browser cannot record what it draws. ‘Film of what was just seen’ makes a film of the kept states without that; current Firefox, Chrome, Edge and Safari can record.");
      return;
    }
    const words = wordsRows(this.app, this.stage, () => {});
    const begin: Submit = async () => {
      this.element.hidden = false;
      await settled(); // messages move off the bar, which may change the size of the scene
      try {
        this.begin(kind, words.chosen());
      } catch (error) {
        this.element.hidden = true;
        throw error;
      }
    };
    formDialog("Record the scene", "begin", begin, h("p", {}, `From now on the scene is recorded as you see it, turns of the camera included, in its present size, as .${kind[0]}. V, Esc or ‘stop and save’ ends it and saves the film.`), words.element);
  }

  /** End a recording and save it, where there is one. */
  finish(): void {
    if (this.recorder) this.end(true);
  }

  private begin([suffix, type]: [string, string], words: Words): void {
    const { width, height } = this.stage.canvas;
    [this.canvas.width, this.canvas.height] = [width - (width % 2), height - (height % 2)];
    this.words = words;
    this.canvas.getContext("2d"); // without a context nothing of a canvas is recorded
    const parts: Blob[] = [];
    const recorder = (this.recorder = new MediaRecorder(this.canvas.captureStream(RATE), { mimeType: type, videoBitsPerSecond: BITS }));
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onerror = () => this.fail();
    recorder.onstop = () => {
      for (const track of recorder.stream.getTracks()) track.stop();
      if (this.saving) this.save(`${nameOfRun(this.app.current)}.${suffix}`, new Blob(parts, { type: type.split(";")[0]! }), length(performance.now() - this.began));
    };
    this.began = performance.now();
    recorder.start(1000);
    this.stage.redraw();
  }

  private saving = false;

  private end(save: boolean): void {
    this.saving = save;
    this.recorder?.stop();
    this.recorder = null;
    this.element.hidden = true;
  }

  private save(name: string, film: Blob, long: string): void {
    if (!film.size) return this.fail();
    download(name, film);
    this.app.notices.confirm(`The film of the scene is saved as ${name}, ${long} long.`);
  }

  private fail(): void {
    this.end(false);
    this.app.note("error", "The browser gave up recording the scene: it has no encoder for a picture of this size, or no time or room for it. A smaller window may help.");
  }

  /** Copy the scene as it was painted just now, and write over it what is wanted. */
  private draw(): void {
    const now = performance.now();
    if (!this.recorder || now - this.drawnAt < 900 / RATE) return;
    this.drawnAt = now;
    const { canvas, stage, app } = this;
    const context = canvas.getContext("2d")!;
    const dark = isDusk(app.view.look, stage.host);
    context.fillStyle = getComputedStyle(stage.host).backgroundColor;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(stage.canvas, 0, 0, canvas.width, canvas.height);
    const shot: Shot = {
      canvas,
      metresPerPixel: (stage.metresPerPixel() * stage.canvas.clientHeight) / canvas.height,
      heading: stage.heading(),
      statuses: new Map(app.runs.filter((run) => run.status).map((run) => [run, run.status!])),
    };
    drawWords(app, stage, shot, this.words, dark);
    this.time.textContent = `recording ${length(now - this.began)}`;
  }
}

/** The page is laid out, and the scene has its size. */
function settled(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())));
}

/** A length of time (ms) as minutes and seconds. */
function length(milliseconds: number): string {
  const seconds = Math.floor(milliseconds / 1000);
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
}
