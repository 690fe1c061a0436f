// SPDX-License-Identifier: MIT
#include "runtime/model/mesh_checks.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

/// True if the weights of every vertex are not negative, never increase from one to the next, and sum to 1. Jobs rely
/// on it: they take the first joint as the heaviest, and never divide by the sum.
/// in   kCount  influences per vertex; 0 = use runtime_count
template <std::size_t kCount>
bool are_shares(std::span<const float> weights, std::size_t runtime_count) noexcept {
  constexpr float kTolerance = 1e-4f;  // weights are rounded to float one by one
  const std::size_t count = kCount > 0 ? kCount : runtime_count;
  bool good = true;
  for (const float* w = weights.data(); w != weights.data() + weights.size(); w += count) {
    float sum = w[0];
    for (std::size_t i = 1; i < count; ++i) {
      sum += w[i];
      good &= w[i] <= w[i - 1];
    }
    good &= w[count - 1] >= 0.0f;
    good &= std::abs(sum - 1.0f) <= kTolerance;
  }
  return good;
}

bool are_shares(std::span<const float> weights, std::uint32_t count) noexcept {
  switch (count) {
    case 1: return are_shares<1>(weights, count);
    case 2: return are_shares<2>(weights, count);
    case 3: return are_shares<3>(weights, count);
    case 4: return are_shares<4>(weights, count);
    default: return are_shares<0>(weights, count);
  }
}

/// The error code for weights that failed are_shares.
ErrorCode fault_of(std::span<const float> weights, std::uint32_t count) noexcept {
  if (!all_finite(weights)) return ErrorCode::not_finite;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] < 0.0f || (i % count != 0 && weights[i] > weights[i - 1])) return ErrorCode::unsupported;
  return ErrorCode::not_normalised;
}

/// Requires that groups cover all vertices and all influences in order.
void check_influences(const VertexInfluences& influences, std::size_t vertex_count, Findings& f) noexcept {
  f.require_size(influences.weights.size(), influences.joints.size());
  if (influences.empty()) return f.require_size(influences.joints.size(), 0);
  if (f.code() != ErrorCode::ok) return;
  std::size_t covered = 0, used = 0;
  for (const InfluenceGroup& group : influences.groups) {
    f.require(group.first_vertex == covered && group.influence_count >= 1, ErrorCode::size_mismatch);
    const std::size_t taken = std::size_t{group.vertex_count} * group.influence_count;
    f.require(std::size_t{group.first_influence} + taken <= influences.joints.size(), ErrorCode::index_out_of_range);
    f.require(group.first_influence == used, ErrorCode::size_mismatch);
    if (f.code() != ErrorCode::ok) return;
    const auto weights = std::span(influences.weights).subspan(used, taken);
    if (!are_shares(weights, group.influence_count)) f.add(fault_of(weights, group.influence_count));
    covered += group.vertex_count;
    used += taken;
  }
  f.require_size(covered, vertex_count);
  f.require_size(used, influences.joints.size());
}

template <class V>
void check_deltas(const SparseDeltas<V>& sparse, std::size_t vertex_count, Findings& f) noexcept {
  f.require_size(sparse.deltas.size(), sparse.vertices.size());
  f.require_finite(sparse.deltas);
  f.require_indices(sparse.vertices, vertex_count);
  bool rising = true;
  for (std::size_t i = 1; i < sparse.vertices.size(); ++i) rising &= sparse.vertices[i - 1] < sparse.vertices[i];
  f.require(rising, ErrorCode::unsupported);
}

void check_morphs(const MorphSet& morphs, std::size_t target_count, std::size_t vertex_count, Findings& f) noexcept {
  f.require_size_or_none(morphs.targets.size(), target_count);
  for (const MorphTarget& target : morphs.targets) {
    check_deltas(target.positions, vertex_count, f);
    check_deltas(target.normals, vertex_count, f);
    check_deltas(target.tangents, vertex_count, f);
    check_deltas(target.colors, vertex_count, f);
    for (const auto& set : target.texcoords) check_deltas(set, vertex_count, f);
  }
}

/// True if all points are finite and inside of the box. The loop has no branch, and takes four points (twelve floats)
/// at a time, so compilers vectorise it.
bool are_within(std::span<const glm::vec3> points, const Aabb& box) noexcept {
  constexpr std::size_t kFourPoints = 12;
  float lower[kFourPoints], upper[kFourPoints];
  for (std::size_t k = 0; k < kFourPoints; ++k) {
    lower[k] = box.lower[static_cast<int>(k % 3)];
    upper[k] = box.upper[static_cast<int>(k % 3)];
  }
  const float* at = points.empty() ? nullptr : &points.front().x;
  const std::size_t count = 3 * points.size(), whole = count - count % kFourPoints;
  const auto is_within = [&](std::size_t i, std::size_t k) {  // false for NaN
    return static_cast<std::uint32_t>(at[i] >= lower[k]) & static_cast<std::uint32_t>(at[i] <= upper[k]);
  };
  std::uint32_t within = 1;
  for (std::size_t i = 0; i < whole; i += kFourPoints)
    for (std::size_t k = 0; k < kFourPoints; ++k) within &= is_within(i + k, k);
  for (std::size_t i = whole; i < count; ++i) within &= is_within(i, i % 3);
  return within != 0;
}

void check_positions(const Primitive& p, Findings& f) {
  const glm::vec3 corners[] = {p.bounds.lower, p.bounds.upper};
  f.require(all_finite(std::span<const glm::vec3>(corners)), ErrorCode::not_finite);
  if (are_within(p.positions, p.bounds)) return;
  f.require_finite(p.positions);
  f.require(false, ErrorCode::index_out_of_range);
}

void check_primitive(const Primitive& p, std::size_t target_count, std::size_t material_count, Findings& f) noexcept {
  const std::size_t vertices = p.vertex_count();
  for (const std::size_t size :
       {p.normals.size(), p.tangents.size(), p.colors.size(), p.centers_of_rotation.size(), p.source_vertex.size()})
    f.require_size_or_none(size, vertices);
  check_positions(p, f);
  f.require_finite(p.normals);
  f.require_finite(p.tangents);
  f.require_finite(p.colors);
  f.require_finite(p.centers_of_rotation);
  for (const auto& set : p.texcoords) {
    f.require_size_or_none(set.size(), vertices);
    f.require_finite(set);
  }
  f.require_indices(p.indices, vertices);
  f.require(p.topology <= Topology::triangles, ErrorCode::unsupported);
  const std::size_t per_element = static_cast<std::size_t>(p.topology) + 1;
  f.require(p.indices.size() % per_element == 0, ErrorCode::size_mismatch);
  f.require_optional_index(p.material, material_count);
  check_influences(p.influences, vertices, f);
  check_morphs(p.morphs, target_count, vertices, f);
}

void check_variants(const Primitive& p, const Scene& scene, Findings& f) noexcept {
  for (const VariantMaterial& other : p.variant_materials) {
    f.require_index(other.variant, scene.variants.size());
    f.require_index(other.material, scene.materials.size());
  }
  const auto not_rising = [](const VariantMaterial& a, const VariantMaterial& b) { return a.variant >= b.variant; };
  const auto& all = p.variant_materials;
  f.require(std::adjacent_find(all.begin(), all.end(), not_rising) == all.end(), ErrorCode::unsupported);
}

/// The least number of joints that every skin of this mesh must have. A mesh may be used with several skins.
std::size_t joints_needed(const Mesh& mesh) noexcept {
  std::uint32_t end = 0;
  for (const Primitive& p : mesh.primitives)
    for (const std::uint16_t joint : p.influences.joints) end = std::max(end, std::uint32_t{joint} + 1u);
  return end;
}

void check_instances(const Scene& scene, const std::vector<std::size_t>& needed, Findings& f) noexcept {
  for (const MeshInstance& instance : scene.instances) {
    f.require_index(instance.joint, scene.skeleton.joint_count());
    f.require_index(instance.mesh, scene.meshes.size());
    f.require_optional_index(instance.skin, scene.skins.size());
    if (f.code() != ErrorCode::ok) return;
    f.require_size(instance.rest_weights.size(), scene.meshes[instance.mesh].target_count());
    f.require_finite(instance.rest_weights);
    f.require_finite(instance.copies);
    f.require_unit(instance.copies);
    if (instance.skin == kNone) continue;
    f.require(instance.copies.empty(), ErrorCode::unsupported);
    f.require(needed[instance.mesh] <= scene.skins[instance.skin].joints.size(), ErrorCode::index_out_of_range);
  }
}

}  // namespace

void check_meshes(const Scene& scene, Findings& f) {
  std::vector<std::size_t> needed;
  for (const Mesh& mesh : scene.meshes) {
    f.require_finite(mesh.default_weights);
    f.require_size_or_none(mesh.target_names.size(), mesh.target_count());
    for (const Primitive& p : mesh.primitives) {
      check_primitive(p, mesh.target_count(), scene.materials.size(), f);
      check_variants(p, scene, f);
    }
    needed.push_back(joints_needed(mesh));
  }
  check_instances(scene, needed, f);
}

}  // namespace sinew
