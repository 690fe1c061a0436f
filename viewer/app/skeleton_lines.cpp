// SPDX-License-Identifier: MIT
#include "viewer/app/skeleton_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

constexpr float kAxisPerDiagonal = 0.012f;
// Without meshes: the fewer joints, the longer their axes.
constexpr float kLeastLoneAxis = 0.05f, kMostLoneAxis = 0.3f;
constexpr std::uint32_t kBoneColor = 0xff5fd7ffu;                                  // yellow
constexpr float kRingAt = 0.15f, kRingRadius = 0.06f;                              // relative to the length of the bone
constexpr std::uint32_t kAxisColors[3] = {0xff4040ffu, 0xff40d040u, 0xffff8040u};  // x red, y green, z blue

// Adds the outline of an elongated octahedron, thick near the parent and pointed at the joint, so that the direction is
// visible.
void add_bone(std::vector<LineVertex>& lines, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 along = to - from;
  const float length = glm::length(along);
  if (length <= 0.0f) return;
  const glm::vec3 aside = std::abs(along.y) < 0.9f * length ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 u = glm::normalize(glm::cross(along, aside)) * (kRingRadius * length);
  const glm::vec3 v = glm::cross(along, u) / length;
  const glm::vec3 middle = from + kRingAt * along;
  const glm::vec3 ring[4] = {middle + u, middle + v, middle - u, middle - v};
  for (int i = 0; i < 4; ++i)
    for (const auto& [a, b] :
         {std::pair(from, ring[i]), std::pair(ring[i], to), std::pair(ring[i], ring[(i + 1) % 4])}) {
      lines.push_back({a, kBoneColor});
      lines.push_back({b, kBoneColor});
    }
}

// True for the joints of skins and for every joint between two of them.
std::vector<bool> skin_joints(const Scene& scene) {
  const auto& parents = scene.skeleton.parents;
  std::vector<bool> named(parents.size(), false);
  for (const auto& skin : scene.skins)
    for (const auto joint : skin.joints) named[joint] = true;
  // Parents come before children: a forward pass finds the joints below a skin joint, a backward pass those above.
  std::vector<bool> below = named, above = named;
  for (std::size_t j = 0; j < parents.size(); ++j)
    if (parents[j] != kNone && below[parents[j]]) below[j] = true;
  for (std::size_t j = parents.size(); j-- > 0;)
    if (parents[j] != kNone && above[j]) above[parents[j]] = true;
  for (std::size_t j = 0; j < parents.size(); ++j) named[j] = below[j] && above[j];
  return named;
}

// True for joints with a parent or a child; for all joints if none has.
std::vector<bool> chained_joints(const Scene& scene) {
  const auto& parents = scene.skeleton.parents;
  std::vector<bool> chained(parents.size(), false);
  for (std::size_t j = 0; j < parents.size(); ++j)
    if (parents[j] != kNone) chained[j] = chained[parents[j]] = true;
  const bool none = std::find(chained.begin(), chained.end(), true) == chained.end();
  return none ? std::vector<bool>(parents.size(), true) : chained;
}

}  // namespace

std::vector<bool> joints_of_skeleton(const Scene& scene) {
  return scene.skins.empty() ? chained_joints(scene) : skin_joints(scene);
}

SkeletonLines::SkeletonLines(const Scene& scene) : alone_(scene.instances.empty()) {
  const auto& parents = scene.skeleton.parents;
  const auto shown = joints_of_skeleton(scene);
  for (std::uint32_t j = 0; j < parents.size(); ++j) {
    if (!shown[j]) continue;
    joints_.push_back(j);
    if (parents[j] != kNone && shown[parents[j]]) bones_.push_back({parents[j], j});
  }
}

std::span<const LineVertex> SkeletonLines::make(std::span<const Affine> model, float axis_m) {
  lines_.clear();
  lines_.reserve(kVerticesPerBone * bones_.size() + 6 * joints_.size());
  for (const auto [parent, joint] : bones_)
    add_bone(lines_, translation_of(model[parent]), translation_of(model[joint]));
  for (const auto joint : joints_) {
    const auto axes = axes_of(model[joint], axis_m);
    for (std::size_t end = 1; end < axes.size(); end += 2)
      if (axes[end].position != axes[end - 1].position) lines_.insert(lines_.end(), {axes[end - 1], axes[end]});
  }
  return lines_;
}

std::array<LineVertex, 6> SkeletonLines::axes_of(const Affine& joint, float axis_m) noexcept {
  std::array<LineVertex, 6> axes;
  const glm::vec3 at = translation_of(joint);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto column = static_cast<int>(axis);
    const glm::vec3 direction(joint.row[0][column], joint.row[1][column], joint.row[2][column]);
    const float length = glm::length(direction);
    axes[2 * axis] = {at, kAxisColors[axis]};
    axes[2 * axis + 1] = {length > 0.0f ? at + direction * (axis_m / length) : at, kAxisColors[axis]};
  }
  return axes;
}

float SkeletonLines::axis_length_m(const Aabb& shown) const noexcept {
  const auto count = static_cast<float>(std::max<std::size_t>(joints_.size(), 1));
  const float lone = std::max(kLeastLoneAxis, kMostLoneAxis / std::sqrt(count));
  return (alone_ ? lone : kAxisPerDiagonal) * (shown.empty() ? 1.0f : glm::length(shown.upper - shown.lower));
}

std::vector<glm::vec3> places_of(const std::vector<bool>& joints, std::span<const Affine> model) {
  std::vector<glm::vec3> places;
  for (std::size_t j = 0; j < model.size(); ++j)
    if (joints[j]) places.push_back(translation_of(model[j]));
  return places;
}

}  // namespace sinew::viewer
