// SPDX-License-Identifier: MIT
#include "runtime/plan/scene_indices.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace sinew {
namespace {

bool are_below(std::span<const std::uint32_t> indices, std::size_t count) noexcept {
  return std::all_of(indices.begin(), indices.end(), [=](std::uint32_t i) { return i < count; });
}

bool is_none_or_below(std::uint32_t index, std::size_t count) noexcept { return index == kNone || index < count; }

bool is_valid(const Skeleton& skeleton) noexcept {
  const std::size_t joints = skeleton.joint_count();
  if (skeleton.rest.size() != joints || skeleton.fixed_matrix_of.size() != joints) return false;
  for (std::uint32_t j = 0; j < joints; ++j)
    if (!is_none_or_below(skeleton.parents[j], j) ||
        !is_none_or_below(skeleton.fixed_matrix_of[j], skeleton.fixed_matrices.size()))
      return false;
  return true;
}

bool is_valid(const Skin& skin, std::size_t joint_count) noexcept {
  return skin.inverse_bind.size() == skin.joints.size() && are_below(skin.joints, joint_count);
}

bool is_valid(const Primitive& primitive, const Scene& scene) noexcept {
  const auto& variants = primitive.variant_materials;
  return is_none_or_below(primitive.material, scene.materials.size()) &&
         are_below(primitive.indices, primitive.vertex_count()) &&
         std::all_of(variants.begin(), variants.end(),
                     [&](const VariantMaterial& v) { return is_none_or_below(v.material, scene.materials.size()); });
}

/// True if joints of the vertices are within the skin, and groups within the influences.
bool are_valid(const VertexInfluences& influences, std::size_t vertex_count, std::size_t joint_count) noexcept {
  if (influences.joints.size() != influences.weights.size()) return false;
  for (const InfluenceGroup& group : influences.groups) {
    const std::size_t entries = std::size_t{group.vertex_count} * group.influence_count;
    if (group.first_vertex + std::size_t{group.vertex_count} > vertex_count ||
        group.first_influence + entries > influences.joints.size())
      return false;
  }
  return std::all_of(influences.joints.begin(), influences.joints.end(), [=](auto j) { return j < joint_count; });
}

bool is_valid(const MeshInstance& instance, const Scene& scene) noexcept {
  if (instance.joint >= scene.skeleton.joint_count() || instance.mesh >= scene.meshes.size() ||
      !is_none_or_below(instance.skin, scene.skins.size()))
    return false;
  const auto& primitives = scene.meshes[instance.mesh].primitives;
  return instance.skin == kNone || std::all_of(primitives.begin(), primitives.end(), [&](const Primitive& p) {
           return are_valid(p.influences, p.vertex_count(), scene.skins[instance.skin].joints.size());
         });
}

bool is_valid(const PropertyTable& table, std::size_t joint_count) noexcept {
  return std::all_of(table.entries.begin(), table.entries.end(), [&](const PropertyTable::Entry& entry) {
    return entry.first < table.rest.size() &&
           (entry.target.kind != PropertyKind::node_visible || entry.target.index < joint_count);
  });
}

bool is_valid(const PoseCorrective& corrective, std::size_t joint_count) noexcept {
  const auto& drivers = corrective.samples.drivers;
  return std::all_of(drivers.begin(), drivers.end(),
                     [=](const PoseDriver& driver) { return driver.joint < joint_count; });
}

}  // namespace

bool has_valid_indices(const Scene& scene) noexcept {
  const std::size_t joints = scene.skeleton.joint_count();
  const auto all = [](const auto& list, const auto& is) { return std::all_of(list.begin(), list.end(), is); };
  const auto primitives_are_valid = [&](const Mesh& mesh) {
    return all(mesh.primitives, [&](const Primitive& p) { return is_valid(p, scene); });
  };
  return is_valid(scene.skeleton) && are_below(scene.hidden_joints, joints) &&
         (scene.first_weight.size() == scene.instances.size() + 1 || scene.instances.empty()) &&
         std::is_sorted(scene.first_weight.begin(), scene.first_weight.end()) && is_valid(scene.properties, joints) &&
         all(scene.skins, [=](const Skin& skin) { return is_valid(skin, joints); }) &&
         all(scene.correctives, [=](const PoseCorrective& c) { return is_valid(c, joints); }) &&
         all(scene.meshes, primitives_are_valid) &&
         all(scene.instances, [&](const MeshInstance& instance) { return is_valid(instance, scene); });
}

}  // namespace sinew
