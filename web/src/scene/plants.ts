/** Tufts of plants that stand on a field, as dense as its layers of plants say. */

import * as THREE from "three";
import { TUFT_FRAGMENT, TUFT_VERTEX } from "./shaders/plants";

const MOST = 60_000;
const BLADES = 7;

export class Plants {
  readonly mesh: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.ShaderMaterial>;

  constructor(uniforms: Record<string, THREE.IUniform>) {
    const material = new THREE.ShaderMaterial({ vertexShader: TUFT_VERTEX, fragmentShader: TUFT_FRAGMENT, uniforms, side: THREE.DoubleSide });
    this.mesh = new THREE.Mesh(tuft(), material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** Roots for a field of this shape: one about each cell, fewer where there are too many cells. */
  sow(columns: number, rows: number): void {
    const every = Math.sqrt(Math.max(1, (columns * rows) / MOST));
    const [across, along] = [Math.max(Math.round(columns / every), 1), Math.max(Math.round(rows / every), 1)];
    const roots = new Float32Array(4 * across * along);
    const chance = random(7);
    for (let i = 0; i < across * along; i++) {
      const [x, y] = [i % across, Math.floor(i / across)];
      roots.set([(x + chance()) / across, (y + chance()) / along, 6.283 * chance(), chance()], 4 * i);
    }
    const { geometry } = this.mesh;
    geometry.setAttribute("root", new THREE.InstancedBufferAttribute(roots, 4));
    geometry.instanceCount = across * along;
  }
}

/** Blades that lean outwards from one root, each a triangle, about one metre high. */
function tuft(): THREE.InstancedBufferGeometry {
  const position: number[] = [];
  const uv: number[] = [];
  const chance = random(3);
  for (let i = 0; i < BLADES; i++) {
    const angle = (6.283 * (i + 0.6 * chance())) / BLADES;
    const [x, z] = [Math.cos(angle), Math.sin(angle)];
    const [wide, lean, high] = [0.17, 0.25 + 0.45 * chance(), 0.6 + 0.4 * chance()];
    position.push(-z * wide + 0.1 * x, 0, x * wide + 0.1 * z, z * wide + 0.1 * x, 0, -x * wide + 0.1 * z, x * lean, high, z * lean);
    uv.push(0, 0, 0, 0, 0, 1);
  }
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
  geometry.setAttribute("uv", new THREE.Float32BufferAttribute(uv, 2));
  return geometry;
}

/** The same numbers each time, so that plants stay where they are. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
