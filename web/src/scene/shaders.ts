/** The surface on the graphics card: displaced by its heights, lit, coloured, lined. */

export const VERTEX = /* glsl */ `
precision highp float;
uniform sampler2D heights; // metres: surface, ground
uniform vec2 cells;        // columns, rows
uniform vec2 extent;       // metres
uniform float scale;       // metres to units of the scene
uniform float exaggeration;
uniform float base;        // metres
attribute float wall;      // 1 at the foot of a side wall
varying vec2 place;        // 0 to 1 over the field, from its south-west corner
varying float height;
varying float wallness;

void main() {
  place = uv;
  vec2 at = (uv * (cells - 1.0) + 0.5) / cells;
  height = mix(texture2D(heights, at).r, base, wall);
  wallness = wall;
  vec3 metres = vec3((uv.x - 0.5) * extent.x, (height - base) * exaggeration, (0.5 - uv.y) * extent.y);
  gl_Position = projectionMatrix * viewMatrix * vec4(metres * scale, 1.0);
}
`;

export const FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D heights;
uniform sampler2D values;   // what colours the surface, in its own unit
uniform sampler2D map;      // colour map
uniform sampler2D overlay;  // shares of up to four layers
uniform vec2 cells;
uniform vec2 extent;
uniform float exaggeration;
uniform vec2 limits;
uniform float natural;      // 1: colour of the material instead of the map
uniform vec3 sun;           // towards the sun: x east, y up, z south
uniform float shadows;
uniform float bare;         // 1: show ground without cover apart
uniform float thickness;
uniform float contour;      // metres from one contour to the next, 0: none
uniform float wire;
uniform vec3 tints[4];
uniform vec4 section;       // from and to, 0 to 1; x below -1: none
uniform vec3 brush;         // centre (0 to 1) and radius (m), radius 0: none
uniform vec3 materialColour;
uniform vec3 groundColour;
uniform float isWall;
varying vec2 place;
varying float height;
varying float wallness;

vec2 inTexture(vec2 p) { return (p * (cells - 1.0) + 0.5) / cells; }
float surface(vec2 p) { return texture2D(heights, inTexture(p)).r; }

vec3 normalAt(vec2 p) {
  vec2 d = 1.0 / max(cells - 1.0, 1.0);
  vec2 size = extent / cells;
  float dx = (surface(p + vec2(d.x, 0.0)) - surface(p - vec2(d.x, 0.0))) / (2.0 * size.x);
  float dy = (surface(p + vec2(0.0, d.y)) - surface(p - vec2(0.0, d.y))) / (2.0 * size.y);
  return normalize(vec3(-dx * exaggeration, 1.0, dy * exaggeration));
}

// How much of the sun reaches a place: rays that pass close above the surface are dimmed.
float sunlit(vec2 p, float h) {
  if (shadows < 0.5) return 1.0;
  vec2 along = vec2(sun.x, -sun.z);
  float flat_ = length(along);
  if (flat_ < 1e-3) return 1.0;
  along /= flat_;
  float rise = sun.y / flat_ / exaggeration;
  float cell = extent.x / cells.x;
  float light = 1.0;
  float reach = cell * 1.2;
  for (int i = 0; i < 28; i++) {
    vec2 q = p + along * reach / extent;
    if (q.x < 0.0 || q.x > 1.0 || q.y < 0.0 || q.y > 1.0) break;
    float above = h + rise * reach - surface(q);
    light = min(light, 0.5 + 0.5 * above / (0.07 * reach + 0.5 * thickness));
    if (light <= 0.0) return 0.12;
    reach *= 1.16;
    reach += cell * 0.35;
  }
  return mix(0.12, 1.0, smoothstep(0.0, 1.0, clamp(light, 0.0, 1.0)));
}

float line(float distance_, float width) {
  float w = fwidth(distance_) * width;
  return 1.0 - smoothstep(w * 0.5, w * 1.5, abs(distance_));
}

float segmentDistance(vec2 p, vec2 a, vec2 b) {
  vec2 ab = b - a;
  float t = clamp(dot(p - a, ab) / max(dot(ab, ab), 1e-9), 0.0, 1.0);
  return length(p - a - t * ab);
}

void main() {
  vec2 texel = inTexture(place);
  vec4 here = texture2D(heights, texel);
  vec3 ground = groundColour;
  if (isWall > 0.5) {
    vec3 colour = height > here.g ? materialColour * 0.66 : ground * 0.55;
    gl_FragColor = vec4(colour, 1.0);
    #include <colorspace_fragment>
    return;
  }
  vec3 normal = normalAt(place);
  float value = (texture2D(values, texel).r - limits.x) / max(limits.y - limits.x, 1e-9);
  vec3 mapped = texture2D(map, vec2(clamp(value, 0.0, 1.0) * 63.0 / 64.0 + 0.5 / 64.0, 0.5)).rgb;
  mapped = pow(mapped, vec3(2.2));
  vec3 colour = mix(mapped, materialColour, natural);
  float covered = smoothstep(0.05, 0.6, (here.r - here.g) / thickness);
  vec2 beside = 1.0 / cells;
  vec2 rise = vec2(
    texture2D(heights, texel + vec2(beside.x, 0.0)).g - texture2D(heights, texel - vec2(beside.x, 0.0)).g,
    texture2D(heights, texel + vec2(0.0, beside.y)).g - texture2D(heights, texel - vec2(0.0, beside.y)).g
  ) * cells / extent / 2.0;
  covered *= 1.0 - smoothstep(0.9, 1.6, length(rise)); // loose material does not lie on walls of rock
  if (bare > 0.5) colour = mix(ground, colour, covered);
  vec4 shares = texture2D(overlay, texel);
  for (int i = 0; i < 4; i++) {
    float share = i == 0 ? shares.r : i == 1 ? shares.g : i == 2 ? shares.b : shares.a;
    vec3 tint = mix(tints[i] * 1.9 + 0.12, tints[i] * 0.5, clamp(share, 0.0, 1.0));
    colour = mix(colour, tint, 0.85 * smoothstep(0.01, 0.3, share));
  }
  float facing = dot(normal, sun);
  float light = sunlit(place, here.r);
  float direct = max(facing, 0.0) / max(sun.y, 0.3);
  float sky = 0.5 + 0.5 * normal.y;
  float bounce = 0.5 - 0.5 * dot(normal, vec3(sun.x, 0.0, sun.z));
  vec3 shade = vec3(1.0, 0.965, 0.90) * 0.66 * min(direct, 1.7) * light
    + vec3(0.84, 0.89, 1.0) * 0.34 * sky + vec3(1.0, 0.86, 0.70) * 0.10 * bounce;
  colour *= shade;
  if (contour > 0.0) {
    float at = here.r / contour;
    float edge = abs(fract(at - 0.5) - 0.5) / max(fwidth(at), 1e-6);
    colour = mix(colour, colour * 0.28, (1.0 - smoothstep(0.4, 1.3, edge)) * 0.85);
  }
  if (wire > 0.5) {
    vec2 grid = place * (cells - 1.0);
    vec2 edge = abs(fract(grid - 0.5) - 0.5) / max(fwidth(grid), vec2(1e-6));
    float fade = 1.0 - smoothstep(0.25, 0.7, max(fwidth(grid).x, fwidth(grid).y));
    colour = mix(colour, colour * 0.35, (1.0 - smoothstep(0.3, 1.2, min(edge.x, edge.y))) * 0.8 * fade);
  }
  if (section.x > -1.0) {
    float d = segmentDistance(place * extent, section.xy * extent, section.zw * extent);
    float wide = length(fwidth(place * extent)) * 0.8;
    float ends = min(length((place - section.xy) * extent), length((place - section.zw) * extent));
    float ink = max(1.0 - smoothstep(wide, 1.8 * wide, d), 1.0 - smoothstep(3.2 * wide, 4.2 * wide, ends));
    colour = mix(colour, vec3(0.03, 0.10, 0.22), 0.92 * ink);
  }
  if (brush.z > 0.0) {
    vec2 off = (place - brush.xy) * extent;
    float d = length(off) - brush.z;
    colour = mix(colour, vec3(1.0), 0.10 * step(d, 0.0) + 0.75 * line(d, 1.4));
  }
  gl_FragColor = vec4(colour, 1.0);
  #include <colorspace_fragment>
}
`;
