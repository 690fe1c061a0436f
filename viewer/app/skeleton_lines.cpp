// SPDX-License-Identifier: MIT
#include "viewer/app/skeleton_lines.h"

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

constexpr float kAxisPerDiagonal = 0.012f;
constexpr std::uint32_t kParentEnd = 0xff6b4a2au, kJointEnd = 0xff5fd7ffu;            // dark blue to yellow
constexpr std::uint32_t kAxisColors[3] = {0xff4040ffu, 0xff40d040u, 0xffff8040u};     // x red, y green, z blue

// Joints of the skins, and every joint on the way from one of them up to another.
std::vector<bool> skin_joints(const Scene& scene) {
  const auto& parents = scene.skeleton.parents;
  std::vector<bool> named(parents.size(), false);
  for (const auto& skin : scene.skins)
    for (const auto joint : skin.joints) named[joint] = true;
  // Parents come first, so one pass down finds the joints below a named one and one pass up those above.
  std::vector<bool> below = named, above = named;
  for (std::size_t j = 0; j < parents.size(); ++j)
    if (parents[j] != kNone && below[parents[j]]) below[j] = true;
  for (std::size_t j = parents.size(); j-- > 0;)
    if (parents[j] != kNone && above[j]) above[parents[j]] = true;
  for (std::size_t j = 0; j < parents.size(); ++j) named[j] = below[j] && above[j];
  return named;
}

}  // namespace

SkeletonLines::SkeletonLines(const Scene& scene) {
  const auto& parents = scene.skeleton.parents;
  const auto shown = scene.skins.empty() ? std::vector<bool>(parents.size(), true) : skin_joints(scene);
  for (std::uint32_t j = 0; j < parents.size(); ++j) {
    if (!shown[j]) continue;
    joints_.push_back(j);
    if (parents[j] != kNone && shown[parents[j]]) bones_.push_back({parents[j], j});
  }
  lines_.reserve(2 * bones_.size() + 6 * joints_.size());
}

std::span<const LineVertex> SkeletonLines::make(std::span<const Affine> model, float axis_m) {
  lines_.clear();
  for (const auto [parent, joint] : bones_) {
    lines_.push_back({translation_of(model[parent]), kParentEnd});
    lines_.push_back({translation_of(model[joint]), kJointEnd});
  }
  for (const auto joint : joints_) {
    const glm::vec3 at = translation_of(model[joint]);
    const auto& m = model[joint];
    for (int axis = 0; axis < 3; ++axis) {
      const glm::vec3 direction(m.row[0][axis], m.row[1][axis], m.row[2][axis]);
      const float length = glm::length(direction);
      if (length <= 0.0f) continue;   // scaled away
      lines_.push_back({at, kAxisColors[axis]});
      lines_.push_back({at + direction * (axis_m / length), kAxisColors[axis]});
    }
  }
  return lines_;
}

float SkeletonLines::axis_length_m(const Aabb& shown) noexcept {
  return kAxisPerDiagonal * (shown.empty() ? 1.0f : glm::length(shown.upper - shown.lower));
}

Aabb bounds_of_joints(std::span<const Affine> model) noexcept {
  Aabb box;
  for (const auto& m : model) box.add(translation_of(m));
  return box;
}

}  // namespace sinew::viewer
