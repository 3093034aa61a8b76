/** Slopes, open sky and sunlight of a field, worked out on the graphics card when heights or sun have changed. */

import * as THREE from "three";
import { RELIEF_FRAGMENT, RELIEF_VERTEX } from "./shaders/relief";

/** Texels of the pass along a field's longer side, and directions in which the horizon is looked for. */
export const FULL = { least: 512, most: 1024, directions: 10 };
export const PLAIN = { least: 64, most: 256, directions: 4 };

export class Relief {
  readonly target = new THREE.WebGLRenderTarget(1, 1, {
    type: THREE.HalfFloatType,
    format: THREE.RGBAFormat,
    minFilter: THREE.LinearFilter,
    magFilter: THREE.LinearFilter,
    depthBuffer: false,
  });
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.Camera();

  constructor(private readonly uniforms: Record<string, THREE.IUniform>) {
    const material = new THREE.ShaderMaterial({ vertexShader: RELIEF_VERTEX, fragmentShader: RELIEF_FRAGMENT, uniforms, depthTest: false });
    const screen = new THREE.Mesh(wholeScreen(), material);
    screen.frustumCulled = false;
    this.scene.add(screen);
  }

  render(renderer: THREE.WebGLRenderer, columns: number, rows: number, quality: typeof FULL): void {
    const longer = Math.max(columns, rows);
    const factor = Math.min(Math.max(quality.least, longer), quality.most) / longer;
    this.target.setSize(Math.max(Math.round(columns * factor), 4), Math.max(Math.round(rows * factor), 4));
    this.uniforms.directions!.value = quality.directions;
    const before = renderer.getRenderTarget();
    renderer.setRenderTarget(this.target);
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(before);
  }

  dispose(): void {
    this.target.dispose();
  }
}

/** One triangle that covers the whole view. */
export function wholeScreen(): THREE.BufferGeometry {
  return new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
}
