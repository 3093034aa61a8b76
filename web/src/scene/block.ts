/** The shape of the block that a field is cut from: its surface and its side walls. */

import * as THREE from "three";

export function grid(across: number, along: number): THREE.BufferGeometry {
  const geometry = new THREE.PlaneGeometry(1, 1, Math.max(across, 1), Math.max(along, 1));
  geometry.setAttribute("wall", new THREE.BufferAttribute(new Float32Array(geometry.attributes.uv!.count), 1));
  return geometry;
}

/** The four side walls of the block that the field is cut from. */
export function skirt(across: number, along: number): THREE.BufferGeometry {
  const uv: number[] = [];
  const wall: number[] = [];
  const index: number[] = [];
  const side = (from: [number, number], to: [number, number], parts: number) => {
    for (let i = 0; i <= parts; i++) {
      const t = i / parts;
      const at = [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
      const first = wall.length;
      uv.push(...at, ...at);
      wall.push(0, 1);
      if (i < parts) index.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
    }
  };
  side([0, 0], [1, 0], across);
  side([1, 0], [1, 1], along);
  side([1, 1], [0, 1], across);
  side([0, 1], [0, 0], along);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("uv", new THREE.Float32BufferAttribute(uv, 2));
  geometry.setAttribute("wall", new THREE.Float32BufferAttribute(wall, 1));
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(new Float32Array(wall.length * 3), 3));
  geometry.setIndex(index);
  return geometry;
}
