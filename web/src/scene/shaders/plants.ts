/** Tufts of plants: as many blades as a place has plants, where the surface is. */

import { FIELD, LIGHT, NOISE } from "./common";

export const TUFT_VERTEX = /* glsl */ `
precision highp float;
${FIELD}
${NOISE}
uniform sampler2D overlay;
uniform sampler2D relief;
uniform float scale;
uniform float base;
uniform float size;         // metres of a full-grown tuft
uniform vec3 tints[4];
attribute vec4 root;        // place (0 to 1), turn, chance
varying vec3 tint;
varying float tip;
varying vec3 spot;
varying vec2 light;

void main() {
  vec4 shares = texture2D(overlay, inTexture(root.xy));
  float most = max(max(shares.r, shares.g), max(shares.b, shares.a));
  vec3 own = most == shares.r ? tints[0] : most == shares.g ? tints[1] : most == shares.b ? tints[2] : tints[3];
  float grown = step(root.w, pow(smoothstep(0.02, 0.9, most), 1.3)) * (0.45 + 0.55 * most) * (0.7 + 0.6 * hash(root.xy * 977.0));
  float c = cos(root.z), s = sin(root.z);
  vec3 blade = position * vec3(1.0, 1.25, 1.0) * size * grown;
  blade.xz = mat2(c, s, -s, c) * blade.xz;
  float foot = spline(root.xy).x;
  vec4 form = texture2D(relief, root.xy);
  light = vec2(form.b, form.a);
  tip = uv.y;
  tint = own * (0.8 + 0.45 * hash(root.xy * 311.0));
  vec3 at = vec3((root.x - 0.5) * extent.x, (foot - base) * exaggeration, (0.5 - root.y) * extent.y);
  spot = (at + blade) * scale;
  gl_Position = grown > 0.0 ? projectionMatrix * viewMatrix * vec4(spot, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
`;

export const TUFT_FRAGMENT = /* glsl */ `
precision highp float;
${LIGHT}
varying vec3 tint;
varying float tip;
varying vec3 spot;
varying vec2 light;
void main() {
  vec3 colour = mix(tint * 0.55, tint * 1.35, tip);
  vec3 normal = normalize(vec3(0.35 * sun.x, 1.0, 0.35 * sun.z));
  vec3 seen = lit(colour, normal, light.y * (0.45 + 0.55 * tip), light.x * (0.5 + 0.5 * tip));
  gl_FragColor = vec4(toneMapped(inAir(seen, distance(spot, cameraPosition))), 1.0);
  #include <colorspace_fragment>
}
`;
