// SPDX-License-Identifier: MIT
// Where the lights that cast shadows reach.

layout(constant_id = 17) const int kShadowLights = 0;    // bit i is set: light i casts shadows

const float kOffsetTexels = 2.0;   // along the normal: a surface must not shadow itself, nor its filtered neighbours

// Sum of the weights of 2 x 2 texels that a point of this depth is not behind.
// in   corner  between the texels, in [0, 1];   columns, rows  weights
float lit_texels(vec2 corner, float depth, vec2 columns, vec2 rows) {
  vec4 lit = vec4(lessThanEqual(textureGather(shadow_image, corner), vec4(depth)));
  return dot(lit, vec4(columns.x * rows.y, columns.y * rows.y, columns.y * rows.x, columns.x * rows.x));
}

bool casts_shadows(int light) { return (kShadowLights >> light & 1) != 0; }

// Share of a light that arrives at a point: the mean of 3 x 3 texels that moves evenly between texels.
// in   light  casts shadows;   p, n, to_light  view space; n on the seen side
float light_share(int light, vec3 p, vec3 n, vec3 to_light) {
  int maps = bitCount(kShadowLights), columns = maps > 1 ? 2 : 1;
  int index = bitCount(kShadowLights & ((1 << light) - 1));
  vec4 rows[4] = frame.shadow_maps[index].from_view;
  float grazing = sqrt(max(0.0, 1.0 - dot(n, to_light) * dot(n, to_light)));
  float texel_m = frame.shadow_maps[index].texel_m * dot(rows[3], vec4(p, 1.0));
  vec4 from = vec4(p + n * (texel_m * (0.5 + kOffsetTexels * grazing)), 1.0);
  float w = max(dot(rows[3], from), 1e-9);   // less is behind a spot light, where none arrives
  vec2 map = vec2(dot(rows[0], from), dot(rows[1], from)) / w;
  float depth = max(dot(rows[2], from) / w, 0.0);   // larger = nearer to the light; 0 = behind all casters
  vec2 tiles = vec2(columns, maps > 2 ? 2 : 1), tile = vec2(index % columns, index / columns);
  vec2 size = vec2(textureSize(shadow_image, 0)) / tiles;
  vec2 at = clamp((map * 0.5 + 0.5) * size - 1.5, vec2(0.0), size - 4.0);   // of the upper left of the 4 x 4 texels
  vec2 first = floor(at), part = at - first, corner = (tile + (first + 1.0) / size) / tiles;
  vec2 two = 2.0 / (size * tiles), before = 1.0 - part;
  float sum = lit_texels(corner, depth, vec2(before.x, 1.0), vec2(before.y, 1.0)) +
              lit_texels(corner + vec2(two.x, 0.0), depth, vec2(1.0, part.x), vec2(before.y, 1.0)) +
              lit_texels(corner + vec2(0.0, two.y), depth, vec2(before.x, 1.0), vec2(1.0, part.y)) +
              lit_texels(corner + two, depth, vec2(1.0, part.x), vec2(1.0, part.y));
  bool beside = any(greaterThan(abs(map), vec2(1.0)));   // of a cone wider than the map
  return mix(sum / 9.0, 1.0, beside);
}
