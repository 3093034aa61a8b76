/** The scene: one surface, or two side by side under one camera. */

import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { App } from "../core/app";
import type { Run } from "../core/run";
import { type Place, pick } from "./pick";
import { Terrain } from "./terrain";

interface Shown {
  run: Run;
  terrain: Terrain;
  scene: THREE.Scene;
}

export class Stage {
  readonly camera = new THREE.PerspectiveCamera(30, 1, 0.05, 200);
  readonly controls: OrbitControls;
  readonly canvas: HTMLCanvasElement;
  /** Called after every picture that was drawn. */
  onDrawn: () => void = () => {};
  /** Frames drawn, for those who measure. */
  drawn = 0;
  private readonly renderer: THREE.WebGLRenderer;
  private shown: Shown[] = [];
  private readonly stale = new Set<Run>();
  private dirty = true;
  private section: [number, number, number, number] | null = null;

  constructor(
    private readonly app: App,
    readonly host: HTMLElement,
  ) {
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The surface in three dimensions. Arrow keys turn it, + and − zoom.");
    host.prepend(this.canvas);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.maxPolarAngle = Math.PI / 2 - 0.02;
    this.controls.minDistance = 1;
    this.controls.maxDistance = 45;
    this.controls.addEventListener("change", () => this.redraw());
    new ResizeObserver(() => this.resize()).observe(host);
    app.framed.watch((run) => this.refresh(run));
    app.changed.watch(() => this.all());
    app.view.changed.watch(() => this.all());
    this.look("oblique");
    this.renderer.setAnimationLoop(() => this.tick());
  }

  /** Let the camera look from one of the usual places. */
  look(from: "oblique" | "top" | "side"): void {
    const [x, y, z] = { oblique: [-5.6, 8.3, 15.0], top: [0, 21, 0.001], side: [0, 2.2, 21] }[from] as number[];
    this.controls.target.set(0, from === "oblique" ? 0.1 : 0, 0);
    this.camera.position.set(x!, y!, z!);
    this.controls.update();
    this.redraw();
  }

  /** Turn and tilt the camera by angles (radians), and come nearer by a factor. */
  turn(around: number, up: number, nearer = 1): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const sphere = new THREE.Spherical().setFromVector3(offset);
    sphere.theta += around;
    sphere.phi = Math.min(Math.max(sphere.phi + up, 0.01), this.controls.maxPolarAngle);
    sphere.radius = Math.min(Math.max(sphere.radius * nearer, this.controls.minDistance), this.controls.maxDistance);
    this.camera.position.setFromSpherical(sphere).add(this.controls.target);
    this.controls.update();
    this.redraw();
  }

  redraw(): void {
    this.dirty = true;
  }

  /** The surface of a run. */
  terrain(run: Run): Terrain | undefined {
    return this.shown.find((one) => one.run === run)?.terrain;
  }

  /** Show the line of a section (shares of the field), or none. */
  showSection(line: [number, number, number, number] | null): void {
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

  /** The picture as it is now. */
  picture(background: string): Promise<Blob> {
    this.paint();
    const copy = document.createElement("canvas");
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    const context = copy.getContext("2d")!;
    context.fillStyle = background;
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(this.canvas, 0, 0);
    return new Promise((done) => copy.toBlob((blob) => done(blob!), "image/png"));
  }

  /** Metres of the field that a pixel of the page covers where the camera looks. */
  metresPerPixel(): number {
    const terrain = this.shown[0]?.terrain;
    if (!terrain) return Number.NaN;
    const distance = this.camera.position.distanceTo(this.controls.target);
    const height = 2 * distance * Math.tan((this.camera.fov * Math.PI) / 360);
    return height / this.canvas.clientHeight / terrain.scale;
  }

  /** Direction the camera looks at, clockwise from north (radians). */
  heading(): number {
    const ahead = this.controls.target.clone().sub(this.camera.position);
    return Math.atan2(ahead.x, -ahead.z);
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
    this.shown = this.app.runs.map((run) => {
      const known = this.shown.find((one) => one.run === run);
      if (known) return known;
      const terrain = new Terrain(this.app, linear);
      const scene = new THREE.Scene();
      scene.add(terrain.group);
      return { run, terrain, scene };
    });
    this.resize();
  }

  private tick(): void {
    this.controls.update();
    if (!this.dirty) return;
    this.dirty = false;
    for (const { run, terrain } of this.shown) {
      if (this.stale.has(run) && run.ready) terrain.update(run);
    }
    this.stale.clear();
    this.paint();
    this.app.confirm();
    this.drawn++;
    this.onDrawn();
  }

  private paint(): void {
    const count = Math.max(this.shown.length, 1);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.renderer.setScissorTest(count > 1);
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.setScissor(0, 0, width, height);
    this.renderer.clear();
    this.shown.forEach(({ run, scene, terrain }, number) => {
      if (!run.ready || !terrain.drawn.length) return;
      terrain.uniforms.section!.value.set(...(this.section ?? [-2, 0, 0, 0]));
      const left = (width / count) * number;
      this.renderer.setViewport(left, 0, width / count, height);
      this.renderer.setScissor(left, 0, width / count, height);
      this.renderer.render(scene, this.camera);
    });
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.renderer.setSize(width, height, true);
    const aspect = width / Math.max(this.shown.length, 1) / height;
    this.camera.aspect = aspect;
    this.camera.fov = aspect > 1.35 ? 30 : Math.min(30 * (1.35 / aspect), 60);
    this.camera.updateProjectionMatrix();
    this.redraw();
  }
}

function sameRuns(shown: Shown[], runs: Run[]): boolean {
  return shown.length === runs.length && shown.every((one, at) => one.run === runs[at]);
}
