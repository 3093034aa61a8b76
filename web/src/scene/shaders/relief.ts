/** A pass over the field, not the screen: slopes, open sky and sunlight of each place, when heights or sun change. */

import { FIELD } from "./common";

export const RELIEF_VERTEX = /* glsl */ `
varying vec2 place;
void main() {
  place = position.xy * 0.5 + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

export const RELIEF_FRAGMENT = /* glsl */ `
precision highp float;
${FIELD}
uniform vec3 sun;
uniform float shadows;
uniform float thickness;
uniform float directions;   // in which the horizon is looked for; 0: the sky is open everywhere
varying vec2 place;

const float TURN = 6.2831853;

float surface(vec2 p) { return texture2D(heights, inTexture(p)).r; }

// How much of the sun reaches a place: rays that pass close above the surface are dimmed.
float sunlit(float h, float cell) {
  if (shadows < 0.5) return 1.0;
  vec2 along = vec2(sun.x, -sun.z);
  float level = max(length(along), 1e-3);
  along /= level;
  float rise = sun.y / level / exaggeration;
  float light = 1.0;
  float reach = cell * 1.3;
  for (int i = 0; i < 36; i++) {
    vec2 q = place + along * reach / extent;
    if (q.x < 0.0 || q.x > 1.0 || q.y < 0.0 || q.y > 1.0) break;
    float above = h + rise * reach - surface(q);
    light = min(light, 0.5 + 0.5 * above / (0.035 * reach / exaggeration + 0.6 * thickness));
    if (light <= 0.0) return 0.0;
    reach = reach * 1.11 + cell * 0.45;
  }
  return smoothstep(0.0, 1.0, light);
}

// Share of the sky that is not hidden behind the relief around.
float open(float h, float cell) {
  float sum = 0.0;
  for (int d = 0; d < 12; d++) {
    if (float(d) >= directions) break;
    float angle = TURN * (float(d) + 0.25) / directions;
    vec2 along = vec2(cos(angle), sin(angle));
    float steepest = 0.0;
    float reach = 1.2 * cell;
    for (int i = 0; i < 7; i++) {
      vec2 q = place + along * reach / extent;
      if (q.x < 0.0 || q.x > 1.0 || q.y < 0.0 || q.y > 1.0) break;
      steepest = max(steepest, (surface(q) - h) * exaggeration / reach);
      reach *= 1.75;
    }
    sum += 1.0 / (1.0 + steepest * steepest);
  }
  return directions > 0.0 ? sum / directions : 1.0;
}

void main() {
  vec3 here = spline(place);
  vec2 size = extent / cells;
  gl_FragColor = vec4(here.yz / size, open(here.x, size.x), sunlit(here.x, size.x));
}
`;
