/** The scene: one surface, or two side by side under one camera. */

import * as THREE from "three";
import type { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { App } from "../core/app";
import type { Run } from "../core/run";
import { Camera, type Standpoint, type Viewpoint } from "./camera";
import { type LightUniforms, lightUniforms, shine, sunOf } from "./light";
import { lookOf } from "./looks";
import { type Place, pick } from "./pick";
import { Quality } from "./quality";
import { type Ends, SectionMark } from "./section_line";
import { Surroundings } from "./surroundings";
import { Terrain } from "./terrain";

interface Shown {
  run: Run;
  terrain: Terrain;
  light: LightUniforms;
  around: Surroundings;
  section: SectionMark;
  scene: THREE.Scene;
}

/** What a picture shows and how large it is (pixels). */
export interface PictureOptions {
  width: number;
  height: number;
  /** Whether sky and plain are left out. */
  transparent?: boolean;
}

export class Stage {
  readonly view: Camera;
  readonly canvas: HTMLCanvasElement;
  /** Called after every picture that was drawn. */
  onDrawn: () => void = () => {};
  /** Frames drawn, for those who measure. */
  drawn = 0;
  readonly quality: Quality;
  private readonly renderer: THREE.WebGLRenderer;
  private shown: Shown[] = [];
  private readonly stale = new Set<Run>();
  private dirty = true;
  private wasDirty = false;
  private section: Ends | null = null;
  private readonly resized = new ResizeObserver(() => this.resize());
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
    this.view.mayTurn = () => app.view.look.turning && !this.still.matches && !this.plain && this.shown.some(({ run }) => run.ready);
    this.resized.observe(host);
    app.framed.watch((run) => this.refresh(run));
    app.changed.watch(() => this.all());
    app.view.changed.watch(() => this.all());
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
    this.section = line;
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

  /** A picture of any size (PNG), drawn fully whatever the page shows, beside the page. */
  async render(options: PictureOptions): Promise<Blob> {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [options.width, options.height];
    const context = canvas.getContext("2d")!;
    const ratio = this.renderer.getPixelRatio();
    try {
      this.renderer.setPixelRatio(1);
      this.renderer.setSize(options.width, options.height, false);
      this.update(true, undefined, options.width / Math.max(this.shown.length, 1) / options.height);
      this.paint(options.width, options.height, options.transparent);
      context.drawImage(this.canvas, 0, 0);
    } finally {
      this.renderer.setPixelRatio(ratio);
      this.resize();
      this.all();
    }
    return new Promise((done) => canvas.toBlob((blob) => done(blob!), "image/png"));
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

  /** Draw no more, and give back what the graphics card holds: browsers allow few such scenes at a time. */
  dispose(): void {
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
    if (sameRuns(this.shown, this.app.runs)) return;
    const linear = this.renderer.extensions.has("OES_texture_float_linear");
    const before = this.shown;
    this.shown = this.app.runs.map((run) => before.find((one) => one.run === run) ?? shownOf(this.app, run, linear, this.host));
    for (const one of before) if (!this.shown.includes(one)) one.terrain.dispose();
    this.resize();
  }

  private tick(): void {
    this.view.update();
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
    this.onDrawn();
  }

  /** Bring the surfaces of runs up to date: of all, or of those named. */
  private update(full: boolean, only?: Set<Run>, aspect = this.aspect()): void {
    for (const { run, terrain, light } of this.shown) {
      if (!run.ready || (only && !only.has(run))) continue;
      terrain.begin(run);
      shine(light, sunOf(this.app.view.look, terrain.firstWind!), isDark(this.host));
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

  private paint(width: number, height: number, transparent = false): void {
    const count = Math.max(this.shown.length, 1);
    this.renderer.setScissorTest(count > 1);
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.setScissor(0, 0, width, height);
    this.renderer.clear();
    this.shown.forEach(({ run, scene, terrain, light, around, section }, number) => {
      if (!run.ready || !terrain.drawn.length) return;
      light.haze.value = this.view.isParallel || transparent ? 0 : 1;
      light.level.value = this.view.level();
      section.update(this.section, terrain, run.rows, run.columns);
      around.group.visible = !transparent;
      const plain = new THREE.Color(...lookOf(run.material).plain).multiplyScalar(isDark(this.host) ? 0.55 : 1);
      around.update(this.camera, terrain.block(run.columns), plain, !this.plain);
      const left = (width / count) * number;
      this.renderer.setViewport(left, 0, width / count, height);
      this.renderer.setScissor(left, 0, width / count, height);
      this.renderer.render(scene, this.camera);
    });
  }

  private aspect(): number {
    const { clientWidth: width, clientHeight: height } = this.host;
    return width / Math.max(this.shown.length, 1) / Math.max(height, 1);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.renderer.setPixelRatio(this.plain ? 1 : Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, true);
    const terrain = this.shown.find(({ terrain }) => terrain.drawn.length)?.terrain;
    this.view.frame(terrain ? this.roomy(terrain.box()) : new THREE.Box3(new THREE.Vector3(-5, 0, -5), new THREE.Vector3(5, 1, 5)), this.aspect());
    this.all();
  }
}

const isDark = (host: Element): boolean => getComputedStyle(host).colorScheme === "dark";

function shownOf(app: App, run: Run, linear: boolean, host: Element): Shown {
  const light = lightUniforms();
  const terrain = new Terrain(app, light, linear, host);
  const around = new Surroundings(light);
  const section = new SectionMark();
  const scene = new THREE.Scene();
  scene.add(around.group, terrain.group, section.group);
  return { run, terrain, light, around, section, scene };
}

function sameRuns(shown: Shown[], runs: Run[]): boolean {
  return shown.length === runs.length && shown.every((one, at) => one.run === runs[at]);
}
