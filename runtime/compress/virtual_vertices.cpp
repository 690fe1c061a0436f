// SPDX-License-Identifier: MIT
#include "runtime/compress/virtual_vertices.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

/// Calls `visit(vertex, position)` for every vertex, and for each position to which a morph target moves it.
template <class Visit>
void each_place(const Primitive& primitive, const Visit& visit) {
  for (std::size_t v = 0; v < primitive.positions.size(); ++v) visit(v, primitive.positions[v]);
  for (const MorphTarget& target : primitive.morphs.targets)
    for (std::size_t i = 0; i < target.positions.vertices.size(); ++i) {
      const std::uint32_t v = target.positions.vertices[i];
      visit(v, primitive.positions[v] + target.positions.deltas[i]);
    }
}

void add_rigid(const MeshInstance& instance, const Primitive& primitive, Aabb& box) {
  Aabb mesh;
  each_place(primitive, [&](std::size_t, const glm::vec3& p) { mesh.add(p); });
  if (mesh.empty()) return;
  if (instance.copies.empty()) {
    box.add(mesh.lower);
    box.add(mesh.upper);
  }
  for (const Transform& copy : instance.copies) {
    const Affined place = affine_cast<double>(affine_from_transform(copy));
    for (const Vec3<double>& corner : corners_of(mesh)) box.add(glm::vec3(transform_point(place, corner)));
  }
}

void add_skinned(const Skin& skin, const Primitive& primitive, std::vector<Aabb>& boxes) {
  const VertexInfluences& influences = primitive.influences;
  struct Run {
    std::uint32_t begin, end;  // indices into influences.joints
  };
  std::vector<Run> runs(primitive.vertex_count());
  for (const InfluenceGroup& group : influences.groups)
    for (std::uint32_t i = 0; i < group.vertex_count; ++i) {
      const std::uint32_t begin = group.first_influence + i * group.influence_count;
      runs[group.first_vertex + i] = {begin, begin + group.influence_count};
    }
  each_place(primitive, [&](std::size_t vertex, const glm::vec3& p) {
    for (std::uint32_t i = runs[vertex].begin; i < runs[vertex].end; ++i) {
      const std::uint16_t joint = influences.joints[i];
      boxes[skin.joints[joint]].add(transform_point(skin.inverse_bind[joint], p));
    }
  });
}

/// Longest displacement of any vertex by each target. Targets that change only colours or normals count as if they
/// moved vertices by kShell.
void add_weights(const Mesh& mesh, std::vector<float>& metres) {
  const std::size_t first = metres.size();
  metres.resize(first + mesh.target_count(), 0.0f);
  for (const Primitive& primitive : mesh.primitives)
    for (std::size_t t = 0; t < primitive.morphs.targets.size(); ++t)
      for (const glm::vec3& delta : primitive.morphs.targets[t].positions.deltas)
        metres[first + t] = std::max(metres[first + t], safe_length(delta));
  for (std::size_t t = first; t < metres.size(); ++t)
    if (metres[t] == 0.0f) metres[t] = VirtualVertices::kShell;
}

}  // namespace

VirtualVertices virtual_vertices(const Skeleton& skeleton) {
  VirtualVertices out;
  out.boxes.assign(skeleton.joint_count(),
                   Aabb{glm::vec3(-VirtualVertices::kShell), glm::vec3(VirtualVertices::kShell)});
  out.moves_vertices.assign(skeleton.joint_count(), false);
  return out;
}

VirtualVertices virtual_vertices(const Scene& scene) {
  VirtualVertices out = virtual_vertices(scene.skeleton);
  std::vector<Aabb> boxes(scene.skeleton.joint_count());
  for (const MeshInstance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const Primitive& primitive : mesh.primitives)
      if (instance.skin != kNone && !primitive.influences.empty())
        add_skinned(scene.skins[instance.skin], primitive, boxes);
      else
        add_rigid(instance, primitive, boxes[instance.joint]);
    add_weights(mesh, out.metres_per_weight);
  }
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    out.moves_vertices[j] = !boxes[j].empty();
    if (out.moves_vertices[j]) out.boxes[j] = boxes[j];
  }
  return out;
}

std::array<Vec3<double>, 8> corners_of(const Aabb& box) noexcept {
  std::array<Vec3<double>, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis)
      corners[i][axis] = static_cast<double>((i >> axis & 1u) != 0 ? box.upper[axis] : box.lower[axis]);
  return corners;
}

}  // namespace sinew
