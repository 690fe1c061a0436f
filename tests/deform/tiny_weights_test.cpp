// SPDX-License-Identifier: MIT
/// Weights that are tiny but in proportion, for the kinds of skinning that divide by the length of a blend.
#include <gtest/gtest.h>

#include "runtime/math/decompose.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::Way;
using Vec3d = Vec3<double>;

constexpr std::uint32_t kTinyCounts[] = {1, 2, 3, 4, 6, 8};

struct Case {
  test::SkinnedVertices s;
  std::vector<glm::vec3> centers;
  std::vector<RigidStretch> split;
  bool any_stretch = false;

  Case(bool with_scale, float weight) {
    test::FixedRandom random(71);
    s = test::random_skinned_vertices(random, kTinyCounts, 23, 12, with_scale);
    for (const glm::vec3& p : s.positions) centers.push_back(p + random.vec3());
    for (float& w : s.influences.weights) w *= weight;
    split.resize(s.palette.size());
    EXPECT_EQ(run(SplitPaletteJob{s.palette, split, &any_stretch}), ErrorCode::ok);
  }

  void skin(Way way, bool directions) {
    VertexInput in = s.in();
    if (!directions) {
      in.normals = {};
      in.tangents = {};
    }
    if (way == Way::dual_quaternion)
      EXPECT_EQ(run(SkinDualQuaternionJob{&s.influences, split, any_stretch, in, s.out()}), ErrorCode::ok);
    else
      EXPECT_EQ(run(SkinCenterOfRotationJob{&s.influences, s.palette, split, any_stretch, centers, in, s.out()}),
                ErrorCode::ok);
  }

  reference::SkinnedT<double> truth(Way way, std::size_t v) const {
    std::vector<DualQuatd> motions;
    std::vector<Mat3<double>> stretches;
    std::vector<Affined> matrices;
    std::vector<double> weights;
    for (const auto j : s.joints_of(v)) {
      motions.push_back({quat_cast<double>(split[j].rigid.real), quat_cast<double>(split[j].rigid.dual)});
      if (any_stretch) stretches.push_back(Mat3<double>(matrix_from_stretch(split[j].stretch)));
      matrices.push_back(affine_cast<double>(affine_from(s.palette[j])));
    }
    for (const float w : s.weights_of(v)) weights.push_back(static_cast<double>(w));
    const Vec3d p(s.positions[v]), n(s.normals[v]);
    if (way == Way::dual_quaternion) return reference::skin_dual_quaternion<double>(motions, stretches, weights, p, n);
    return reference::skin_center_of_rotation<double>(motions, matrices, weights, p, n, Vec3d(centers[v]), stretches);
  }
};

/// Compares one run with the reference in double; normals only where directions are skinned too.
void expect_truth(Way way, bool with_scale, float weight, bool directions) {
  Case c(with_scale, weight);
  c.skin(way, directions);
  for (std::size_t v = 0; v < c.s.positions.size(); ++v) {
    const auto truth = c.truth(way, v);
    // random rotations nearly cancel now and then; their blend loses digits by 1 / its length
    EXPECT_TRUE(test::is_near(Vec3d(c.s.out_positions[v]), truth.position, 1e-4)) << v;
    if (!directions) continue;
    EXPECT_TRUE(test::is_near(Vec3d(c.s.out_normals[v]), truth.normal, 1e-4)) << v;
    EXPECT_NEAR(glm::length(c.s.out_normals[v]), 1.0f, 1e-6f) << v;
  }
}

class TinyWeights : public testing::TestWithParam<Way> {};

TEST_P(TinyWeights, N17_weights_in_proportion_are_as_accurate_at_any_size_on_every_instruction_set) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    for (const float weight : {1.0f, 1e-10f, 1e-20f, 1e-30f})
      for (const bool with_scale : {false, true})
        for (const bool directions : {false, true}) {
          SCOPED_TRACE(test::simd_name(target) + " weights " + std::to_string(std::log10(weight)) +
                       (with_scale ? " scaled" : " rigid") + (directions ? "" : " positions only"));
          expect_truth(GetParam(), with_scale, weight, directions);
        }
  }
}

INSTANTIATE_TEST_SUITE_P(ways, TinyWeights, testing::Values(Way::dual_quaternion, Way::center_of_rotation),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace sinew
