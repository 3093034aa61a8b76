/** Paths of grains as lines over a surface. */

import * as THREE from "three";
import type { Run } from "../core/run";
import { themeColour } from "../ui/dom";
import type { Terrain } from "./terrain";

/** How high above the surface the highest path may be drawn, of the field's longer side. */
const ROOM = 0.22;

export class PathLines {
  readonly lines = new THREE.LineSegments(
    new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({ transparent: true, opacity: 0.85 }),
  );

  constructor(private readonly host: Element) {
    this.lines.frustumCulled = false;
  }

  /** Show the paths of a run; over flat beds heights are exaggerated only as far as all paths fit. */
  update(run: Run, terrain: Terrain, exaggeration: number): void {
    const ends: number[] = [];
    const [width, depth] = terrain.extent;
    const { scale } = terrain;
    const surfaceAt = (x: number, y: number) => {
      const column = Math.min(Math.max(Math.floor((x / width) * run.columns), 0), run.columns - 1);
      const row = Math.min(Math.max(Math.floor((y / depth) * run.rows), 0), run.rows - 1);
      return terrain.drawn[row * run.columns + column]!;
    };
    const lift = Math.min(exaggeration, (ROOM * Math.max(width, depth)) / (highest(run.paths, surfaceAt) || 1));
    for (const path of run.paths) {
      for (let i = 0; i < path.length; i += 3) {
        const [x, y, z] = path.slice(i, i + 3) as [number, number, number];
        const foot = surfaceAt(x, y);
        const point = [(x - width / 2) * scale, terrain.inScene(foot) + Math.max(z - foot, 0) * lift * scale, (depth / 2 - y) * scale];
        ends.push(...point);
        if (i > 0 && i < path.length - 3) ends.push(...point);
      }
    }
    this.lines.material.color.set(themeColour("second", this.host));
    this.lines.geometry.dispose();
    this.lines.geometry = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(ends, 3));
    this.lines.visible = ends.length > 0;
  }

  dispose(): void {
    this.lines.geometry.dispose();
    this.lines.material.dispose();
  }
}

function highest(paths: number[][], surfaceAt: (x: number, y: number) => number): number {
  let most = 0;
  for (const path of paths) {
    for (let i = 0; i < path.length; i += 3) most = Math.max(most, path[i + 2]! - surfaceAt(path[i]!, path[i + 1]!));
  }
  return most;
}
