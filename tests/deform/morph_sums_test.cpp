// SPDX-License-Identifier: MIT
// Many targets at once: how far sums of displacements may lie from the truth, and what tiny numbers do to them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "runtime/deform/morph_vertices.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;

/// `targets` displacements of every vertex; magnitudes over eleven decades, signs of neighbouring targets opposite,
/// every second one nearly taking back what the one before did.
struct ManyTargets {
  std::vector<glm::vec3> positions, normals, moved, turned, scratch;
  MorphSet morphs;
  std::vector<float> weights;

  ManyTargets(std::size_t vertices, std::size_t targets)
      : positions(vertices), normals(vertices), moved(vertices), turned(vertices), scratch(vertices) {
    test::FixedRandom random(11);
    for (auto& p : positions) p = random.vec3(-2, 2);
    for (auto& n : normals) n = random.direction();
    std::vector<glm::vec3> before(vertices);
    for (std::size_t t = 0; t < targets; ++t) {
      MorphTarget target;
      for (std::uint32_t v = 0; v < vertices; ++v) {
        const float magnitude = static_cast<float>(std::pow(10.0, random.in(-8, 3)));
        const glm::vec3 delta =
            t % 2 == 0 ? magnitude * random.direction() : before[v] * static_cast<float>(random.in(0.99, 1.01));
        before[v] = delta;
        add(target.positions, v, delta);
        add(target.normals, v, 1e-3f * delta);
      }
      morphs.targets.push_back(std::move(target));
      const float size = t % 2 == 0 ? static_cast<float>(random.in(0.1, 3)) : -weights.back();
      weights.push_back(size);
    }
  }
  static void add(SparseDeltas<glm::vec3>& sparse, std::uint32_t v, const glm::vec3& delta) {
    sparse.vertices.push_back(v);
    sparse.deltas.push_back(delta);
  }
  void morph() {
    const MorphVerticesJob job{.morphs = &morphs,
                               .weights = weights,
                               .vertices = {positions, normals, {}},
                               .out = {moved, turned, {}},
                               .scratch = scratch};
    ASSERT_EQ(run(job), ErrorCode::ok);
  }
  struct Truth {
    Vec3d sum{0.0}, terms{0.0};  ///< base and displacements;  the displacements' magnitudes
  };
  Truth truth(std::size_t v, SparseDeltas<glm::vec3> MorphTarget::*attribute, const glm::vec3& base) const {
    Truth out{Vec3d(base)};
    for (std::size_t t = 0; t < weights.size(); ++t) {
      const Vec3d term = static_cast<double>(weights[t]) * Vec3d((morphs.targets[t].*attribute).deltas[v]);
      out.sum += term;
      out.terms += glm::abs(term);
    }
    return out;
  }
};

// The bound that holds for any order of plain float sums is (T + 1) eps sum|w d| + eps |v'|, eps = 2^-24. In the order
// of the targets rounding errors mostly cancel: 32 eps sum|w d| is held here for 500 targets, 2e-6 of what they move
// altogether.
TEST(morph_sums, G44_five_hundred_targets_of_alternating_sign_stay_within_their_bound) {
  ManyTargets face(64, 500);
  face.morph();
  for (std::size_t v = 0; v < face.positions.size(); ++v) {
    const auto truth = face.truth(v, &MorphTarget::positions, face.positions[v]);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(static_cast<double>(face.moved[v][c]), truth.sum[c],
                  test::kEps * (32 * truth.terms[c] + std::abs(truth.sum[c])));
  }
}

TEST(morph_sums, G44_G45_normals_under_five_hundred_targets_are_unit_and_point_where_double_says) {
  ManyTargets face(64, 500);
  face.morph();
  for (std::size_t v = 0; v < face.normals.size(); ++v) {
    const auto truth = face.truth(v, &MorphTarget::normals, face.normals[v]);
    const double length = safe_length(truth.sum);
    EXPECT_NEAR(safe_length(Vec3d(face.turned[v])), 1.0, 4 * test::kEps);
    EXPECT_LE(test::distance(Vec3d(face.turned[v]), truth.sum / length),
              test::kEps * (8 + 40 * safe_length(truth.terms) / length));
  }
}

TEST(morph_sums, weights_below_zero_and_far_above_one_are_as_good_as_any) {
  ManyTargets face(16, 1);
  for (const float weight : {-1.0f, -250.0f, 1.5f, 1e4f}) {
    face.weights[0] = weight;
    face.morph();
    for (std::size_t v = 0; v < face.positions.size(); ++v) {
      const auto truth = face.truth(v, &MorphTarget::positions, face.positions[v]);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<double>(face.moved[v][c]), truth.sum[c],
                    2 * test::kEps * (truth.terms[c] + std::abs(truth.sum[c])));
    }
  }
}

TEST(morph_sums, N26_denormal_weights_move_nothing_among_hundreds) {
  ManyTargets face(16, 200), clean(16, 200);
  for (std::size_t t = 0; t < 200; t += 3) {
    face.weights[t] =
        (t % 2 == 0 ? 1.0f : -1.0f) * std::numeric_limits<float>::denorm_min() * static_cast<float>(1 + t);
    clean.weights[t] = 0.0f;
  }
  face.weights[3] = 9.9e-21f;
  face.morph();
  clean.morph();
  EXPECT_EQ(face.moved, clean.moved);
  EXPECT_EQ(face.turned, clean.turned);
}

}  // namespace
}  // namespace sinew
