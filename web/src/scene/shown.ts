/** A run's surface with everything around it, as one scene. */

import * as THREE from "three";
import type { App } from "../core/app";
import type { Run } from "../core/run";
import { type LightUniforms, lightUniforms } from "./light";
import { type Ends, INKS, LineMark } from "./line_mark";
import { lookOf } from "./looks";
import { narrowness } from "./narrow";
import { Surroundings } from "./surroundings";
import { Terrain } from "./terrain";

/** Of its daylight colour, what the plain has at dusk. */
const DUSKY = 0.55;

/** Lines over the surface, by what they are for; shares of the field, or none. */
export type Lines = Record<keyof typeof INKS, Ends | null>;

export const NO_LINES: Lines = { section: null, ruler: null };

/** How a scene is drawn. */
export interface Manner {
  camera: THREE.Camera;
  /** Elevation at which the plain meets the sky, as a share of the view's radius. */
  level: number;
  haze: boolean;
  /** Whether sky and plain are drawn, and whether finely. */
  around: boolean;
  fine: boolean;
  dark: boolean;
  lines: Lines;
  /** How many times as wide as on the page lines are. */
  wide: number;
}

export class Shown {
  readonly light: LightUniforms = lightUniforms();
  readonly terrain: Terrain;
  private readonly around = new Surroundings(this.light);
  private readonly marks = { section: new LineMark(INKS.section), ruler: new LineMark(INKS.ruler) };
  private readonly scene = new THREE.Scene();

  constructor(
    private readonly app: App,
    readonly run: Run,
    linear: boolean,
    host: Element,
    winds: Map<string, number>,
  ) {
    this.terrain = new Terrain(app, this.light, linear, host, winds);
    this.scene.add(this.around.group, this.terrain.group, this.marks.section.group, this.marks.ruler.group);
  }

  /** Draw it into a part of the canvas (left, bottom, width, height), where there is something to draw. */
  draw(renderer: THREE.WebGLRenderer, viewport: [number, number, number, number], manner: Manner): void {
    const { run, terrain, light } = this;
    if (!run.ready || !terrain.drawn.length) return;
    light.haze.value = manner.haze ? 1 : 0;
    light.level.value = manner.level;
    light.thin.value = manner.camera instanceof THREE.PerspectiveCamera ? narrowness(manner.camera.aspect) : 1;
    for (const name of ["section", "ruler"] as const) {
      this.marks[name].widen(manner.wide);
      this.marks[name].update(manner.lines[name], terrain, run.rows, run.columns);
    }
    this.around.group.visible = manner.around;
    const plain = new THREE.Color(...lookOf(run.material, this.app.view.look.sand).plain).multiplyScalar(manner.dark ? DUSKY : 1);
    this.around.update(manner.camera, terrain.block(run.columns), plain, manner.fine);
    renderer.setViewport(...viewport);
    renderer.setScissor(...viewport);
    renderer.render(this.scene, manner.camera);
  }
}
