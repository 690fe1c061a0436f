// SPDX-License-Identifier: MIT
// Filtered shadow map lookups.

layout(constant_id = 17) const int kShadowLights = 0;    // bit i set = light i casts shadows

const float kOffsetTexels = 2.0;   // offset along the normal, against self-shadowing within the filter

// Sum of the weights of those of 2 x 2 texels that do not shadow a point of this depth.
// in   corner  corner shared by the texels, in [0, 1];   columns, rows  filter weights
float lit_texels(vec2 corner, float depth, vec2 columns, vec2 rows) {
  vec4 lit = vec4(lessThanEqual(textureGather(shadow_image, corner), vec4(depth)));
  return dot(lit, vec4(columns.x * rows.y, columns.y * rows.y, columns.y * rows.x, columns.x * rows.x));
}

bool casts_shadows(int light) { return (kShadowLights >> light & 1) != 0; }

// Fraction of a light that arrives at a point: a 3 x 3 texel box filter with bilinear edges.
// in   light  index of a light that casts shadows;   p, n, to_light  view space; n on the visible side
float light_share(int light, vec3 p, vec3 n, vec3 to_light) {
  int maps = bitCount(kShadowLights), columns = maps > 1 ? 2 : 1;
  int index = bitCount(kShadowLights & ((1 << light) - 1));
  vec4 rows[4] = frame.shadow_maps[index].from_view;
  float grazing = sqrt(max(0.0, 1.0 - dot(n, to_light) * dot(n, to_light)));
  float texel_m = frame.shadow_maps[index].texel_m * dot(rows[3], vec4(p, 1.0));
  vec4 from = vec4(p + n * (texel_m * (0.5 + kOffsetTexels * grazing)), 1.0);
  float w = max(dot(rows[3], from), 1e-9);   // w <= 0 is behind a spot light, where no light arrives
  vec2 map = vec2(dot(rows[0], from), dot(rows[1], from)) / w;
  float depth = max(dot(rows[2], from) / w, 0.0);   // larger = nearer to the light; 0 = beyond the far end
  vec2 tiles = vec2(columns, maps > 2 ? 2 : 1), tile = vec2(index % columns, index / columns);
  vec2 size = vec2(textureSize(shadow_image, 0)) / tiles;
  vec2 at = clamp((map * 0.5 + 0.5) * size - 1.5, vec2(0.0), size - 4.0);   // upper left of the 4 x 4 texels
  vec2 first = floor(at), part = at - first, corner = (tile + (first + 1.0) / size) / tiles;
  vec2 two = 2.0 / (size * tiles), before = 1.0 - part;
  float sum = lit_texels(corner, depth, vec2(before.x, 1.0), vec2(before.y, 1.0)) +
              lit_texels(corner + vec2(two.x, 0.0), depth, vec2(1.0, part.x), vec2(before.y, 1.0)) +
              lit_texels(corner + vec2(0.0, two.y), depth, vec2(before.x, 1.0), vec2(1.0, part.y)) +
              lit_texels(corner + two, depth, vec2(1.0, part.x), vec2(1.0, part.y));
  bool beside = any(greaterThan(abs(map), vec2(1.0)));   // outside the map: the light cone is wider than it
  return mix(sum / 9.0, 1.0, beside);
}
