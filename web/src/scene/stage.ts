/** The scene: one surface, or two side by side under one camera. */

import * as THREE from "three";
import type { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { App } from "../core/app";
import type { Run } from "../core/run";
import { Signal } from "../core/signal";
import { Camera, type Standpoint, type Viewpoint } from "./camera";
import { shine, sunOf } from "./light";
import { type Place, pick } from "./pick";
import { Quality } from "./quality";
import type { Ends } from "./line_mark";
import { type Shot, type ShotOptions, Tiles, blobOf } from "./shots";
import { type Lines, type Manner, Shown } from "./shown";
import type { Terrain } from "./terrain";

export class Stage {
  readonly view: Camera;
  readonly canvas: HTMLCanvasElement;
  /** After every picture that was drawn, while it can still be copied. */
  readonly painted = new Signal<void>();
  /** Whether the camera does not turn by itself: a film is being made. */
  steady = false;
  /** Frames drawn, for those who measure. */
  drawn = 0;
  readonly quality: Quality;
  private readonly renderer: THREE.WebGLRenderer;
  private shown: Shown[] = [];
  private readonly stale = new Set<Run>();
  private dirty = true;
  private wasDirty = false;
  private readonly lines: Lines = { section: null, ruler: null };
  /** The picture that is being drawn beside the page, which waits meanwhile. */
  private shooting: ShotOptions | null = null;
  /** Settled when the picture that was begun last is there: they are drawn one after the other. */
  private lastShot: Promise<unknown> = Promise.resolve();
  private readonly resized = new ResizeObserver(() => this.resize());
  /** Aborted when the scene is given up. */
  private readonly given = new AbortController();
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");

  constructor(
    private readonly app: App,
    readonly host: HTMLElement,
  ) {
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.quality = new Quality(this.renderer.getContext());
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The surface in three dimensions. Arrow keys turn it, + and − zoom.");
    host.prepend(this.canvas);
    this.view = new Camera(this.canvas);
    this.view.onMoved = () => this.redraw();
    this.view.mayTurn = () => app.view.look.turning && !this.steady && !this.still.matches && !this.plain && this.shown.some(({ run }) => run.ready);
    this.resized.observe(host);
    app.framed.watch((run) => this.refresh(run));
    app.changed.watch(() => this.all());
    app.view.changed.watch(() => this.all());
    app.overlay.changed.watch(() => this.all());
    this.canvas.addEventListener("webglcontextlost", () => this.lose(true), { signal: this.given.signal });
    this.canvas.addEventListener("webglcontextrestored", () => this.lose(false), { signal: this.given.signal });
    this.look("oblique");
    this.renderer.setAnimationLoop(() => this.tick());
  }

  get camera(): THREE.Camera {
    return this.view.active;
  }

  get controls(): OrbitControls {
    return this.view.controls;
  }

  /** Whether the scene is drawn plainly, as for software rendering. */
  get plain(): boolean {
    return this.quality.plain(this.app.view.look);
  }

  /** Let the camera look from one of the usual places. */
  look(from: Viewpoint): void {
    this.view.look(from);
    this.redraw();
  }

  /** Whether the camera follows the size of the field, as nobody has moved it. */
  get fits(): boolean {
    return this.view.fits;
  }

  standpoint(): Standpoint {
    return this.view.standpoint();
  }

  /** Look from where one has looked before. */
  stand(place: Standpoint): void {
    this.view.stand(place);
  }

  /** Turn and tilt the camera by angles (radians), and come nearer by a factor. */
  turn(around: number, up: number, nearer = 1): void {
    this.view.turn(around, up, nearer);
  }

  redraw(): void {
    this.dirty = true;
  }

  /** The surface of a run. */
  terrain(run: Run): Terrain | undefined {
    return this.shown.find((one) => one.run === run)?.terrain;
  }

  /** Show the line of a section (shares of the field), or none. */
  showSection(line: Ends | null): void {
    this.lines.section = line;
    this.redraw();
  }

  /** Show the line of the ruler (shares of the field), or none. */
  showRuler(line: Ends | null): void {
    this.lines.ruler = line;
    this.redraw();
  }

  /** Show the brush: its centre as shares of the field, its radius in metres. */
  showBrush(x: number, y: number, radius: number): void {
    for (const { terrain } of this.shown) terrain.uniforms.brush!.value.set(x, y, radius);
    this.redraw();
  }

  /** The run and the place under the mouse. */
  pick(event: { clientX: number; clientY: number }): { run: Run; place: Place } | null {
    const box = this.canvas.getBoundingClientRect();
    const part = (event.clientX - box.left) / (box.width / Math.max(this.shown.length, 1));
    const number = Math.min(Math.max(Math.floor(part), 0), this.shown.length - 1);
    const shown = this.shown[number];
    if (!shown || !shown.run.ready) return null;
    const y = 1 - (2 * (event.clientY - box.top)) / box.height;
    const point = new THREE.Vector2(2 * (part - number) - 1, y);
    const place = pick(shown.terrain, shown.run.rows, shown.run.columns, point, this.camera);
    return place && { run: shown.run, place };
  }

  /** The picture as it is now, in the size of the page. */
  picture(): Promise<Blob> {
    const { width, height } = this.canvas;
    return this.render({ width, height });
  }

  /** A picture of any size (PNG). */
  async render(options: ShotOptions): Promise<Blob> {
    return blobOf((await this.shoot(options)).canvas);
  }

  /** A picture of any size, drawn fully whatever the page shows, in tiles where the graphics card asks for them. */
  shoot(options: ShotOptions): Promise<Shot> {
    const shot = this.lastShot.then(() => this.draw(options));
    this.lastShot = shot.catch(() => undefined);
    return shot;
  }

  private async draw(options: ShotOptions): Promise<Shot> {
    const { width, height, transparent = false } = options;
    this.shooting = options;
    const ratio = this.renderer.getPixelRatio();
    const count = Math.max(this.shown.length, 1);
    const tiles = new Tiles(this.renderer, this.view.active, width, height, count);
    try {
      this.update(true, undefined, width / count / height);
      const perPixel = this.view.unitsPerPixel(height) / (this.shown[0]?.terrain.scale ?? Number.NaN);
      const wide = Math.max(height / Math.max(this.host.clientHeight, 1), 1);
      const statuses = new Map(this.shown.map(({ run }) => [run, run.status!]));
      await tiles.draw((number, viewport) => this.shown[number]?.draw(this.renderer, viewport, this.manner(transparent, wide)), options.progress);
      if (this.app.graphicsLost) throw new Error("The graphics card was taken away while the picture was drawn.");
      return { canvas: tiles.canvas, metresPerPixel: perPixel, heading: this.heading(), statuses };
    } finally {
      this.shooting = null;
      this.view.active.clearViewOffset();
      this.renderer.setPixelRatio(ratio);
      this.resize();
      this.all();
    }
  }

  /** Metres of the field that a pixel of the page covers where the camera looks. */
  metresPerPixel(): number {
    const terrain = this.shown[0]?.terrain;
    return terrain ? this.view.unitsPerPixel(this.canvas.clientHeight) / terrain.scale : Number.NaN;
  }

  /** Where the sun stands (degrees): as chosen, or across the crests. */
  sun(): { azimuth: number; height: number } {
    return sunOf(this.app.view.look, this.shown[0]?.terrain.firstWind ?? 270);
  }

  /** Direction the camera looks at, clockwise from north (radians). */
  heading(): number {
    return this.view.heading();
  }

  /** The graphics card was taken away, or is back: everything is drawn again then. */
  private lose(lost: boolean): void {
    this.app.graphicsLost = lost;
    this.app.note(lost ? "warning" : "info", lost ? "The browser has taken the graphics card away from the page; the run goes on." : "The graphics card is back.");
    this.app.changed.send();
  }

  /** Draw no more, and give back what the graphics card holds: browsers allow few such scenes at a time. */
  dispose(): void {
    this.given.abort();
    this.renderer.setAnimationLoop(null);
    this.resized.disconnect();
    this.view.controls.dispose();
    for (const { terrain } of this.shown) terrain.dispose();
    this.shown = [];
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }

  private all(): void {
    this.match();
    for (const { run } of this.shown) this.stale.add(run);
    this.redraw();
  }

  private refresh(run: Run): void {
    this.match();
    this.stale.add(run);
    if (this.app.view.look.side === "difference") for (const shown of this.shown) this.stale.add(shown.run);
    this.redraw();
  }

  private match(): void {
    if (this.shooting || sameRuns(this.shown, this.app.runs)) return;
    const linear = this.renderer.extensions.has("OES_texture_float_linear");
    const before = this.shown;
    this.shown = this.app.runs.map((run) => before.find((one) => one.run === run) ?? new Shown(this.app, run, linear, this.host));
    for (const one of before) if (!this.shown.includes(one)) one.terrain.dispose();
    this.resize();
  }

  private tick(): void {
    if (this.shooting) return;
    this.view.update();
    if (this.app.graphicsLost) return this.app.confirm(); // the run goes on unseen
    const moving = this.dirty && this.wasDirty;
    this.wasDirty = this.dirty;
    if (!this.dirty) return;
    this.dirty = false;
    if (this.quality.drawn(performance.now(), moving)) this.resize();
    this.update(this.plain === false, this.stale);
    this.stale.clear();
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.paint(width, height);
    this.app.confirm();
    this.drawn++;
    this.painted.send();
  }

  /** Bring the surfaces of runs up to date: of all, or of those named. */
  private update(full: boolean, only?: Set<Run>, aspect = this.aspect()): void {
    for (const { run, terrain, light } of this.shown) {
      if (!run.ready || (only && !only.has(run))) continue;
      terrain.begin(run);
      shine(light, sunOf(this.app.view.look, terrain.firstWind!), this.dark);
      terrain.update(run, this.renderer, !full);
    }
    const ready = this.shown.find(({ run, terrain }) => run.ready && terrain.drawn.length);
    if (ready) this.view.frame(this.roomy(ready.terrain.box()), aspect);
  }

  private room = new THREE.Box3();

  /** A box with room to grow in, so that the view does not move with each step. */
  private roomy(box: THREE.Box3): THREE.Box3 {
    const { max } = this.room;
    const same = max.x === box.max.x && max.z === box.max.z;
    if (!same || box.max.y > max.y || box.max.y < 0.4 * max.y) {
      this.room = box.clone();
      this.room.max.y *= 1.3;
    }
    return this.room;
  }

  private paint(width: number, height: number): void {
    const count = Math.max(this.shown.length, 1);
    this.renderer.setScissorTest(count > 1);
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.setScissor(0, 0, width, height);
    this.renderer.clear();
    this.shown.forEach((one, number) => one.draw(this.renderer, [(width / count) * number, 0, width / count, height], this.manner()));
  }

  private manner(transparent = false, wide = 1): Manner {
    const fine = this.shooting !== null || !this.plain;
    const haze = !this.view.isParallel && !transparent;
    return { camera: this.camera, level: this.view.level(), haze, around: !transparent, fine, dark: this.dark, lines: this.lines, wide };
  }

  /** Whether the scene is at dusk, as the picture that is being drawn asks, or the page's theme. */
  private get dark(): boolean {
    return this.shooting?.dark ?? getComputedStyle(this.host).colorScheme === "dark";
  }

  private aspect(): number {
    const { clientWidth: width, clientHeight: height } = this.host;
    return width / Math.max(this.shown.length, 1) / Math.max(height, 1);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height || this.shooting) return;
    this.renderer.setPixelRatio(this.plain ? 1 : Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, true);
    const terrain = this.shown.find(({ terrain }) => terrain.drawn.length)?.terrain;
    this.view.frame(terrain ? this.roomy(terrain.box()) : new THREE.Box3(new THREE.Vector3(-5, 0, -5), new THREE.Vector3(5, 1, 5)), this.aspect());
    this.all();
  }
}

function sameRuns(shown: Shown[], runs: Run[]): boolean {
  return shown.length === runs.length && shown.every((one, at) => one.run === runs[at]);
}
