// SPDX-License-Identifier: MIT
// Properties of every kind of skinning: rigid motions commute with it, the bind pose moves nothing, and influences of
// weight zero change nothing.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "runtime/math/inverse.h"
#include "tests/support/near.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::SkinnedVertices;
using test::Way;

constexpr std::uint32_t kAnyCounts[] = {1, 2, 3, 4, 6};
constexpr std::uint32_t kAnyJoints = 9;

/// Joints within 57 degrees of each other, so that all kinds agree on the shorter way. Stretched; either all mirrored
/// or none.
SkinnedVertices vertices(FixedRandom& random) {
  SkinnedVertices s = test::random_skinned_vertices(random, kAnyCounts, 5, kAnyJoints, false);
  const float side = random.below(2) == 0 ? 1.0f : -1.0f;
  const Quat<float> common = random.rotation();
  for (JointMatrix& m : s.palette) {
    Transform t{random.vec3(-2, 2), normalised(common * random.rotation_by(random.in(0, 0.5))), random.vec3(0.5, 2)};
    t.scale.x *= side;
    m = joint_matrix_from(affine_from_transform(t));
  }
  return s;
}

std::vector<glm::vec3> some_centers(FixedRandom& random, const SkinnedVertices& s) {
  std::vector<glm::vec3> centers;
  for (const glm::vec3& p : s.positions) centers.push_back(p + random.vec3());
  return centers;
}

RC_GTEST_PROP(skinning_properties, rigid_motions_commute_with_every_kind_of_skinning, (std::uint64_t seed)) {
  FixedRandom random(seed);
  SkinnedVertices still = vertices(random);
  const auto centers = some_centers(random, still);
  const Affine motion = affine_from_transform(Transform{random.vec3(-2, 2), random.rotation(), glm::vec3(1)});
  SkinnedVertices moved = still;
  for (JointMatrix& m : moved.palette) m = joint_matrix_from(motion * affine_from(m));
  for (const Way way : test::kWays) {
    skin(way, still, centers);
    skin(way, moved, centers);
    for (std::size_t v = 0; v < still.positions.size(); ++v) {
      RC_ASSERT(test::is_near(moved.out_positions[v], transform_point(motion, still.out_positions[v]), 2e-5));
      RC_ASSERT(test::is_near(moved.out_normals[v], transform_vector(motion, still.out_normals[v]), 5e-5));
      RC_ASSERT(test::is_near(glm::vec3(moved.out_tangents[v]),
                              transform_vector(motion, glm::vec3(still.out_tangents[v])), 5e-5));
    }
  }
}

RC_GTEST_PROP(skinning_properties, bind_pose_in_gives_bind_pose_out, (std::uint64_t seed)) {
  FixedRandom random(seed);
  SkinnedVertices s = vertices(random);
  const auto centers = some_centers(random, s);
  for (JointMatrix& m : s.palette) {
    const Affine bind = affine_from(m);
    m = joint_matrix_from(bind * affine_cast<float>(*inverse_of(affine_cast<double>(bind))));
  }
  for (const Way way : test::kWays) {
    skin(way, s, centers);
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      RC_ASSERT(test::is_near(s.out_positions[v], s.positions[v], 1e-5));
      RC_ASSERT(test::is_near(s.out_normals[v], s.normals[v], 1e-5));
      RC_ASSERT(test::is_near(glm::vec3(s.out_tangents[v]), glm::vec3(s.tangents[v]), 1e-5));
      RC_ASSERT(s.out_tangents[v].w == s.tangents[v].w);
    }
  }
}

/// The same vertices, each with one more influence of weight zero.
SkinnedVertices with_zero_weights(const SkinnedVertices& s, FixedRandom& random) {
  SkinnedVertices out = s;
  out.influences = {};
  std::size_t first = 0;
  for (const InfluenceGroup& group : s.influences.groups) {
    const auto n = group.influence_count;
    out.influences.groups.push_back(
        {group.first_vertex, group.vertex_count, n + 1, static_cast<std::uint32_t>(out.influences.joints.size())});
    for (std::uint32_t v = 0; v < group.vertex_count; ++v, first += n) {
      for (std::size_t i = first; i < first + n; ++i) {
        out.influences.joints.push_back(s.influences.joints[i]);
        out.influences.weights.push_back(s.influences.weights[i]);
      }
      out.influences.joints.push_back(static_cast<std::uint16_t>(random.below(kAnyJoints)));
      out.influences.weights.push_back(0.0f);
    }
  }
  return out;
}

RC_GTEST_PROP(skinning_properties, influences_of_weight_zero_change_nothing, (std::uint64_t seed)) {
  FixedRandom random(seed);
  SkinnedVertices s = vertices(random);
  const auto centers = some_centers(random, s);
  SkinnedVertices more = with_zero_weights(s, random);
  for (const Way way : test::kWays) {
    skin(way, s, centers);
    skin(way, more, centers);
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      RC_ASSERT(test::is_near(more.out_positions[v], s.out_positions[v], 1e-5));
      RC_ASSERT(test::is_near(more.out_normals[v], s.out_normals[v], 1e-5));
    }
  }
}

}  // namespace
}  // namespace sinew
