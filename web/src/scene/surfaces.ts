/** The surfaces of the runs in the scene, side by side, and what they have in common. */

import * as THREE from "three";
import type { App } from "../core/app";
import type { Run } from "../core/run";
import { shine, sunOf } from "./light";
import { type Place, pick } from "./pick";
import { type Manner, Shown } from "./shown";
import type { Terrain } from "./terrain";

/** The box that is looked at before there is a surface. */
const EMPTY = new THREE.Box3(new THREE.Vector3(-5, 0, -5), new THREE.Vector3(5, 1, 5));
/** How much higher than the forms the box is, and below which share of its height it is taken lower. */
const ROOM = 1.3;
const LOW = 0.4;

export class Surfaces {
  /** Whether exaggeration and room stay as they are: pictures that are drawn one after the other shall agree. */
  held = false;
  /** How many times steeper the surfaces were drawn last, unless that is chosen. */
  private steep = 1;
  private shown: Shown[] = [];
  private room = EMPTY.clone();
  /** The wind (degrees) by which the sun stood over a run, by its scenario: one that is gone back to is lit as before. */
  private readonly winds = new Map<string, number>();

  constructor(
    private readonly app: App,
    private readonly renderer: THREE.WebGLRenderer,
    private readonly host: HTMLElement,
  ) {}

  /** How many views stand side by side, one before there is any run. */
  get count(): number {
    return Math.max(this.shown.length, 1);
  }

  get runs(): Run[] {
    return this.shown.map(({ run }) => run);
  }

  get first(): Terrain | undefined {
    return this.shown[0]?.terrain;
  }

  terrain(run: Run): Terrain | undefined {
    return this.shown.find((one) => one.run === run)?.terrain;
  }

  /** Hold a surface for each run of the page, and none besides; returns whether that changed. */
  match(): boolean {
    const { runs } = this.app;
    const before = this.shown;
    if (before.length === runs.length && before.every((one, at) => one.run === runs[at])) return false;
    const linear = this.renderer.extensions.has("OES_texture_float_linear");
    this.shown = runs.map((run) => before.find((one) => one.run === run) ?? new Shown(this.app, run, linear, this.host, this.winds));
    for (const one of before) if (!this.shown.includes(one)) one.terrain.dispose();
    return true;
  }

  /** Bring the surfaces up to date: all, or those of the runs named. Those that stand side by side are drawn equally steep. */
  update(full: boolean, dark: boolean, only?: Set<Run>): void {
    const due = this.shown.filter(({ run }) => run.ready && (!only || only.has(run)));
    for (const { run, terrain, light } of due) {
      terrain.begin(run);
      shine(light, sunOf(this.app.view.look, terrain.firstWind!), dark);
      terrain.settle(run, !full);
    }
    const ready = this.shown.filter(({ run, terrain }) => run.ready && terrain.drawn.length);
    if (!this.held) this.steep = Math.min(...ready.map(({ terrain }) => terrain.usual));
    for (const one of ready) {
      if (due.includes(one) || one.terrain.differsFrom(this.steep)) one.terrain.update(one.run, this.renderer, !full, this.steep);
    }
  }

  /** The box that the surfaces fill, with room to grow in, so that the view does not move with each step. */
  box(): THREE.Box3 {
    const terrain = this.shown.find(({ run, terrain }) => run.ready && terrain.drawn.length)?.terrain;
    if (!terrain || this.held) return this.room;
    const box = terrain.box();
    const { max } = this.room;
    const same = max.x === box.max.x && max.z === box.max.z;
    if (!same || box.max.y > max.y || box.max.y < LOW * max.y) {
      this.room = box;
      this.room.max.y *= ROOM;
    }
    return this.room;
  }

  /** Other runs have taken the place of those that are shown. */
  forget(): void {
    this.room = EMPTY.clone();
    for (const { terrain } of this.shown) terrain.forget();
  }

  /** Draw all into a canvas of a width and height (pixels of the page). */
  paint(width: number, height: number, manner: Manner): void {
    const { renderer, count } = this;
    renderer.setScissorTest(count > 1);
    renderer.setClearColor(0x000000, 0);
    renderer.setScissor(0, 0, width, height);
    renderer.clear();
    this.shown.forEach((one, number) => one.draw(renderer, [(width / count) * number, 0, width / count, height], manner));
  }

  /** Draw one, by its number from the left. */
  paintOne(number: number, viewport: [number, number, number, number], manner: Manner): void {
    this.shown[number]?.draw(this.renderer, viewport, manner);
  }

  /** The run and the place at a point of the canvas, as shares of it from the upper left corner. */
  pick(across: number, down: number, camera: THREE.Camera): { run: Run; place: Place } | null {
    const part = across * this.count;
    const number = Math.min(Math.max(Math.floor(part), 0), this.shown.length - 1);
    const shown = this.shown[number];
    if (!shown?.run.ready) return null;
    const point = new THREE.Vector2(2 * (part - number) - 1, 1 - 2 * down);
    const place = pick(shown.terrain, shown.run.rows, shown.run.columns, point, camera);
    return place && { run: shown.run, place };
  }

  /** Show the brush on all: its centre as shares of the field, its radius in metres. */
  showBrush(x: number, y: number, radius: number): void {
    for (const { terrain } of this.shown) terrain.uniforms.brush!.value.set(x, y, radius);
  }

  dispose(): void {
    for (const { terrain } of this.shown) terrain.dispose();
    this.shown = [];
  }
}
