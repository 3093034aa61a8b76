/** What the shaders of a surface are given; `Terrain` fills it in. */

import * as THREE from "three";

export function terrainUniforms(): Record<string, THREE.IUniform> {
  const textures = ["heights", "relief", "values", "map", "overlay", "draped"].map((name) => [name, { value: null }] as const);
  const numbers: Record<string, number> = {
    scale: 1,
    exaggeration: 1,
    base: 0,
    natural: 1,
    shaded: 1,
    shadows: 1,
    bare: 1,
    thickness: 1,
    contour: 0,
    wire: 0,
    fine: 1,
    rounded: 1,
    ripples: 1,
    size: 1,
    directions: 0,
    opacity: 0,
  };
  return {
    ...Object.fromEntries(textures),
    ...Object.fromEntries(Object.entries(numbers).map(([name, value]) => [name, { value }])),
    cells: { value: new THREE.Vector2(1, 1) },
    extent: { value: new THREE.Vector2(1, 1) },
    limits: { value: new THREE.Vector2(0, 1) },
    blowing: { value: new THREE.Vector2(1, 0) },
    loose: { value: new THREE.Vector3(1, 1, 1) },
    looseDark: { value: new THREE.Vector3(1, 1, 1) },
    brush: { value: new THREE.Vector3(0, 0, 0) },
    tints: { value: [] },
  };
}
