// SPDX-License-Identifier: MIT
// The view through a rough transmissive surface: a mip level of the opaque picture, chosen by roughness. At roughness 1
// the blur is as wide as the picture is high. The distance of objects behind the surface is ignored. Through a volume
// one sees the place of the picture where the refracted ray leaves it.

// A mip level filtered with a cubic B-spline (four bilinear look-ups), so that single texels are not visible.
vec4 smooth_texel(sampler2D image, vec2 uv, int level) {
  vec2 size = vec2(textureSize(image, level)), p = uv * size - 0.5, f = fract(p), g = 1.0 - f;
  vec2 first = g * g * g / 6.0, last = f * f * f / 6.0;
  vec2 second = (4.0 - 6.0 * f * f + 3.0 * f * f * f) / 6.0, third = 1.0 - first - second - last;
  vec2 near = first + second, far = third + last;
  vec2 from = (floor(p) - 0.5 + second / near) / size, to = (floor(p) + 1.5 + last / far) / size;
  float at = float(level);
  return near.y * (near.x * textureLod(image, from, at) + far.x * textureLod(image, vec2(to.x, from.y), at)) +
         far.y * (near.x * textureLod(image, vec2(from.x, to.y), at) + far.x * textureLod(image, to, at));
}

vec2 place_in_picture(vec3 p) {
  vec4 clip = clip_from_view(p);
  return clip.xy / clip.w * 0.5 + 0.5;
}

vec4 frosted_texel(sampler2D image, Passed passed) {
  ivec2 size = textureSize(image, 0);
  int last = textureQueryLevels(image) - 1;
  float level = min(passed.frost * log2(float(size.y)), float(last));
  int below = int(level), above = min(below + 1, last);
  vec2 uv = kVolume ? place_in_picture(passed.exit) : gl_FragCoord.xy / vec2(size);
  vec4 exact = kVolume ? textureLod(image, uv, 0.0) : texelFetch(image, ivec2(gl_FragCoord.xy), 0);
  vec4 fine = below == 0 ? exact : smooth_texel(image, uv, below);
  return mix(fine, smooth_texel(image, uv, above), fract(level));
}

vec4 frosted_unlit(Passed passed) { return kUnlitImage ? frosted_texel(behind_unlit_image, passed) : vec4(0.0); }

// Blurred light and coverage. If the backdrop is an environment, it fills the part that is not covered.
vec4 frosted_light(Passed passed) {
  vec4 seen = frosted_texel(behind_image, passed);
  if (kThrough == kFrosted) return seen;
  float last = float(textureQueryLevels(environment_image) - 1);
  float level = max(passed.frost * last, kThrough == kFrostedBlurred ? kBlurredLevel : 0.0);
  vec3 direction = frame.environment_from_view * -towards_viewer(passed.exit);
  vec3 arriving_light = textureLod(environment_image, direction, level).rgb * frame.backdrop_intensity;
  return vec4(seen.rgb + (1.0 - seen.a) * arriving_light, 1.0);
}
