// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/deform/vertex_streams.h"
#include "runtime/math/transform.h"
#include "runtime/model/skin.h"
#include "runtime/pose/joint_palette.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {

/// Random vertices with influences and a random palette: inputs of the skinning jobs, and memory for their outputs.
struct SkinnedVertices {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;
  VertexInfluences influences;
  std::vector<JointMatrix> palette;
  std::vector<glm::vec3> out_positions, out_normals;
  std::vector<glm::vec4> out_tangents;

  VertexInput in() const { return {positions, normals, tangents}; }
  VertexOutput out() { return {out_positions, out_normals, out_tangents}; }

  std::span<const std::uint16_t> joints_of(std::size_t v) const { return slice(influences.joints, v); }
  std::span<const float> weights_of(std::size_t v) const { return slice(influences.weights, v); }

 private:
  template <class T>
  std::span<const T> slice(const std::vector<T>& all, std::size_t v) const {
    for (const auto& g : influences.groups)
      if (v < g.first_vertex + g.vertex_count)
        return std::span(all).subspan(g.first_influence + (v - g.first_vertex) * g.influence_count, g.influence_count);
    return {};
  }
};

/// `group_size` vertices for each of the influence counts, with joints below `joint_count` and the heaviest influence
/// first.
inline SkinnedVertices random_skinned_vertices(FixedRandom& random, std::span<const std::uint32_t> influence_counts,
                                               std::uint32_t group_size, std::uint32_t joint_count, bool with_scale) {
  SkinnedVertices out;
  for (const std::uint32_t n : influence_counts) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    out.influences.groups.push_back({first, group_size, n, static_cast<std::uint32_t>(out.influences.joints.size())});
    for (std::uint32_t v = 0; v < group_size; ++v) {
      out.positions.push_back(random.vec3(-2, 2));
      out.normals.push_back(random.direction());
      out.tangents.emplace_back(random.direction(), v % 2 ? 1.0f : -1.0f);
      std::vector<float> weights(n);
      float sum = 0;
      for (float& w : weights) sum += w = static_cast<float>(random.in(0.1, 1));
      for (float& w : weights) w /= sum;
      std::sort(weights.rbegin(), weights.rend());
      std::vector<std::uint16_t> all(joint_count);
      for (std::uint16_t j = 0; j < joint_count; ++j) all[j] = j;
      for (std::uint32_t i = 0; i < n; ++i) {
        std::swap(all[i], all[i + random.below(joint_count - i)]);
        out.influences.joints.push_back(all[i]);
        out.influences.weights.push_back(weights[i]);
      }
    }
  }
  for (std::uint32_t j = 0; j < joint_count; ++j) {
    Transform t = random.transform();
    if (!with_scale) t.scale = glm::vec3(1);
    out.palette.push_back(joint_matrix_from(affine_from_transform(t)));
  }
  out.out_positions.resize(out.positions.size());
  out.out_normals.resize(out.positions.size());
  out.out_tangents.resize(out.positions.size());
  return out;
}

/// Replaces a palette by joints that are each turned by half a radian. All their quaternions lie on one hemisphere, so
/// blending flips no sign.
inline void pose_on_one_side(FixedRandom& random, std::span<JointMatrix> palette, bool with_scale) {
  for (JointMatrix& m : palette) {
    Transform t = random.transform();
    t.rotation = random.rotation_by(0.5);
    if (!with_scale) t.scale = glm::vec3(1);
    m = joint_matrix_from(affine_from_transform(t));
  }
}

inline std::vector<JointPair> all_pairs(std::uint16_t joint_count) {
  std::vector<JointPair> pairs;
  for (std::uint16_t j = 0; j < joint_count; ++j)
    for (std::uint16_t k = 0; k < joint_count; ++k) pairs.push_back({j, k});
  return pairs;
}

}  // namespace sinew::test
