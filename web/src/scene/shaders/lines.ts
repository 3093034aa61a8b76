/** Lines over the surface: contours, cells, edges of layers, the brush. */

export const LINES = /* glsl */ `
uniform float contour;      // metres from one contour to the next, 0: none
uniform float wire;
uniform vec3 brush;         // centre (0 to 1) and radius (m), radius 0: none

float line(float distance_, float width) {
  float w = fwidth(distance_) * width;
  return 1.0 - smoothstep(w * 0.5, w * 1.5, abs(distance_));
}

vec3 lined(vec3 colour, float height_, vec2 place) {
  if (contour > 0.0) {
    float at = height_ / contour;
    float edge = abs(fract(at - 0.5) - 0.5) / max(fwidth(at), 1e-6);
    colour = mix(colour, colour * 0.28, (1.0 - smoothstep(0.4, 1.3, edge)) * 0.85);
  }
  if (wire > 0.5) {
    vec2 grid = place * (cells - 1.0);
    vec2 edge = abs(fract(grid - 0.5) - 0.5) / max(fwidth(grid), vec2(1e-6));
    float fade = 1.0 - smoothstep(0.25, 0.7, max(fwidth(grid).x, fwidth(grid).y));
    colour = mix(colour, colour * 0.35, (1.0 - smoothstep(0.3, 1.2, min(edge.x, edge.y))) * 0.8 * fade);
  }
  if (brush.z > 0.0) {
    vec2 off = (place - brush.xy) * extent;
    float d = length(off) - brush.z;
    colour = mix(colour, vec3(1.0), 0.10 * step(d, 0.0) + 0.75 * line(d, 1.4));
  }
  return colour;
}
`;
