// SPDX-License-Identifier: MIT
// Where the light that casts shadows reaches.

const float kOffsetTexels = 2.0;   // along the normal: a surface must not shadow itself, nor its filtered neighbours

// Share of the light that arrives at a point: the mean of 3 x 3 texels that moves evenly between texels.
// in   p, n, to_light  view space; n on the seen side
float light_share(vec3 p, vec3 n, vec3 to_light) {
  float grazing = sqrt(max(0.0, 1.0 - dot(n, to_light) * dot(n, to_light)));
  vec4 from = vec4(p + n * (frame.shadow_texel_m * (0.5 + kOffsetTexels * grazing)), 1.0);
  vec2 map = vec2(dot(frame.shadow_from_view[0], from), dot(frame.shadow_from_view[1], from));
  float depth = dot(frame.shadow_from_view[2], from);   // larger = nearer to the light
  ivec2 last = textureSize(shadow_image, 0) - 1;
  vec2 at = (map * 0.5 + 0.5) * vec2(last + 1) - 1.5;   // of the upper left of the 4 x 4 texels
  ivec2 first = ivec2(floor(at));
  vec2 part = at - vec2(first);
  float sum = 0.0;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      ivec2 texel = clamp(first + ivec2(x, y), ivec2(0), last);
      vec2 weight = vec2(x == 0 ? 1.0 - part.x : x == 3 ? part.x : 1.0, y == 0 ? 1.0 - part.y : y == 3 ? part.y : 1.0);
      sum += weight.x * weight.y * float(depth >= texelFetch(shadow_image, texel, 0).r);
    }
  return sum / 9.0;
}
