/** Colours of sand, snow, rock and bare ground, and the forms that are finer than a cell. */

export const MATERIAL = /* glsl */ `
uniform vec3 loose;         // the material that the model moves, light and dark
uniform vec3 looseDark;
uniform float fine;         // 1: grains and small ripples are drawn near by
uniform float ripples;      // 1: the wind may draw ripples that are smaller than a cell
uniform vec2 blowing;       // where the wind blows to: east, north

// Small ripples across the wind; their slope (to the east and north), none where they would be too small to see.
vec2 rippled(vec2 cell, vec2 slope, float pixel) {
  const float LENGTH = 0.62;
  float seen = 1.0 - smoothstep(0.10, 0.30, pixel / LENGTH);
  float windward = smoothstep(-0.32, -0.10, dot(slope, blowing)) * (1.0 - smoothstep(0.5, 0.8, length(slope)));
  if (ripples * seen * windward <= 0.0) return vec2(0.0);
  vec2 aside = vec2(-blowing.y, blowing.x);
  vec2 q = vec2(dot(cell, blowing), dot(cell, aside));
  float bend = 2.2 * noise(vec2(q.x * 0.16, q.y * 0.09)) + 0.8 * noise(q * vec2(0.5, 0.21));
  float phase = 6.2831853 * (q.x / LENGTH + bend);
  float strength = 0.5 + 0.5 * noise(q * vec2(0.11, 0.06) + 40.0);
  return blowing * (0.16 * strength * seen * windward * (cos(phase) + 0.35 * sin(2.0 * phase)));
}

vec3 sandColour(vec2 cell, vec2 slope, float pixel) {
  float patches = clouds(cell * 0.035);
  float streaks = noise(vec2(dot(cell, blowing) * 0.05, dot(cell, vec2(-blowing.y, blowing.x)) * 0.35));
  vec3 colour = mix(looseDark, loose, clamp(0.30 + 0.75 * patches + 0.22 * (streaks - 0.5), 0.0, 1.0));
  // Grains on a slip face are sorted and dry: paler. Coarse and dark ones stay on crests and in troughs.
  float slipping = smoothstep(0.30, 0.55, length(slope)) * smoothstep(0.0, -0.3, dot(slope, blowing));
  colour *= 1.0 + 0.07 * slipping;
  float grain = (hash(floor(cell * 23.0)) - 0.5) * (1.0 - smoothstep(0.02, 0.09, pixel));
  float coarse = (noise(cell * 5.0) - 0.5) * (1.0 - smoothstep(0.1, 0.5, pixel));
  return colour * (1.0 + fine * (0.16 * grain + 0.07 * coarse));
}

// Rock in layers where it is steep, stony ground where it is level.
vec3 groundColour(vec2 cell, float height_, float steep, float pixel) {
  float near = fine * (1.0 - smoothstep(0.3, 1.4, pixel));
  float layers = clouds(vec2(height_ * 2.1 + 0.8 * noise(cell * 0.2), noise(cell * 0.07) * 2.0));
  float weathered = clouds(cell * 0.45 + height_);
  vec3 rock = mix(vec3(0.135, 0.098, 0.075), vec3(0.335, 0.245, 0.175), 0.55 * layers + 0.45 * weathered);
  vec3 stony = mix(vec3(0.235, 0.19, 0.15), vec3(0.36, 0.295, 0.225), clouds(cell * 0.09));
  float stones = smoothstep(0.62, 0.86, noise(cell * 2.6)) - 0.8 * smoothstep(0.7, 0.9, noise(cell * 3.4 + 9.0));
  stony *= 1.0 - 0.32 * near * stones + 0.10 * fine * (noise(cell * 1.1) - 0.5);
  return mix(stony, rock * (1.0 + 0.25 * near * (noise(cell * 2.0 + height_ * 6.0) - 0.5)), steep);
}
`;
