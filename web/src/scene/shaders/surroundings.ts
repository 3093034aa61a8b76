/** The sky, and the plain that the block stands on. */

import { LIGHT, NOISE } from "./common";

export const SKY_VERTEX = /* glsl */ `
uniform mat4 fromScreen;    // from the screen to directions in the scene
varying vec3 direction;
varying float up;
void main() {
  vec4 far = fromScreen * vec4(position.xy, 1.0, 1.0);
  vec4 near = fromScreen * vec4(position.xy, -1.0, 1.0);
  direction = far.xyz / far.w - near.xyz / near.w;
  up = position.y;
  gl_Position = vec4(position.xy, 0.99999, 1.0);
}
`;

export const SKY_FRAGMENT = /* glsl */ `
precision highp float;
${NOISE}
${LIGHT}
varying vec3 direction;
void main() {
  vec3 d = normalize(direction);
  vec3 colour = skyAt(d);
  colour += (hash(gl_FragCoord.xy) - 0.5) / 400.0; // no bands in a smooth sky
  gl_FragColor = vec4(toneMapped(colour), 1.0);
  #include <colorspace_fragment>
}
`;

export const PLAIN_VERTEX = /* glsl */ `
varying vec3 spot;
void main() {
  spot = (modelMatrix * vec4(position, 1.0)).xyz;
  gl_Position = projectionMatrix * viewMatrix * vec4(spot, 1.0);
}
`;

export const PLAIN_FRAGMENT = /* glsl */ `
precision highp float;
${NOISE}
${LIGHT}
uniform vec3 block;         // half its width and depth, and the height of its walls
uniform vec3 plainColour;
uniform float fine;
varying vec3 spot;

float beside(vec2 p) {
  vec2 d = abs(p) - block.xy;
  return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}

void main() {
  vec2 p = spot.xz;
  float away = distance(spot, cameraPosition);
  float pixel = length(fwidth(p));
  vec3 colour = plainColour * (0.90 + 0.20 * clouds(p * 0.22));
  colour *= 1.0 + fine * 0.10 * (noise(p * 9.0) - 0.5) * (1.0 - smoothstep(0.03, 0.12, pixel));
  // The sun's shadow of the block: the block itself, moved away from the sun, softer where it is longer.
  float longest = block.z * length(sun.xz) / max(sun.y, 0.08);
  vec2 from = normalize(sun.xz + 1e-5);
  // How far the block is from here decreases on the way to the sun, then increases: its least is found by thirds.
  float near = 0.0, far = 1.0;
  for (int i = 0; i < 16; i++) {
    float a = mix(near, far, 0.382), b = mix(near, far, 0.618);
    if (beside(p + from * longest * a) < beside(p + from * longest * b)) far = b;
    else near = a;
  }
  float t = 0.5 * (near + far);
  float lightest = smoothstep(-0.05, 0.06 + 0.25 * t, beside(p + from * longest * t));
  float open = 1.0 - 0.62 * exp(-max(beside(p), 0.0) / (0.35 + 0.5 * block.z));
  colour = inAir(lit(colour, vec3(0.0, 1.0, 0.0), lightest, open), away);
  vec3 d = normalize(spot - cameraPosition);
  float lost = haze * max(smoothstep(30.0, 300.0, thin * away), smoothstep(level - 0.16, level, d.y));
  gl_FragColor = vec4(toneMapped(mix(colour, skyAt(d), lost)), 1.0);
  #include <colorspace_fragment>
}
`;
