// SPDX-License-Identifier: MIT
#include "viewer/app/inspect/paint.h"

#include <algorithm>
#include <array>

#include "viewer/app/inspect/pick.h"

namespace sinew::viewer {
namespace {

Material white(bool double_sided) {
  Material material;
  material.metallic = 0.0f;
  material.double_sided = double_sided;
  return material;
}

/// The scene with white, rough materials. All primitives have one.
Scene white_scene(const Scene& scene) {
  Scene made = scene;
  made.properties = {};
  for (Material& material : made.materials) material = white(material.double_sided);
  const auto plain = static_cast<std::uint32_t>(made.materials.size());
  made.materials.push_back(white(false));
  for (Mesh& mesh : made.meshes)
    for (Primitive& primitive : mesh.primitives)
      if (primitive.material == kNone) primitive.material = plain;
  return made;
}

/// Squares in two greys; red grows along u and green along v, so that mirrored and turned parts are seen.
Image checkered() {
  constexpr std::uint32_t kSide = 512, kSquare = 32;
  Image image;
  image.name = "checkered";
  image.width = image.height = kSide;
  image.rgba.reserve(std::size_t{4} * kSide * kSide);
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const std::uint32_t grey = (x / kSquare + y / kSquare) % 2 ? 190 : 90;
      for (const std::uint32_t part : {grey / 2 + 96 * x / kSide, grey / 2 + 96 * y / kSide, grey, 255u})
        image.rgba.push_back(static_cast<std::uint8_t>(part));
    }
  return image;
}

Scene checkered_scene(const Scene& scene) {
  Scene made = white_scene(scene);
  for (Mesh& mesh : made.meshes)
    for (Primitive& primitive : mesh.primitives) primitive.colors.clear();
  const auto image = static_cast<std::uint32_t>(made.images.size());
  made.images.push_back(checkered());
  made.textures.push_back({image, {}});
  for (Material& material : made.materials)
    material.base_color_texture.texture = static_cast<std::uint32_t>(made.textures.size() - 1);
  return made;
}

}  // namespace

glm::vec3 share_color(double share) noexcept {
  static constexpr std::array<glm::vec3, 5> kRamp = {{{0.02f, 0.03f, 0.25f},
                                                      {0.02f, 0.25f, 0.45f},
                                                      {0.05f, 0.55f, 0.15f},
                                                      {0.85f, 0.70f, 0.05f},
                                                      {0.90f, 0.05f, 0.02f}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kRamp.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(at), kRamp.size() - 2);
  const auto share_of_next = static_cast<float>(at - static_cast<double>(before));
  return kRamp[before] * (1.0f - share_of_next) + kRamp[before + 1] * share_of_next;
}

Scene painted_by_shares(const Scene& scene, const std::vector<std::vector<std::vector<float>>>& shares) {
  Scene made = white_scene(scene);
  for (std::size_t m = 0; m < made.meshes.size(); ++m)
    for (std::size_t p = 0; p < made.meshes[m].primitives.size(); ++p) {
      std::vector<glm::vec4>& colors = made.meshes[m].primitives[p].colors;
      colors.clear();
      for (const float share : shares[m][p]) colors.emplace_back(share_color(static_cast<double>(share)), 1.0f);
    }
  return made;
}

Scene painted(const Scene& scene, Paint paint, std::uint32_t joint) {
  if (paint == Paint::materials) return scene;
  if (paint == Paint::uv) return checkered_scene(scene);
  std::vector<std::vector<std::vector<float>>> shares(scene.meshes.size());
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    for (const Primitive& primitive : scene.meshes[m].primitives) shares[m].emplace_back(primitive.vertex_count());
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    auto& of_mesh = shares[scene.instances[i].mesh];
    for (std::uint32_t p = 0; p < of_mesh.size(); ++p)
      for (std::uint32_t v = 0; v < of_mesh[p].size(); ++v)
        for (const Influence& influence : influences_of(scene, {i, p, v}))
          if (influence.joint == joint) of_mesh[p][v] = std::max(of_mesh[p][v], influence.weight);
  }
  return painted_by_shares(scene, shares);
}

}  // namespace sinew::viewer
