/** What all shaders of the scene share: the field's heights, and noise. */

/** Heights are sampled between the centres of the first and the last cells; `place` goes from 0 to 1 there. */
export const FIELD = /* glsl */ `
uniform sampler2D heights;  // metres: surface, ground
uniform vec2 cells;         // columns, rows
uniform vec2 extent;        // metres
uniform float exaggeration;

vec2 inTexture(vec2 p) { return (p * (cells - 1.0) + 0.5) / cells; }

vec4 splineWeights(float f) {
  float g = 1.0 - f;
  return vec4(g * g * g, 4.0 - 3.0 * f * f * (2.0 - f), 4.0 - 3.0 * g * g * (2.0 - g), f * f * f) / 6.0;
}

vec4 splineSlopes(float f) {
  float g = 1.0 - f;
  return vec4(-g * g, f * (3.0 * f - 4.0), g * (3.0 * g - 4.0) * -1.0, f * f) / 2.0;
}

// A cubic B-spline through the cells: height, its slopes to the east and to the north (metres a cell).
vec3 spline(vec2 p) {
  vec2 at = p * (cells - 1.0);
  vec2 whole = floor(at);
  vec4 wx = splineWeights(at.x - whole.x), wy = splineWeights(at.y - whole.y);
  vec4 dx = splineSlopes(at.x - whole.x), dy = splineSlopes(at.y - whole.y);
  ivec2 most = ivec2(cells) - 1;
  vec3 sum = vec3(0.0);
  for (int j = 0; j < 4; j++) {
    for (int i = 0; i < 4; i++) {
      float h = texelFetch(heights, clamp(ivec2(whole) + ivec2(i - 1, j - 1), ivec2(0), most), 0).r;
      sum += h * vec3(wx[i] * wy[j], dx[i] * wy[j], wx[i] * dy[j]);
    }
  }
  return sum;
}
`;

export const NOISE = /* glsl */ `
float hash(vec2 p) {
  vec3 q = fract(vec3(p.xyx) * 0.1031);
  q += dot(q, q.yzx + 33.33);
  return fract((q.x + q.y) * q.z);
}

float noise(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  vec2 u = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1.0, 0.0)), u.x), mix(hash(i + vec2(0.0, 1.0)), hash(i + vec2(1.0, 1.0)), u.x), u.y);
}

float clouds(vec2 p) {
  return 0.53 * noise(p) + 0.28 * noise(p * 2.13 + 17.0) + 0.19 * noise(p * 4.31 + 5.0);
}
`;

/** Sun, sky and air; everything that is lit includes it. */
export const LIGHT = /* glsl */ `
uniform vec3 sun;         // towards the sun: x east, y up, z south
uniform vec3 sunLight;
uniform vec3 skyLight;
uniform vec3 horizon;     // colours of the sky and of the air, as they are shown
uniform vec3 zenith;
uniform float level;      // elevation (as a height of a unit direction) at which the plain meets the sky
uniform float haze;       // 1: distant things fade into the air
uniform float thin;       // how thin the air is: below 1 in narrow views, which are looked at from farther away

vec3 toneMapped(vec3 c) {
  c *= 0.64;
  return clamp((c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}

vec3 lit(vec3 albedo, vec3 normal, float sunlit, float open) {
  float facing = max(dot(normal, sun), 0.0);
  vec3 sky = skyLight * (0.55 + 0.45 * normal.y) * open;
  // Light that the ground around throws back: most on what faces away from the sun, and in hollows.
  float beside = 0.5 - 0.5 * dot(normal, normalize(vec3(sun.x, 0.0, sun.z) + 1e-5));
  vec3 thrown = albedo * sunLight * (0.05 + 0.10 * beside) * (1.0 - 0.35 * open);
  return albedo * (sunLight * facing * sunlit + sky + thrown);
}

// The sky in a direction; where the true horizon is above the view, the plain ends in mist at \`level\`.
vec3 skyAt(vec3 d) {
  float high = max(d.y - level, 0.0);
  vec3 colour = mix(horizon, zenith, 1.0 - exp(-13.0 * high));
  float near = max(dot(normalize(vec3(d.x, 0.0, d.z) + 1e-5), normalize(vec3(sun.x, 0.0, sun.z) + 1e-5)), 0.0);
  return colour + vec3(0.22, 0.13, 0.04) * pow(near, 4.0) * exp(-8.0 * high);
}

vec3 inAir(vec3 colour, float distance_) {
  float lost = haze * (1.0 - exp(-pow(max(thin * distance_ - 14.0, 0.0) / 70.0, 1.2)));
  return mix(colour, horizon, lost);
}
`;
