// SPDX-License-Identifier: MIT
#include "tests/viewer/reference_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include <glm/geometric.hpp>

#include "tests/reference/picture.h"
#include "tests/support/fixed_random.h"

namespace sinew::viewer {
namespace {

/// Smallest and greatest of the reference's values around the middle of a pixel.
struct PixelRange {
  glm::dvec4 lower{1e9}, upper{-1e9};
};

PixelRange range_at(const reference::PictureOf& picture, int x, int y) {
  constexpr double aside = 1.0 / 32.0;
  PixelRange range;
  for (const glm::dvec2 offset :
       {glm::dvec2(0.0), {aside, aside}, {-aside, aside}, {aside, -aside}, {-aside, -aside}}) {
    const glm::dvec4 color = reference::color_at(picture, x + 0.5 + offset.x, y + 0.5 + offset.y);
    range.lower = glm::min(range.lower, color);
    range.upper = glm::max(range.upper, color);
  }
  return range;
}

bool blurs_behind(const Material& material) {
  return material.transmission.factor > 0.0f && (material.roughness > 0.0f || material.volume.thickness_m > 0.0f);
}

std::string text_of(const glm::dvec4& v) { return testing::PrintToString(std::to_array<double>({v.x, v.y, v.z, v.w})); }

double greatest(const glm::dvec4& v) { return std::max({v.x, v.y, v.z, v.w}); }

}  // namespace

void expect_reference_picture(const BuiltScene& built, const View& view, const RenderOptions& options,
                              const PictureBounds& bounds, std::span<const double> visibility,
                              const Gradient& ambient) {
  const FloatPicture drawn = render_float(built, bounds.width, bounds.height, view, options);
  const FrameResult frame = built.frame();
  reference::PictureOf picture{built.scene, frame, view, options, bounds.width, bounds.height, ambient, visibility};
  std::optional<reference::Blurred> blurred;
  if (std::ranges::any_of(built.scene.materials, blurs_behind)) blurred = reference::blurred_opaque(picture);
  if (blurred) picture.blurred = &*blurred;
  int sharp = 0, wrong = 0;
  std::ostringstream first_wrong;
  double brightest = 0.0;
  for (int y = 0; y < bounds.height; ++y)
    for (int x = 0; x < bounds.width; ++x) {
      const PixelRange range = range_at(picture, x, y);
      const glm::dvec4 pixel(drawn.at(x, y));
      sharp += greatest(range.upper - range.lower) < 5.0 * bounds.bound;
      brightest = std::max({brightest, range.upper.x, range.upper.y, range.upper.z});
      const double off = std::max(greatest(range.lower - pixel), greatest(pixel - range.upper));
      if (off <= bounds.bound) continue;
      if (++wrong > 3) continue;  // no need to print all
      first_wrong << "\npixel " << x << " " << y << " is " << text_of(pixel) << ", the reference says "
                  << text_of(range.lower) << " to " << text_of(range.upper);
    }
  const int allowed = vertex_grid_px() > 0.0 ? 1 : 0;  // the thin triangles of a silhouette turn on the grid
  EXPECT_LE(wrong, allowed) << "pixels differ from the reference" << first_wrong.str();
  EXPECT_GE(sharp, bounds.sharp * bounds.width * bounds.height) << "too few pixels are compared closely";
  EXPECT_GT(brightest, 0.05) << "the picture shows nothing";
}

RenderOptions only_scene_lights() {
  RenderOptions options;
  options.ao.on = false;
  options.lighting.key = glm::vec3(0.0f);
  options.lighting.environment = nullptr;
  return options;
}

RenderOptions every_light() {
  RenderOptions options;
  options.ao.on = false;
  return options;
}

RenderOptions only_ambient_light() {
  RenderOptions options;
  options.ao.on = false;
  options.lighting.key = glm::vec3(0.0f);
  return options;
}

Primitive wall() {
  Primitive p = square(1.2f);
  for (glm::vec3& position : p.positions) position = {position.x, -position.z, 0.0f};
  p.normals.assign(4, {0.0f, 0.0f, 1.0f});
  p.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
  p.texcoords.emplace_back();
  for (const glm::vec2& uv : p.texcoords[0]) p.texcoords[1].push_back({0.15f + 0.55f * uv.y, 0.9f - 0.7f * uv.x});
  return p;
}

Material plain() {
  Material material = matte({0.7f, 0.6f, 0.5f});
  material.roughness = 0.7f;
  return material;
}

BuiltScene lit_wall(BuiltScene built, const Material& material, const Primitive& primitive,
                    const Affine& world_from_wall, bool mirrored) {
  built.add(primitive, built.add_material(material), world_from_wall, mirrored);
  add_light_at(built, {.kind = Light::Kind::point, .intensity = 1.2f}, {-0.2f, 0.35f, 0.6f}, {0, 0, -1});
  add_light_at(built, {.color = {0.5f, 0.6f, 1.0f}, .intensity = 0.8f}, {0, 0, 0}, {-0.7f, 0.3f, -0.6f});
  return built;
}

View view_of_wall() { return look_at({0.5, 0.3, 1.6}, {0.1, 0.0, 0.0}, 0.8, 0.05); }

std::uint32_t add_noise_texture(BuiltScene& built, const Sampler& sampler) {
  Image image;
  image.width = image.height = 8;
  test::FixedRandom random(7);
  for (int i = 0; i < 4 * 8 * 8; ++i) image.rgba.push_back(static_cast<std::uint8_t>(random.in(70.0, 256.0)));
  built.scene.images.push_back(image);
  built.scene.textures.push_back({static_cast<std::uint32_t>(built.scene.images.size() - 1), sampler});
  return static_cast<std::uint32_t>(built.scene.textures.size() - 1);
}

std::array<TextureUse, 4> placed_textures() {
  std::array<TextureUse, 4> uses;
  for (std::uint32_t i = 0; i < uses.size(); ++i) {
    uses[i].texcoord = i % 2;
    if (i < 2) continue;
    uses[i].offset = {0.13f, -0.21f};
    uses[i].rotation_rad = 0.6f;
    uses[i].scale = {1.4f, 0.5f};
  }
  return uses;
}

std::uint32_t add_plain_texture(BuiltScene& built, const std::array<std::uint8_t, 4>& rgba) {
  Image image;
  image.width = image.height = 1;
  image.rgba.assign(rgba.begin(), rgba.end());
  built.scene.images.push_back(image);
  built.scene.textures.push_back({static_cast<std::uint32_t>(built.scene.images.size() - 1), {}});
  return static_cast<std::uint32_t>(built.scene.textures.size() - 1);
}

void add_light_at(BuiltScene& built, const Light& light, const glm::vec3& position, const glm::vec3& direction) {
  const glm::vec3 back = -glm::normalize(direction);
  const glm::vec3 aside = std::abs(back.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(aside, back));
  built.add_light(light, affine_from(glm::mat3(right, glm::cross(back, right), back), position));
}

}  // namespace sinew::viewer
