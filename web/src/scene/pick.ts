/** Where a ray from the eye meets the surface. */

import * as THREE from "three";
import type { Terrain } from "./terrain";

export interface Place {
  /** Metres from the south-west corner. */
  x: number;
  y: number;
  row: number;
  column: number;
}

const MARCH = 600;
/** Parts of the field to which a place is known; finer ones at its edges would be rounding errors. */
const PARTS = 1e6;

/** The place under a point of the view (-1 to 1), null beside the field. */
export function pick(
  terrain: Terrain,
  rows: number,
  columns: number,
  point: THREE.Vector2,
  camera: THREE.Camera,
): Place | null {
  const ray = new THREE.Raycaster();
  ray.setFromCamera(point, camera);
  const { origin, direction } = ray.ray;
  const [width, depth] = terrain.extent.map((length) => length * terrain.scale) as [number, number];
  const at = (t: number) => {
    const x = (origin.x + t * direction.x) / width + 0.5;
    const y = 0.5 - (origin.z + t * direction.z) / depth;
    return { x, y, inside: x >= 0 && x <= 1 && y >= 0 && y <= 1 };
  };
  const box = new THREE.Box3(
    new THREE.Vector3(-width / 2, -1, -depth / 2),
    new THREE.Vector3(width / 2, 60, depth / 2),
  );
  const entry = ray.ray.intersectBox(box, new THREE.Vector3());
  if (!entry) return null;
  const start = entry.distanceTo(origin);
  const reach = 2 * Math.hypot(width, depth) + 60;
  for (let i = 0; i <= MARCH; i++) {
    const t = start + (reach * i) / MARCH;
    const { x, y, inside } = at(t);
    if (!inside) continue;
    const column = Math.min(Math.floor(x * columns), columns - 1);
    const row = Math.min(Math.floor(y * rows), rows - 1);
    if (origin.y + t * direction.y <= terrain.inScene(terrain.drawn[row * columns + column]!)) {
      const [across, up] = [x, y].map((share) => Math.round(share * PARTS) / PARTS) as [number, number];
      return { x: across * terrain.extent[0], y: up * terrain.extent[1], row, column };
    }
  }
  return null;
}
