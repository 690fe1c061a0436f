// SPDX-License-Identifier: MIT
// Reads textures through their samplers or, if RIP_MAPS is defined, texel by texel from rip maps
// (viewer/upload/rip_map.h). Rip maps are a shader variant, because their code would dominate every shader that reads
// textures. Derivatives need neighbours in a 2 x 2 pixel quad: call these in control flow that is uniform over a draw.

#ifdef RIP_MAPS

layout(constant_id = 36) const uint kWraps = 0;   // MaterialFeatures::wraps

// Wraps texel index i to [0, n); i may be out of range by one.
// in   wrap  enum Wrap: 0 repeat, 1 clamp to edge, 2 mirrored repeat
int wrapped_texel(int i, int n, uint wrap) { return wrap == 0 ? (i + n) % n : clamp(i, 0, n - 1); }

// Wraps a texture coordinate to [0, 1].
float wrapped_coordinate(float u, uint wrap) {
  if (wrap == 0) return fract(u);
  if (wrap == 1) return clamp(u, 0.0, 1.0);
  return 1.0 - abs(1.0 - 2.0 * fract(0.5 * u));
}

// Bilinear lookup in one level.
// in   size  of level (0, 0);   uv  in [0, 1];   wraps  wrap mode of u in the lower two bits, of v above
vec4 rip_level_texel(sampler2D image, ivec2 size, ivec2 level, vec2 uv, uint wraps) {
  ivec2 extent = size >> level, corner = 2 * (size - extent);
  vec2 at = uv * vec2(extent) - 0.5, part = fract(at);
  ivec2 low = ivec2(floor(at));
  ivec2 a = ivec2(wrapped_texel(low.x, extent.x, wraps & 3), wrapped_texel(low.y, extent.y, wraps >> 2));
  ivec2 b = ivec2(wrapped_texel(low.x + 1, extent.x, wraps & 3), wrapped_texel(low.y + 1, extent.y, wraps >> 2));
  vec4 upper = mix(texelFetch(image, corner + a, 0), texelFetch(image, corner + ivec2(b.x, a.y), 0), part.x);
  vec4 lower = mix(texelFetch(image, corner + ivec2(a.x, b.y), 0), texelFetch(image, corner + b, 0), part.x);
  return mix(upper, lower, part.y);
}

// Levels along u and v, each from the footprint along that axis.
// eq   level = log2(texels * |(du/dx, du/dy)|), clamped to existing levels; likewise for v
vec2 rip_level(ivec2 size, vec2 uv) {
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec2 squared = vec2(size) * vec2(size) * (dx * dx + dy * dy);   // squared texels per pixel
  return clamp(0.5 * log2(max(squared, vec2(1.0))), vec2(0.0), vec2(findMSB(size)));
}

// eq   linear in both levels: four levels, weighted by the fractions
vec4 rip_map_texel(sampler2D image, vec2 uv, uint wraps) {
  ivec2 size = textureSize(image, 0) / 2;
  vec2 level = rip_level(size, uv), part = fract(level);
  ivec2 fine = ivec2(level), coarse = min(fine + 1, findMSB(size));
  vec2 at = vec2(wrapped_coordinate(uv.x, wraps & 3), wrapped_coordinate(uv.y, wraps >> 2));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    bvec2 upper = bvec2((i & 1) != 0, (i & 2) != 0);
    vec2 share = mix(1.0 - part, part, upper);
    sum += share.x * share.y * rip_level_texel(image, size, mix(fine, coarse, upper), at, wraps);
  }
  return sum;
}

// in   place  descriptor place of the texture, for its wrap modes
vec4 filtered_texel(sampler2D image, int place, vec2 uv) {
  return rip_map_texel(image, uv, (kWraps >> (4 * place)) & 15);
}

// Levels that filtered_texel reads, along u and v.
vec2 read_level(sampler2D image, vec2 uv) { return rip_level(textureSize(image, 0) / 2, uv); }

#else

vec4 filtered_texel(sampler2D image, int place, vec2 uv) { return texture(image, uv); }

vec2 read_level(sampler2D image, vec2 uv) { return vec2(textureQueryLod(image, uv).x); }

#endif
