/** A film of kept states as the scene shows them, from where one looks: drawn one by one, encoded by the server. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import { shownSteps } from "../core/run";
import { isDusk } from "../scene/light";
import { type Shot, jpegOf } from "../scene/shots";
import type { Stage } from "../scene/stage";
import { download } from "./dom";
import { type Words, drawWords } from "./picture_words";

export interface SceneFilm {
  /** The name of the file; its suffix tells the format. */
  name: string;
  /** Kept states, the last ones up to the one that is shown. */
  states: number;
  width: number;
  height: number;
  /** Pictures a second. */
  rate: number;
  /** Degrees that the camera turns from the first picture to the last. */
  turn: number;
  words: Words;
}

/** Seconds until a state that was asked for must be shown. */
const PATIENCE = 60;

/** Make a film and give it to the user; the run rests meanwhile, and is then as it was. Returns the name of the file. */
export async function filmOfStates(app: App, stage: Stage, film: SceneFilm, progress: Progress, signal: AbortSignal): Promise<string> {
  const place = stage.standpoint();
  const look = { ...app.view.look };
  const ran = app.running;
  if (ran) await rest(app);
  const shown = app.current!.status!;
  const back = shown.looking ? shown.step : null;
  const steps = shownSteps(app.runs).slice(-film.states);
  const fits = stage.fits;
  const turn = (film.turn * Math.PI) / 180;
  stage.keepWhole(turn, film.width, film.height);
  stage.stand(stage.standpoint()); // which a field that grows does not move
  stage.steady = true;
  // from the first picture to the last one, heights and colours mean the same
  app.view.follow({ ...look, exaggeration: look.exaggeration ?? stage.terrain(app.current!)?.exaggeration ?? null, limits: look.limits ?? limitsOf(stage, app) });
  try {
    return await encoded(app, film, signal, async (send) => {
      for (const [at, step] of steps.entries()) {
        progress(at, steps.length, { counted: "picture" });
        await showStep(app, step, back, signal);
        await send(await pictureOf(app, stage, film, signal));
        if (turn) stage.turn(turn / Math.max(steps.length - 1, 1), 0);
      }
      progress(steps.length, steps.length);
    });
  } finally {
    stage.steady = false;
    app.view.follow(look);
    if (fits) stage.look(place.viewpoint);
    else stage.stand(place);
    app.send({ command: "look", step: back });
    if (ran) app.send({ command: "run" });
  }
}

/** Open a film at the server, let `draw` send its pictures, and give the file to the user; of one that fails nothing is left. */
async function encoded(app: App, { name, rate }: SceneFilm, signal: AbortSignal, draw: (send: (picture: Blob) => Promise<void>) => Promise<void>): Promise<string> {
  const { film } = await app.connection.fetch<{ film: string }>(`films?name=${encodeURIComponent(name)}&rate=${rate}`, { method: "POST", signal });
  try {
    await draw(async (picture) => void (await app.connection.fetch(`films/${film}`, { method: "POST", body: picture, signal })));
    const { file } = await app.connection.fetch<{ file: string }>(`films/${film}/end`, { method: "POST" });
    download(name, await app.connection.file(`exports/${file}`));
    return name;
  } catch (error) {
    await app.connection.fetch(`films/${film}`, { method: "DELETE" }).catch(() => {}); // what has failed is said already
    throw error;
  }
}

async function pictureOf(app: App, stage: Stage, { width, height, words }: SceneFilm, signal: AbortSignal): Promise<Blob> {
  const shot: Shot = await stage.shoot({ width, height, progress: () => signal.throwIfAborted() });
  drawWords(app, stage, shot, words, isDusk(app.view.look, stage.host));
  return jpegOf(shot.canvas);
}

function limitsOf(stage: Stage, app: App): [number, number] | null {
  const colouring = stage.terrain(app.current!)?.colouring;
  return colouring && !colouring.natural ? [...colouring.limits] : null;
}

/** Pause the run, and wait until it rests. */
async function rest(app: App): Promise<void> {
  app.send({ command: "pause" });
  await until(app, () => !app.running);
}

/** Let all runs show the state after a step, which is the newest one unless one looks `back`. */
async function showStep(app: App, step: number, back: number | null, signal: AbortSignal): Promise<void> {
  const newest = back === null && app.current!.status!.live === step;
  app.send({ command: "look", step: newest ? null : step });
  await until(app, () => app.runs.every(({ status }) => status!.step === step && status!.looking !== newest), signal);
}

/** Wait until a frame has brought what is wanted; throws where none does, or that was broken off. */
function until(app: App, wanted: () => boolean, signal?: AbortSignal): Promise<void> {
  return new Promise((done, failed) => {
    const late = setTimeout(() => end(() => failed(new Error("The run does not show the state that was asked for."))), 1000 * PATIENCE);
    const see = () => wanted() && end(done);
    const stop = () => end(() => failed(signal?.reason));
    const end = (act: () => void) => {
      clearTimeout(late);
      app.framed.leave(see);
      app.changed.leave(see);
      signal?.removeEventListener("abort", stop);
      act();
    };
    if (signal?.aborted) return stop();
    signal?.addEventListener("abort", stop);
    app.framed.watch(see);
    app.changed.watch(see);
    see();
  });
}
