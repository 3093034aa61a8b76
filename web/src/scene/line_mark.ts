/** A line over a surface, that of the section or of the ruler: an object of the scene, as wide everywhere. */

import * as THREE from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import type { Terrain } from "./terrain";

/** From and to, as shares of the field. */
export type Ends = [number, number, number, number];

/** Widths (pixels of the page) of the line, of its pale border, and of what is seen of it through the surface. */
const WIDE = 3;
const BESIDE = 5.5;
const THROUGH = 1.5;
const POINTS = 400;
/** How far the line floats above the surface, in units of the scene. */
const LIFT = 0.03;

/** Colours of lines. */
export const INKS = { section: 0x10263f, ruler: 0x9c1f12 };

export class LineMark {
  readonly group = new THREE.Group();
  private readonly ink: LineMaterial;
  private readonly light = new LineMaterial({ color: 0xfff8ea, linewidth: BESIDE, transparent: true, opacity: 0.75, depthWrite: false });
  private readonly hidden: LineMaterial;
  private readonly knobs: THREE.Mesh[];

  constructor(color: number) {
    // as transparent as its border, or it would be drawn before and lie under it
    this.ink = new LineMaterial({ color, linewidth: WIDE, transparent: true });
    this.hidden = new LineMaterial({ color, linewidth: THROUGH, transparent: true, opacity: 0.28, depthTest: false, depthWrite: false });
    const knob = new THREE.SphereGeometry(0.075, 16, 12);
    const paint = new THREE.MeshBasicMaterial({ color });
    this.knobs = [0, 1].map(() => new THREE.Mesh(knob, paint));
    const lines = [this.hidden, this.light, this.ink].map((material, order) => {
      const line = new Line2(new LineGeometry(), material);
      line.renderOrder = 2 + order;
      line.frustumCulled = false;
      return line;
    });
    this.group.add(...lines, ...this.knobs);
    this.group.visible = false;
  }

  /** Draw lines this many times as wide, for pictures larger than the page. */
  widen(times: number): void {
    [this.ink.linewidth, this.light.linewidth, this.hidden.linewidth] = [WIDE * times, BESIDE * times, THROUGH * times];
  }

  /** Lay the line over a surface, or take it away. */
  update(ends: Ends | null, terrain: Terrain, rows: number, columns: number): void {
    this.group.visible = ends !== null;
    if (!ends) return;
    const points: number[] = [];
    for (let i = 0; i <= POINTS; i++) {
      const t = i / POINTS;
      points.push(...terrain.at(ends[0] + t * (ends[2] - ends[0]), ends[1] + t * (ends[3] - ends[1]), rows, columns, LIFT));
    }
    for (const line of this.group.children) {
      if (!(line instanceof Line2)) continue;
      line.geometry.dispose();
      line.geometry = new LineGeometry();
      line.geometry.setPositions(points);
    }
    this.knobs[0]!.position.fromArray(points);
    this.knobs[1]!.position.fromArray(points, points.length - 3);
  }
}
