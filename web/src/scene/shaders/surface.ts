/** The field's surface and the walls of its block. */

import { FIELD, LIGHT, NOISE } from "./common";
import { LINES } from "./lines";
import { MATERIAL } from "./material";

const PLACED = /* glsl */ `
uniform float scale;        // metres to units of the scene
uniform float base;         // metres

vec3 inScene(vec2 p, float height_) {
  return vec3((p.x - 0.5) * extent.x, (height_ - base) * exaggeration, (0.5 - p.y) * extent.y) * scale;
}
`;

export const SURFACE_VERTEX = /* glsl */ `
precision highp float;
${FIELD}
${PLACED}
uniform float rounded;      // 1: a smooth surface through the cells
attribute float wall;       // 1 at the foot of a side wall
varying vec2 place;
varying float height;
varying vec3 spot;

void main() {
  place = uv;
  float top = rounded > 0.5 ? spline(uv).x : texture2D(heights, inTexture(uv)).r;
  height = mix(top, base, wall);
  spot = inScene(uv, height);
  gl_Position = projectionMatrix * viewMatrix * vec4(spot, 1.0);
}
`;

export const WALL_FRAGMENT = /* glsl */ `
precision highp float;
${FIELD}
${NOISE}
${LIGHT}
${MATERIAL}
uniform float scale;
varying vec2 place;
varying float height;
varying vec3 spot;

void main() {
  float ground = texture2D(heights, inTexture(place)).g;
  vec3 normal = abs(place.x - 0.5) > abs(place.y - 0.5) ? vec3(sign(place.x - 0.5), 0.0, 0.0) : vec3(0.0, 0.0, sign(0.5 - place.y));
  vec2 along = vec2(dot(place, vec2(1.0)) * max(cells.x, cells.y), spot.y * 14.0);
  float bands = noise(vec2(along.x * 0.03, along.y * 2.6 + noise(along * vec2(0.05, 0.3))));
  vec3 colour = height > ground
    ? mix(looseDark, loose, 0.25 + 0.4 * bands) * 0.9
    : mix(vec3(0.16, 0.105, 0.07), vec3(0.33, 0.225, 0.15), 0.6 * bands + 0.4 * clouds(along * vec2(0.3, 1.5)));
  float low = smoothstep(0.0, 0.35, spot.y);
  colour = lit(colour, normal, 0.85, 0.45 + 0.45 * low);
  gl_FragColor = vec4(toneMapped(inAir(colour, distance(spot, cameraPosition))), 1.0);
  #include <colorspace_fragment>
}
`;

export const SURFACE_FRAGMENT = /* glsl */ `
precision highp float;
${FIELD}
${NOISE}
${LIGHT}
${MATERIAL}
${LINES}
uniform sampler2D relief;   // slopes to the east and north, open sky, sunlight
uniform sampler2D values;   // what colours the surface, in its own unit
uniform sampler2D map;      // colour map
uniform sampler2D overlay;  // shares of up to four layers
uniform sampler2D draped;   // a picture to compare with
uniform float opacity;      // of that picture
uniform vec2 limits;
uniform float natural;      // 1: as the material looks, 0: colours of the map
uniform float shaded;       // 1: colours of the map are shaded by the relief
uniform float bare;         // 1: show ground without cover apart
uniform float thickness;
uniform vec3 tints[4];
varying vec2 place;
varying float height;
varying vec3 spot;

float share(vec4 shares, int layer) {
  return layer == 0 ? shares.r : layer == 1 ? shares.g : layer == 2 ? shares.b : shares.a;
}

// How far loose material covers the ground; it does not lie on walls of rock.
vec2 coverAt(vec2 texel, vec4 here) {
  vec2 beside = 1.0 / cells;
  vec2 rise = vec2(
    texture2D(heights, texel + vec2(beside.x, 0.0)).g - texture2D(heights, texel - vec2(beside.x, 0.0)).g,
    texture2D(heights, texel + vec2(0.0, beside.y)).g - texture2D(heights, texel - vec2(0.0, beside.y)).g
  ) * cells / extent / 2.0;
  float steep = smoothstep(0.9, 1.6, length(rise));
  float covered = smoothstep(0.05, 0.7, (here.r - here.g) / thickness) * (1.0 - steep);
  return vec2(covered, smoothstep(0.25, 0.8, length(rise)));
}

vec3 asItLooks(vec4 form, vec2 slope, vec4 here, vec2 cover) {
  vec2 cell = place * (cells - 1.0);
  float pixel = length(fwidth(cell)) * 0.7071;
  vec3 colour = sandColour(cell, slope, pixel);
  vec2 small = fine > 0.5 ? rippled(cell, slope / exaggeration, pixel) * cover.x : vec2(0.0);
  if (bare > 0.5 && cover.x < 1.0) colour = mix(groundColour(cell, here.g / thickness * 0.3, cover.y, pixel), colour, cover.x);
  vec4 shares = texture2D(overlay, inTexture(place));
  for (int i = 0; i < 4; i++) {
    float grown = smoothstep(0.02, 0.6, share(shares, i)) * (0.55 + 0.45 * noise(cell * 1.7));
    colour = mix(colour, tints[i] * (0.75 + 0.5 * noise(cell * 3.1)), 0.72 * grown);
  }
  vec2 d = slope + small;
  vec3 normal = normalize(vec3(-d.x, 1.0, d.y));
  float open = mix(form.b, form.b * form.b, 0.6);
  return toneMapped(inAir(lit(colour, normal, form.a, open), distance(spot, cameraPosition)));
}

// Colours of data: never lighter than the scale says, and as they are where shading is off.
vec3 asData(vec4 form, vec2 slope, vec4 here, vec2 cover) {
  float value = (texture2D(values, inTexture(place)).r - limits.x) / max(limits.y - limits.x, 1e-9);
  vec3 colour = texture2D(map, vec2(clamp(value, 0.0, 1.0) * 63.0 / 64.0 + 0.5 / 64.0, 0.5)).rgb;
  colour = mix(colour / 12.92, pow((colour + 0.055) / 1.055, vec3(2.4)), step(0.04045, colour));
  if (bare > 0.5) colour = mix(vec3(0.28, 0.25, 0.23), colour, cover.x);
  vec4 shares = texture2D(overlay, inTexture(place));
  for (int i = 0; i < 4; i++) {
    float part = share(shares, i);
    float edge = 1.0 - smoothstep(0.6, 1.6, abs(part - 0.3) / max(fwidth(part), 1e-4));
    colour = mix(colour, tints[i] * 0.5, edge * step(0.02, max(part, fwidth(part))));
  }
  if (shaded < 0.5) return colour;
  vec3 normal = normalize(vec3(-slope.x, 1.0, slope.y));
  float direct = clamp(dot(normal, sun) / max(sun.y, 0.35), 0.0, 1.0) * form.a;
  return colour * (0.38 + 0.22 * form.b + 0.40 * direct);
}

void main() {
  vec4 here = texture2D(heights, inTexture(place));
  vec4 form = texture2D(relief, place);
  vec2 slope = form.xy * exaggeration;
  vec2 cover = coverAt(inTexture(place), here);
  vec3 colour = natural > 0.5 ? asItLooks(form, slope, here, cover) : asData(form, slope, here, cover);
  if (opacity > 0.0) {
    vec4 picture = texture2D(draped, place);
    colour = mix(colour, picture.rgb, opacity * picture.a);
  }
  gl_FragColor = vec4(lined(colour, here.r, place), 1.0);
  #include <colorspace_fragment>
}
`;
