// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "samples/showcase/flag_cloth.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "samples/showcase/showcase.h"

namespace sinew::showcase {
namespace {

constexpr std::uint32_t kColumns = 61, kRows = 41;
constexpr double kSpacing_m = 0.04;
constexpr std::uint32_t kLoopFrames = 120, kWarmUpFrames = 120, kBlendFrames = 24;
constexpr glm::vec3 kTopAtPole{0.0f, 3.6f, 0.0f};

constexpr float kWidth_m = static_cast<float>(kSpacing_m * (kColumns - 1));
constexpr float kHeight_m = static_cast<float>(kSpacing_m * (kRows - 1));

/// Distance of a point from a line between two points.
float distance_to_line(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 ab = b - a;
  return glm::length(p - a - std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f) * ab);
}

/// The flag's picture: a bone as animation programs draw it, an octahedron between two joints.
/// in   p  metres from the upper corner at the pole, y down
glm::vec3 picture(const glm::vec2& p) {
  constexpr glm::vec3 kField{188.0f, 42.0f, 34.0f}, kLight{242.0f, 232.0f, 208.0f}, kShade{206.0f, 190.0f, 160.0f};
  constexpr glm::vec2 kHead{0.62f, 1.16f}, kTail{1.78f, 0.44f};
  // The octahedron is widest at this fraction of its length; half of its width there.
  constexpr float kWidest = 0.2f, kHalfWidth_m = 0.19f;
  const float hem = std::min(std::min(p.y, kHeight_m - p.y), kWidth_m - p.x);
  if (hem < 0.05f || (hem > 0.09f && hem < 0.11f)) return kLight;
  for (const auto& [joint, radius] : {std::pair(kHead, 0.15f), std::pair(kTail, 0.11f)})
    if (const float d = glm::length(p - joint); d < radius) return d < radius - 0.035f ? kLight : kField;
  const glm::vec2 along = glm::normalize(kTail - kHead), across(-along.y, along.x);
  const float u = glm::dot(p - kHead, along) / glm::length(kTail - kHead), v = glm::dot(p - kHead, across);
  const float half_width = kHalfWidth_m * (u < kWidest ? u / kWidest : (1.0f - u) / (1.0f - kWidest));
  if (u < 0.0f || u > 1.0f || std::abs(v) > half_width) return kField;
  if (distance_to_line(p, kHead, kTail) < 0.008f) return kField;  // the edge between the two faces
  return v < 0.0f ? kLight : kShade;
}

Image flag_image() {
  constexpr std::uint32_t kWide = 768, kHigh = 512, kSamples = 3;
  Image image{"flag", kWide, kHigh, {}, ""};
  image.rgba.reserve(std::size_t{4} * kWide * kHigh);
  for (std::uint32_t y = 0; y < kHigh; ++y)
    for (std::uint32_t x = 0; x < kWide; ++x) {
      glm::vec3 sum(0.0f);
      for (std::uint32_t s = 0; s < kSamples * kSamples; ++s) {
        const glm::vec2 at(kSamples * x + s % kSamples, kSamples * y + s / kSamples);
        sum += picture((at + 0.5f) / glm::vec2(kSamples * kWide, kSamples * kHigh) * glm::vec2(kWidth_m, kHeight_m));
      }
      sum /= static_cast<float>(kSamples * kSamples);
      for (int c = 0; c < 3; ++c) image.rgba.push_back(static_cast<std::uint8_t>(std::lround(sum[c])));
      image.rgba.push_back(255);
    }
  return image;
}

/// The flag as it lies on a table, with the vertices and triangles of the cloth.
Mesh flat_flag(std::uint32_t material) {
  Primitive flag;
  flag.material = material;
  flag.indices = fly_flag({.columns = kColumns, .rows = kRows, .pieces = 1, .frame_count = 0}).triangles;
  auto& texcoords = flag.texcoords.emplace_back();
  for (std::uint32_t r = 0; r < kRows; ++r)
    for (std::uint32_t c = 0; c < kColumns; ++c) {
      const float u = static_cast<float>(c) / (kColumns - 1), v = static_cast<float>(r) / (kRows - 1);
      flag.positions.push_back(kTopAtPole + glm::vec3(kWidth_m * u, -kHeight_m * v, 0.0f));
      flag.normals.emplace_back(0.0f, 0.0f, 1.0f);
      texcoords.emplace_back(u, v);
    }
  Mesh mesh;
  mesh.name = kFlagMesh;
  mesh.primitives.push_back(std::move(flag));
  return mesh;
}

void add_flag(SceneBuilder& builder) {
  Material cloth;
  cloth.name = "cloth";
  cloth.roughness = 0.85f;
  cloth.metallic = 0.0f;
  cloth.double_sided = true;
  cloth.base_color_texture.texture =
      builder.add_texture(flag_image(), {.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge});
  const std::uint32_t mesh = builder.add_mesh(flat_flag(builder.add_material(std::move(cloth))));
  builder.add_instance(builder.add_joint(kFlagMesh, kNone, {}), mesh);
}

void add_surroundings(SceneBuilder& builder) {
  const std::uint32_t ground = builder.add_material("ground", {0.34f, 0.38f, 0.27f}, 0.95f);
  const std::uint32_t stone = builder.add_material("stone", {0.60f, 0.58f, 0.54f}, 0.9f);
  const std::uint32_t paint = builder.add_material("paint", {0.85f, 0.85f, 0.82f}, 0.4f);
  const std::uint32_t gold = builder.add_material("gold", {0.90f, 0.66f, 0.25f}, 0.35f, 0.6f);
  const auto disc = [](float u, float v) {
    const float angle = 2.0f * std::numbers::pi_v<float> * u;
    return 2.6f * (1.0f - v) * glm::vec3(std::sin(angle), 0.0f, std::cos(angle));
  };
  builder.add_prop("ground", grid(disc, 64, 12), ground);
  Primitive steps = box({0.0f, 0.11f, 0.0f}, {0.75f, 0.11f, 0.75f});
  append(steps, box({0.0f, 0.32f, 0.0f}, {0.48f, 0.12f, 0.48f}));
  append(steps, lathe({0.0f, 0.4f, 0.0f}, 0.34f, [](float v) { return 0.26f - 0.12f * v * v; }));
  builder.add_prop("steps", std::move(steps), stone);
  builder.add_prop("pole",
                   lathe(
                       {0.0f, 0.6f, 0.0f}, 3.2f, [](float v) { return 0.05f - 0.015f * v; }, 24, 8),
                   paint);
  builder.add_prop("knob", sphere({0.0f, 3.85f, 0.0f}, 0.085f), gold);
}

}  // namespace

ClothFrames flag_flight() {
  const double once = 2.0 * std::numbers::pi * 30.0 / kLoopFrames;  // radians a second of one cycle per loop
  FlagOptions options{.columns = kColumns, .rows = kRows, .spacing_m = kSpacing_m, .pieces = 1};
  options.frame_count = kWarmUpFrames + kLoopFrames + 1;
  options.wind = {.speed = 11.0, .gust = once, .lift = once, .swing = 2.0 * once, .wave = 3.0 * once};
  ClothFrames flight = loop_of(fly_flag(options), kLoopFrames, kBlendFrames);
  for (auto& frame : flight.frames)
    for (glm::vec3& p : frame) p += kTopAtPole;
  return flight;
}

ShowcaseScene flag_in_wind(std::span<const std::byte> cache) {
  SceneBuilder builder;
  add_flag(builder);
  add_surroundings(builder);
  ShowcaseScene out;
  out.name = "flag in wind";
  out.what_to_look_at = "A simulated cloth from a geometry cache: every vertex moves by itself, without a skeleton.";
  out.scene = builder.finish();
  out.geometry_cache = cache;
  out.eye = {2.7f, 1.9f, 6.8f};
  out.target = {0.85f, 2.05f, 0.0f};
  out.fov_y_rad = 0.58f;
  return out;
}

}  // namespace sinew::showcase
