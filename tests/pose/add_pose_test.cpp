// SPDX-License-Identifier: MIT
#include "runtime/pose/add_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/math/quaternion.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr std::size_t kJoints = 37;  // not a multiple of any vector length

struct Poses {
  test::PoseBuffer base{kJoints}, layer{kJoints}, reference{kJoints};
  std::vector<float> mask;

  explicit Poses(std::uint64_t seed) {
    test::FixedRandom random(seed);
    for (std::size_t j = 0; j < kJoints; ++j) {
      base.span().set(j, random.transform(0.5, 2));
      layer.span().set(j, random.transform(0.5, 2));
      reference.span().set(j, random.transform(0.5, 2));
      mask.push_back(j % 5 == 0 ? 0.0f : static_cast<float>(random.unit()));
    }
  }
  AddPoseJob job(float weight) { return {layer.span(), reference.span(), weight, {}, base.span()}; }
};

Transformd as_double(const Transform& t) {
  return {Vec3<double>(t.translation), quat_cast<double>(t.rotation), Vec3<double>(t.scale)};
}

/// The equations of add_pose.h, in double.
Transformd truth(const Transform& base, const Transform& layer, const Transform& reference, double w,
                 DeltaFrame frame) {
  const Transformd b = as_double(base), l = as_double(layer), r = as_double(reference);
  const bool in_parent = frame == DeltaFrame::parent;
  const Quat<double> back = quat_conjugate(r.rotation);
  Quat<double> delta = in_parent ? l.rotation * back : back * l.rotation;
  if (delta.w < 0) delta = -delta;
  const double size = std::abs(w);
  Quat<double> part = quat_xyzw(size * delta.x, size * delta.y, size * delta.z, 1 - size + size * delta.w);
  if (w < 0) part = quat_conjugate(part);
  const Vec3<double> factor = 1.0 + size * (l.scale / r.scale - 1.0);
  return {b.translation + w * (l.translation - r.translation),
          normalised(in_parent ? part * b.rotation : b.rotation * part), w < 0 ? b.scale / factor : b.scale * factor};
}

/// A subtraction divides by a factor that may be near 0. An error of 4e-7 of the factor is one of the quotient times
/// the quotient.
double scale_tolerance(double w, const Vec3<double>& scale) {
  return w < 0.0 ? 4e-6 + 4e-7 * glm::dot(scale, scale) : 4e-6;
}

TEST(add_pose, rejects_other_joint_counts_and_weights_that_are_none) {
  Poses p(1);
  test::PoseBuffer other(kJoints + 40);
  EXPECT_EQ(check(p.job(0.5f)), ErrorCode::ok);
  AddPoseJob job = p.job(0.5f);
  job.reference = other.span();
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = p.job(0.5f);
  job.joint_weights = std::span(p.mask).first(3);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  EXPECT_EQ(check(p.job(std::numeric_limits<float>::quiet_NaN())), ErrorCode::not_finite);
  EXPECT_EQ(check(p.job(-std::numeric_limits<float>::infinity())), ErrorCode::not_finite);
  EXPECT_EQ(check(p.job(-1.0f)), ErrorCode::ok) << "it subtracts";
  p.mask[3] = -0.5f;
  job = p.job(0.5f);
  job.joint_weights = p.mask;
  EXPECT_EQ(check(job), ErrorCode::negative_weight);
}

TEST(add_pose, random_poses_agree_with_double_and_every_instruction_set_gives_the_same_bits) {
  for (const float weight : {-1.5f, -1.0f, -0.3f, 0.0f, 0.3f, 1.0f, 1.5f})
    for (const auto& [masked, frame] : {std::pair(false, DeltaFrame::parent), std::pair(true, DeltaFrame::parent),
                                        std::pair(true, DeltaFrame::joint)}) {
      std::vector<Transform> first;
      for (const std::int64_t target : test::simd_targets()) {
        const test::OnlyTarget only(target);
        Poses p(7), untouched(7);
        AddPoseJob job = p.job(weight);
        job.frame = frame;
        if (masked) job.joint_weights = p.mask;
        EXPECT_EQ(run(job), ErrorCode::ok);
        std::vector<Transform> found;
        for (std::size_t j = 0; j < kJoints; ++j) {
          found.push_back(p.base.span().get(j));
          const double w = static_cast<double>(weight * (masked ? p.mask[j] : 1.0f));
          const Transformd expected =
              truth(untouched.base.span().get(j), p.layer.span().get(j), p.reference.span().get(j), w, frame);
          EXPECT_TRUE(test::is_near(Vec3<double>(found[j].translation), expected.translation, 1e-6)) << j;
          EXPECT_NEAR(std::abs(quat_dot(quat_cast<double>(found[j].rotation), expected.rotation)), 1.0, 1e-6) << j;
          EXPECT_TRUE(test::is_near(Vec3<double>(found[j].scale), expected.scale, scale_tolerance(w, expected.scale)))
              << j;
        }
        if (first.empty()) first = found;
        EXPECT_TRUE(found == first) << test::simd_name(target);
      }
    }
}

TEST(add_pose, the_reference_itself_adds_nothing) {
  Poses p(8), untouched(8);
  AddPoseJob job = p.job(1.0f);
  job.layer = job.reference;
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (std::size_t j = 0; j < kJoints; ++j) EXPECT_EQ(p.base.span().get(j), untouched.base.span().get(j)) << j;
}

TEST(add_pose, on_its_own_reference_a_layer_of_weight_one_comes_out) {
  Poses p(9);
  AddPoseJob job = p.job(1.0f);
  job.reference = job.pose;
  test::PoseBuffer start = p.base;
  job.reference = start.span();
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (std::size_t j = 0; j < kJoints; ++j) {
    EXPECT_NEAR(std::abs(quat_dot(p.base.span().get(j).rotation, p.layer.span().get(j).rotation)), 1.0f, 1e-6f) << j;
    EXPECT_TRUE(test::is_near(p.base.span().get(j).scale, p.layer.span().get(j).scale, 1e-6)) << j;
  }
}

TEST(add_pose, a_subtraction_undoes_the_addition_of_the_same_weight) {
  for (const DeltaFrame frame : {DeltaFrame::parent, DeltaFrame::joint})
    for (const float weight : {0.25f, 0.7f, 1.0f}) {
      Poses p(11), untouched(11);
      for (const float w : {weight, -weight}) {
        AddPoseJob job = p.job(w);
        job.frame = frame;
        EXPECT_EQ(run(job), ErrorCode::ok);
      }
      for (std::size_t j = 0; j < kJoints; ++j) {
        const Transform found = p.base.span().get(j), before = untouched.base.span().get(j);
        EXPECT_TRUE(test::is_near(found.translation, before.translation, 1e-6)) << j;
        EXPECT_NEAR(std::abs(quat_dot(found.rotation, before.rotation)), 1.0f, 1e-6f) << j;
        EXPECT_TRUE(test::is_near(found.scale, before.scale, 2e-6)) << j;
      }
    }
}

TEST(add_pose, a_subtraction_that_would_divide_by_zero_keeps_the_scale) {
  Poses p(12), untouched(12);
  for (std::size_t j = 0; j < kJoints; ++j) p.layer.span().plane(PoseSpan::sy)[j] = 0.0f;
  EXPECT_EQ(run(p.job(-1.0f)), ErrorCode::ok);
  for (std::size_t j = 0; j < kJoints; ++j)
    EXPECT_EQ(p.base.span().get(j).scale.y, untouched.base.span().get(j).scale.y) << j;
}

TEST(add_pose, a_reference_without_scale_adds_no_scale) {
  Poses p(10), untouched(10);
  for (std::size_t j = 0; j < kJoints; ++j) p.reference.span().plane(PoseSpan::sx)[j] = 0.0f;
  EXPECT_EQ(run(p.job(1.0f)), ErrorCode::ok);
  for (std::size_t j = 0; j < kJoints; ++j)
    EXPECT_EQ(p.base.span().get(j).scale.x, untouched.base.span().get(j).scale.x) << j;
}

}  // namespace
}  // namespace sinew
