/** The sky, and the plain with the block's shadow. */

import * as THREE from "three";
import type { LightUniforms } from "./light";
import { wholeScreen } from "./relief";
import { PLAIN_FRAGMENT, PLAIN_VERTEX, SKY_FRAGMENT, SKY_VERTEX } from "./shaders/surroundings";

const REACH = 600;

export class Surroundings {
  readonly group = new THREE.Group();
  private readonly own = {
    fromScreen: { value: new THREE.Matrix4() },
    block: { value: new THREE.Vector3(5, 5, 0.3) },
    plainColour: { value: new THREE.Color() },
    fine: { value: 1 },
  };

  constructor(light: LightUniforms) {
    const uniforms = { ...light, ...this.own };
    const sky = new THREE.Mesh(wholeScreen(), new THREE.ShaderMaterial({ vertexShader: SKY_VERTEX, fragmentShader: SKY_FRAGMENT, uniforms, depthWrite: false }));
    const plain = new THREE.Mesh(new THREE.PlaneGeometry(REACH, REACH), new THREE.ShaderMaterial({ vertexShader: PLAIN_VERTEX, fragmentShader: PLAIN_FRAGMENT, uniforms }));
    plain.rotation.x = -Math.PI / 2;
    plain.position.y = -0.004;
    sky.frustumCulled = plain.frustumCulled = false;
    sky.renderOrder = -1;
    this.group.add(sky, plain);
  }

  /** For a camera, a block (half width, half depth, height of its walls) and a plain of this colour. */
  update(camera: THREE.Camera, block: [number, number, number], plain: THREE.ColorRepresentation, fine: boolean): void {
    camera.updateMatrixWorld();
    this.own.fromScreen.value.copy(camera.matrixWorld).multiply(camera.projectionMatrixInverse);
    this.own.block.value.set(...block);
    this.own.plainColour.value.set(plain);
    this.own.fine.value = fine ? 1 : 0;
  }
}
