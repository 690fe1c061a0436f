// SPDX-License-Identifier: MIT
#include "tests/reference/texture.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

#include "tests/reference/shade.h"

namespace sinew::reference {
namespace {

/// Index of the texel that an index outside the image repeats, mirrors or clamps to.
long wrapped(Wrap wrap, long i, long size) {
  const auto modulo = [](long a, long b) { return (a % b + b) % b; };
  if (wrap == Wrap::clamp_to_edge) return std::clamp(i, 0L, size - 1);
  if (wrap == Wrap::repeat) return modulo(i, size);
  const long period = modulo(i, 2 * size);
  return period < size ? period : 2 * size - 1 - period;
}

glm::dvec4 stored(const Image& image, const Sampler& sampler, long column, long row, bool srgb) {
  const long x = wrapped(sampler.wrap_u, column, static_cast<long>(image.width)),
             y = wrapped(sampler.wrap_v, row, static_cast<long>(image.height));
  glm::dvec4 value;
  for (int c = 0; c < 4; ++c) {
    value[c] = image.rgba[static_cast<std::size_t>(4 * (y * static_cast<long>(image.width) + x) + c)] / 255.0;
    if (srgb && c < 3) value[c] = srgb_decoded(value[c]);
  }
  return value;
}

}  // namespace

glm::dvec2 transformed(const TextureUse& use, const glm::dvec2& uv) {
  const double angle = static_cast<double>(use.rotation_rad), c = std::cos(angle), s = std::sin(angle);
  // Columns. Counter-clockwise in the image: (1, 0) turns to (c, -s), because v points down.
  const glm::dmat3 scale({use.scale.x, 0.0, 0.0}, {0.0, use.scale.y, 0.0}, {0.0, 0.0, 1.0});
  const glm::dmat3 rotation({c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0});
  const glm::dmat3 translation({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {use.offset.x, use.offset.y, 1.0});
  return glm::dvec2(translation * (rotation * (scale * glm::dvec3(uv, 1.0))));
}

glm::dvec4 texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, bool srgb) {
  const Texture& texture = scene.textures[use.texture];
  const Image& image = scene.images[texture.image];
  const double x = uv.x * image.width, y = uv.y * image.height;
  const auto at = [&](double column, double row) {
    return stored(image, texture.sampler, static_cast<long>(std::floor(column)), static_cast<long>(std::floor(row)),
                  srgb);
  };
  if (texture.sampler.magnify == Filter::nearest) return at(x, y);
  const double left = x - 0.5, top = y - 0.5, fx = left - std::floor(left), fy = top - std::floor(top);
  return (at(left, top) * (1.0 - fx) + at(left + 1.0, top) * fx) * (1.0 - fy) +
         (at(left, top + 1.0) * (1.0 - fx) + at(left + 1.0, top + 1.0) * fx) * fy;
}

namespace {

/// The last mip level of a side of `size` texels: one texel is left of it.
double last_level(std::uint32_t size) { return std::floor(std::log2(static_cast<double>(size))); }

/// Mean of the texels of the image that one texel of a level covers.
glm::dvec4 level_texel(const Image& image, const glm::ivec2& level, long x, long y, bool srgb) {
  const long columns = 1L << level.x, rows = 1L << level.y;
  glm::dvec4 sum(0.0);
  for (long row = y * rows; row < (y + 1) * rows; ++row)
    for (long column = x * columns; column < (x + 1) * columns; ++column)
      sum += stored(image, {.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge}, column, row, srgb);
  return sum / static_cast<double>(columns * rows);
}

glm::dvec4 level_at(const Scene& scene, const TextureUse& use, const glm::ivec2& level, const glm::dvec2& uv,
                    bool srgb) {
  const Texture& texture = scene.textures[use.texture];
  const Image& image = scene.images[texture.image];
  const long width = static_cast<long>(image.width) >> level.x, height = static_cast<long>(image.height) >> level.y;
  const double left = uv.x * static_cast<double>(width) - 0.5, top = uv.y * static_cast<double>(height) - 0.5;
  glm::dvec4 sum(0.0);
  for (int i = 0; i < 4; ++i) {
    const double column = std::floor(left) + i % 2, row = std::floor(top) + i / 2;
    const double share = (1.0 - std::abs(left - column)) * (1.0 - std::abs(top - row));
    sum += share * level_texel(image, level, wrapped(texture.sampler.wrap_u, static_cast<long>(column), width),
                               wrapped(texture.sampler.wrap_v, static_cast<long>(row), height), srgb);
  }
  return sum;
}

}  // namespace

double mip_level(const Scene& scene, const TextureUse& use, double texels) {
  const Image& image = scene.images[scene.textures[use.texture].image];
  return std::clamp(std::log2(std::max(texels, 1.0)), 0.0, last_level(std::max(image.width, image.height)));
}

glm::dvec4 mip_texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, double level, bool srgb) {
  const Image& image = scene.images[scene.textures[use.texture].image];
  const auto at = [&](double whole) {
    const glm::dvec2 along(std::min(whole, last_level(image.width)), std::min(whole, last_level(image.height)));
    return level_at(scene, use, glm::ivec2(along), uv, srgb);
  };
  const double whole = std::floor(level), part = level - whole;
  return part == 0.0 ? at(whole) : at(whole) * (1.0 - part) + at(whole + 1.0) * part;
}

glm::dvec4 covered_mean(std::span<const glm::dvec4> texels) {
  glm::dvec3 covered(0.0), all(0.0);
  double coverage = 0.0;
  for (const glm::dvec4& t : texels) {
    covered += glm::dvec3(t) * t.a;
    all += glm::dvec3(t);
    coverage += t.a;
  }
  const auto count = static_cast<double>(texels.size());
  return {coverage > 0.0 ? covered / coverage : all / count, coverage / count};
}

double kept_share(std::span<const std::uint8_t> rgba, int width, int height, double cutoff) {
  const auto alpha = [&](int x, int y) {
    const int at = std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1);
    return static_cast<double>(rgba[static_cast<std::size_t>(4 * at + 3)]);
  };
  int kept = 0;
  for (int j = 0; j < 2 * height; ++j)
    for (int i = 0; i < 2 * width; ++i) {
      const double x = 0.5 * i - 0.25, y = 0.5 * j - 0.25, fx = x - std::floor(x), fy = y - std::floor(y);
      const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
      kept += (1.0 - fy) * ((1.0 - fx) * alpha(left, top) + fx * alpha(left + 1, top)) +
                  fy * ((1.0 - fx) * alpha(left, top + 1) + fx * alpha(left + 1, top + 1)) >=
              cutoff;
    }
  return kept / (4.0 * width * height);
}

glm::dvec2 rip_levels(const Scene& scene, const TextureUse& use, const glm::dvec2& texels) {
  const Image& image = scene.images[scene.textures[use.texture].image];
  const auto level = [](double side, std::uint32_t size) {
    return std::clamp(std::log2(std::max(side, 1.0)), 0.0, last_level(size));
  };
  return {level(texels.x, image.width), level(texels.y, image.height)};
}

glm::dvec4 rip_texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, const glm::dvec2& texels,
                     bool srgb) {
  const glm::dvec2 level = rip_levels(scene, use, texels), part = level - glm::floor(level);
  glm::dvec4 sum(0.0);
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 step(i % 2, i / 2);
    const double share = (step.x == 1 ? part.x : 1.0 - part.x) * (step.y == 1 ? part.y : 1.0 - part.y);
    if (share > 0.0) sum += share * level_at(scene, use, glm::ivec2(level) + step, uv, srgb);
  }
  return sum;
}

}  // namespace sinew::reference
