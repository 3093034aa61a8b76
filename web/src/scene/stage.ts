/** The scene: one surface, or two side by side under one camera. */

import * as THREE from "three";
import type { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { App } from "../core/app";
import type { Run } from "../core/run";
import { Signal } from "../core/signal";
import { Camera, type Standpoint, type Viewpoint } from "./camera";
import { NATURAL } from "./colouring";
import { still } from "./held";
import { isDusk, sunOf } from "./light";
import type { Place } from "./pick";
import { Quality } from "./quality";
import type { Ends } from "./line_mark";
import { type Shot, type ShotOptions, Tiles, blobOf } from "./shots";
import { type Lines, type Manner, NO_LINES } from "./shown";
import { Surfaces } from "./surfaces";
import type { Terrain } from "./terrain";

export class Stage {
  readonly view: Camera;
  readonly canvas: HTMLCanvasElement;
  /** After every picture that was drawn, while it can still be copied. */
  readonly painted = new Signal<void>();
  /** Frames drawn, for those who measure. */
  drawn = 0;
  readonly quality: Quality;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly surfaces: Surfaces;
  private readonly stale = new Set<Run>();
  private dirty = true;
  private wasDirty = false;
  private isSteady = false;
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
    this.surfaces = new Surfaces(app, this.renderer, host);
    this.view = new Camera(this.canvas);
    this.view.onMoved = () => this.redraw();
    this.view.mayTurn = () => app.view.look.turning && !this.steady && !this.still.matches && !this.plain && this.surfaces.runs.some((run) => run.ready);
    this.resized.observe(host);
    app.opened.watch(() => this.begin());
    app.framed.watch((run) => this.refresh(run));
    app.changed.watch(() => this.all());
    app.view.changed.watch(() => this.follow());
    app.overlay.changed.watch(() => this.all());
    this.canvas.addEventListener("webglcontextlost", () => this.lose(true), { signal: this.given.signal });
    this.canvas.addEventListener("webglcontextrestored", () => this.lose(false), { signal: this.given.signal });
    this.view.open(app.view.look.fieldOfView);
    this.look("oblique");
    this.renderer.setAnimationLoop(() => this.tick());
  }

  /** Whether camera and exaggeration stay as they are by themselves: a picture or a film is being made. */
  get steady(): boolean {
    return this.isSteady;
  }

  set steady(steady: boolean) {
    this.isSteady = this.surfaces.held = steady;
    this.view.settle();
    this.redraw();
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

  /** Keep the whole field, where it is in view or nobody has moved the camera, in pictures of a width and a height while that turns by an angle (radians). */
  keepWhole(around: number, width: number, height: number): void {
    this.view.keepWhole(around, width / this.surfaces.count / height);
  }

  redraw(): void {
    this.dirty = true;
  }

  /** The surface of a run. */
  terrain(run: Run): Terrain | undefined {
    return this.surfaces.terrain(run);
  }

  /** Show the line of a section, or of the ruler (shares of the field), or none. */
  showLine(of: keyof Lines, line: Ends | null): void {
    this.lines[of] = line;
    this.redraw();
  }

  /** Show the brush: its centre as shares of the field, its radius in metres. */
  showBrush(x: number, y: number, radius: number): void {
    this.surfaces.showBrush(x, y, radius);
    this.redraw();
  }

  /** The run and the place under the mouse. */
  pick(event: { clientX: number; clientY: number }): { run: Run; place: Place } | null {
    const box = this.canvas.getBoundingClientRect();
    return this.surfaces.pick((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height, this.camera);
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
    this.paint();
    const held = still(this.canvas);
    this.shooting = options;
    const ratio = this.renderer.getPixelRatio();
    const { count } = this.surfaces;
    const tiles = new Tiles(this.renderer, this.view.active, width, height, count);
    try {
      this.update(true, undefined, width / count / height);
      const perPixel = this.view.unitsPerPixel(height) / (this.surfaces.first?.scale ?? Number.NaN);
      const wide = Math.max(height / Math.max(this.host.clientHeight, 1), 1);
      const statuses = new Map(this.surfaces.runs.map((run) => [run, run.status!]));
      await tiles.draw((number, viewport) => this.surfaces.paintOne(number, viewport, this.manner(transparent, wide)), options.progress);
      if (this.app.graphicsLost) throw new Error("The graphics card was taken away while the picture was drawn.");
      return { canvas: tiles.canvas, metresPerPixel: perPixel, heading: this.heading(), statuses };
    } finally {
      this.shooting = null;
      this.view.active.clearViewOffset();
      this.renderer.setPixelRatio(ratio);
      this.resize();
      held.remove();
      this.all();
    }
  }

  /** Metres of the field that a pixel of the page covers where the camera looks. */
  metresPerPixel(): number {
    const terrain = this.surfaces.first;
    return terrain ? this.view.unitsPerPixel(this.canvas.clientHeight) / terrain.scale : Number.NaN;
  }

  /** Where the sun stands (degrees): as chosen, or across the crests. */
  sun(): { azimuth: number; height: number } {
    return sunOf(this.app.view.look, this.surfaces.first?.firstWind ?? 270);
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
    this.surfaces.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }

  /** Show a run that has taken the place of another one as if there had been none: its whole field is in view. */
  private begin(): void {
    this.surfaces.forget();
    this.view.fitAgain();
    this.all();
  }

  private all(): void {
    this.match();
    for (const run of this.surfaces.runs) this.stale.add(run);
    this.redraw();
  }

  private refresh(run: Run): void {
    this.match();
    const { side, field } = this.app.view.look;
    const alone = side === "surface" && field === NATURAL; // what colours one may depend on the other
    for (const one of alone ? [run] : this.surfaces.runs) this.stale.add(one);
    this.redraw();
  }

  private match(): void {
    const before = this.surfaces.count;
    if (this.shooting || !this.surfaces.match()) return;
    if (!this.view.fits) this.view.turn(0, 0, this.surfaces.count / before); // as much of the field stays in a narrower view
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
    this.paint();
  }

  /** Draw the scene into the page. */
  private paint(): void {
    this.update(this.plain === false, this.stale);
    this.stale.clear();
    this.surfaces.paint(this.canvas.clientWidth, this.canvas.clientHeight, this.manner());
    this.app.confirm();
    this.drawn++;
    this.painted.send();
  }

  /** Take over the settings of the view. */
  private follow(): void {
    this.view.open(this.app.view.look.fieldOfView);
    this.all();
  }

  /** Bring the surfaces of runs up to date: of all, or of those named. */
  private update(full: boolean, only?: Set<Run>, aspect = this.aspect()): void {
    this.surfaces.update(full, this.dark, only);
    this.view.frame(this.surfaces.box(), aspect);
  }

  private manner(transparent = false, wide = 1): Manner {
    const fine = this.shooting !== null || !this.plain;
    const haze = !this.view.isParallel && !transparent;
    const lines = this.shooting && !this.shooting.lines ? NO_LINES : this.lines;
    return { camera: this.camera, level: this.view.level(), haze, around: !transparent, fine, dark: this.dark, lines, wide };
  }

  /** Whether the scene is at dusk, as the picture that is being drawn asks, or the view. */
  private get dark(): boolean {
    return this.shooting?.dark ?? isDusk(this.app.view.look, this.host);
  }

  private aspect(): number {
    const { clientWidth: width, clientHeight: height } = this.host;
    return width / this.surfaces.count / Math.max(height, 1);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height || this.shooting) return;
    this.renderer.setPixelRatio(this.plain ? 1 : Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, true);
    this.view.frame(this.surfaces.box(), this.aspect());
    if (!this.app.graphicsLost) this.surfaces.paint(width, height, this.manner()); // else it is empty until the next picture
    this.all();
  }
}
