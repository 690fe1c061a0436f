// SPDX-License-Identifier: MIT
#include "tests/study/study_scenes.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"

namespace sinew::viewer {
namespace {

/// Balls of `columns` x `rows` quads, a draw and a material each.
class Balls {
 public:
  Balls(std::uint32_t columns, std::uint32_t rows) : columns_(columns), rows_(rows) {}

  void add(const glm::vec3& centre, float radius) {
    const float hue = static_cast<float>(count_++);
    const glm::vec3 color = 0.5f + 0.3f * glm::vec3(std::sin(hue), std::sin(hue + 2.0f), std::sin(hue + 4.0f));
    const std::string name = "ball " + std::to_string(count_);
    builder_.add_prop(name, showcase::sphere(centre, radius, columns_, rows_),
                      builder_.add_material(name, color, 0.6f));
  }
  Scene finish() { return builder_.finish(); }

 private:
  showcase::SceneBuilder builder_;
  std::uint32_t columns_, rows_, count_ = 0;
};

/// Squares of black and white in three sizes, and colours that tell them apart.
Image pattern() {
  Image image;
  image.width = image.height = 256;
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const std::uint32_t side = x < 128 ? (y < 128 ? 4 : 16) : 32;
      const bool light = (x / side + y / side) % 2 == 0;
      image.rgba.insert(image.rgba.end(),
                        {static_cast<std::uint8_t>(light ? 235 : 20), static_cast<std::uint8_t>(light ? 230 : x / 4),
                         static_cast<std::uint8_t>(light ? 210 : y / 2), 255});
    }
  return image;
}

}  // namespace

Scene sheet_of_balls(std::uint32_t draws) {
  Balls balls(16, 8);
  const auto wide = static_cast<std::uint32_t>(std::ceil(std::sqrt(16.0 / 9.0 * draws)));
  for (std::uint32_t i = 0; i < draws; ++i)
    balls.add({static_cast<float>(i % wide), static_cast<float>(i / wide), 0.0f}, 0.48f);
  return balls.finish();
}

Scene doll_of_balls() {
  Balls balls(48, 24);
  balls.add({0.0f, 1.62f, 0.0f}, 0.13f);
  balls.add({0.0f, 1.46f, 0.0f}, 0.06f);
  for (const float y : {1.28f, 1.12f, 0.96f}) balls.add({0.0f, y, 0.0f}, 0.16f);
  for (const float side : {-1.0f, 1.0f}) {
    for (const float y : {0.78f, 0.60f, 0.40f, 0.18f}) balls.add({0.1f * side, y, 0.0f}, 0.11f);
    for (const float x : {0.24f, 0.42f, 0.60f}) balls.add({x * side, 1.34f, 0.0f}, 0.09f);
  }
  return balls.finish();
}

Scene fine_ball() {
  Balls balls(256, 196);
  balls.add({0.0f, 0.0f, 0.0f}, 1.0f);
  return balls.finish();
}

Scene patterned_plane(bool turned) {
  constexpr float kHalf = 40.0f;
  showcase::SceneBuilder builder;
  Primitive p;
  p.positions = {{-kHalf, 0, -kHalf}, {-kHalf, 0, kHalf}, {kHalf, 0, kHalf}, {kHalf, 0, -kHalf}};
  p.normals.assign(4, {0.0f, 1.0f, 0.0f});
  p.texcoords = {{{0, 0}, {0, kHalf}, {kHalf, kHalf}, {kHalf, 0}}};
  p.indices = {0, 1, 2, 0, 2, 3};
  Material material;
  material.unlit = true;
  material.base_color_texture.texture = builder.add_texture(pattern(), {});
  if (turned) material.base_color_texture.rotation_rad = 0.25f * std::numbers::pi_v<float>;
  builder.add_prop("plane", std::move(p), builder.add_material(std::move(material)));
  return builder.finish();
}

Scene sphere_with_tangents(bool mapped) {
  showcase::SceneBuilder builder;
  Primitive p = showcase::sphere({0, 0, 0}, 1.0f, 48, 24);
  p.texcoords = {std::vector<glm::vec2>(p.positions.size(), glm::vec2(0.5f))};
  for (const glm::vec3& n : p.normals) {
    const glm::vec3 along = glm::cross(glm::vec3(0, 1, 0), n);
    const float length = glm::length(along);
    p.tangents.emplace_back(length > 0.0f ? along / length : glm::vec3(1, 0, 0), 1.0f);
  }
  Image lean;
  lean.width = lean.height = 1;
  lean.rgba = {150, 110, 240, 255};
  Material material;
  material.roughness = 0.6f;
  material.metallic = 0.0f;
  if (mapped) material.normal_texture.texture = builder.add_texture(std::move(lean), {});
  builder.add_prop("sphere", std::move(p), builder.add_material(std::move(material)));
  return builder.finish();
}

Still::Still(Scene made) : scene(std::move(made)), plan(compile_plan(scene, {})), buffer(plan) {
  if (run_plan(plan, {}, buffer) != ErrorCode::ok) throw std::runtime_error("the frame cannot be evaluated");
  bounds = clip_extent(scene, kNone);
}

}  // namespace sinew::viewer
