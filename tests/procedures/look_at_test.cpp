// SPDX-License-Identifier: MIT
#include "runtime/procedures/look_at/look_at.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "runtime/base/same_bits.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/procedures/joint_frames.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using V = Vec3<double>;
using Q = Quat<double>;
constexpr double kDegree = std::numbers::pi / 180.0;

/// Body, neck, head and two eyes, all with rest rotations and scales of their own.
struct Face {
  enum Joint : std::uint32_t { body, neck, head, left, right };
  Skeleton skeleton = test::chain_skeleton(5);
  EyesSetup setup;
  mutable test::PoseBuffer pose{5};

  explicit Face(unsigned seed = 1) : random(seed) {
    skeleton.parents[right] = head;
    for (Transform& rest : skeleton.rest) rest.rotation = any_rotation();
    skeleton.rest[neck].scale = Vec3<float>(2.0f);
    skeleton.rest[left].translation = {0.03f, 0.05f, 0.08f};
    skeleton.rest[right].translation = {-0.03f, 0.05f, 0.08f};
    setup.head = head;
    setup.left = left;
    setup.right = right;
    setup.between_eyes_m = {0.0f, 0.06f, 0.02f};
    setup.inner = {static_cast<float>(80 * kDegree), static_cast<float>(8 * kDegree)};
    setup.outer = {static_cast<float>(90 * kDegree), static_cast<float>(12 * kDegree)};
    setup.down = {static_cast<float>(60 * kDegree), static_cast<float>(10 * kDegree)};
    setup.upward = {static_cast<float>(70 * kDegree), static_cast<float>(5 * kDegree)};
    rest();
  }
  void rest() {
    for (std::size_t j = 0; j < 5; ++j) pose.span().set(j, skeleton.rest[j]);
  }
  void turn_body_and_head() {
    for (const Joint j : {body, neck, head}) pose.span().set_rotation(j, any_rotation());
  }
  glm::quat any_rotation() {
    std::normal_distribution<float> gauss;
    return glm::normalize(glm::quat(gauss(random), gauss(random), gauss(random), gauss(random)));
  }
  /// Where the face of the pose has a target at these angles.
  V target(double yaw, double pitch, double distance) const {
    const V seen(std::sin(yaw) * std::cos(pitch), -std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    test::PoseBuffer still(5);
    for (std::size_t j = 0; j < 5; ++j) still.span().set(j, skeleton.rest[j]);
    const Q head_at_rest = model_rotation(skeleton, still.span(), head);
    const V in_head = rotate_vector(quat_conjugate(head_at_rest), seen) * distance;
    return transform_point(model_matrix(skeleton, pose.span(), head), V(setup.between_eyes_m) + in_head);
  }
  Gaze look(const V& at, float weight = 1.0f) {
    const Eyes eyes = prepare_eyes(skeleton, setup).value();
    Gaze gaze;
    EXPECT_EQ(run(LookAtJob{&skeleton, pose.span(), &eyes, at, weight, &gaze}), ErrorCode::ok);
    return gaze;
  }
  /// Turn of an eye since its rest, in the axes that the face has at rest.
  Mat3<double> turn_of(Joint eye) const {
    test::PoseBuffer still(5);
    for (std::size_t j = 0; j < 5; ++j) still.span().set(j, skeleton.rest[j]);
    const auto rotation = [&](const PoseSpan& of, std::uint32_t j) {
      return matrix_from_unit_quat(model_rotation(skeleton, of, j));
    };
    const Mat3<double> head_turn = rotation(pose.span(), head) * glm::transpose(rotation(still.span(), head));
    return glm::transpose(head_turn) * rotation(pose.span(), eye) * glm::transpose(rotation(still.span(), eye));
  }
  std::mt19937 random;
};

Mat3<double> about_y(double angle) {
  return {std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0, std::cos(angle)};
}
Mat3<double> about_x(double angle) {
  return {1, 0, 0, 0, std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle)};
}
double difference(const Mat3<double>& a, const Mat3<double>& b) {
  double most = 0.0;
  for (int c = 0; c < 3; ++c) most = std::max(most, glm::length(a[c] - b[c]));
  return most;
}

/// The tables of the specification as they stand, in matrices.
TEST(look_at, turns_eyes_as_vrm_says_whatever_the_rotations_at_rest) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Face face(seed);
    for (const auto& [yaw, pitch] : {std::pair{30.0, 20.0}, {-30.0, -20.0}, {85.0, 65.0}, {-85.0, -65.0}, {0.0, 0.0}}) {
      face.rest();
      face.turn_body_and_head();
      const Gaze gaze = face.look(face.target(yaw * kDegree, pitch * kDegree, 1.7));
      EXPECT_NEAR(static_cast<double>(gaze.yaw_rad), yaw * kDegree, 1e-6);
      EXPECT_NEAR(static_cast<double>(gaze.pitch_rad), pitch * kDegree, 1e-6);
      EXPECT_EQ(gaze.is_limited, std::abs(yaw) > 80.0);
      const double inner = std::min(std::abs(yaw), 80.0) / 80.0 * 8.0;
      const double outer = std::min(std::abs(yaw), 90.0) / 90.0 * 12.0;
      const double down = pitch > 0 ? std::min(pitch, 60.0) / 60.0 * 10.0 : -std::min(-pitch, 70.0) / 70.0 * 5.0;
      const double left = yaw > 0 ? outer : -inner, right = yaw > 0 ? inner : -outer;
      EXPECT_LT(difference(face.turn_of(Face::left), about_y(left * kDegree) * about_x(down * kDegree)), 2e-6);
      EXPECT_LT(difference(face.turn_of(Face::right), about_y(right * kDegree) * about_x(down * kDegree)), 2e-6);
    }
  }
}

TEST(look_at, weights_of_expressions_follow_the_outer_range_and_leave_the_pose) {
  Face face;
  face.setup.kind = EyeKind::weights;
  face.setup.outer.output = face.setup.down.output = face.setup.upward.output = 1.0f;
  test::PoseBuffer before = [&] {
    test::PoseBuffer copy(5);
    for (std::size_t j = 0; j < 5; ++j) copy.span().set(j, face.pose.span().get(j));
    return copy;
  }();
  const Gaze left = face.look(face.target(45 * kDegree, 30 * kDegree, 2.0));
  EXPECT_NEAR(left.left, 0.5f, 1e-6f);
  EXPECT_NEAR(left.down, 0.5f, 1e-6f);
  EXPECT_EQ(left.right, 0.0f);
  EXPECT_EQ(left.up, 0.0f);
  const Gaze right = face.look(face.target(-90 * kDegree, -35 * kDegree, 2.0), 0.5f);
  EXPECT_NEAR(right.right, 0.5f, 1e-6f);
  EXPECT_NEAR(right.up, 0.25f, 1e-6f);
  for (std::size_t j = 0; j < 5; ++j) EXPECT_TRUE(same_bits(before.span().get(j), face.pose.span().get(j)));
}

TEST(look_at, a_face_along_minus_z_looks_to_its_own_left) {
  Face face;
  face.setup.forward = {0, 0, -1};
  const Gaze gaze = face.look(face.target(200 * kDegree, 0.0, 2.0));  // 20 degrees beside -z, towards -x: its left
  EXPECT_NEAR(static_cast<double>(gaze.yaw_rad), 20 * kDegree, 1e-6);
}

/// A target that walks round the head, over it and past it turns no eye by a jump.
TEST(look_at, does_not_snap_behind_above_and_below) {
  for (const double height : {0.0, 1.0, 60.0, -60.0}) {
    Face face;
    Mat3<double> last(1.0);
    double most = 0.0;
    for (int step = 0; step <= 3600; ++step) {
      face.look(face.target(step * 0.1 * kDegree, height * kDegree, 2.0));
      if (step > 0) most = std::max(most, difference(face.turn_of(Face::left), last));
      last = face.turn_of(Face::left);
    }
    EXPECT_LT(most, 0.25 * kDegree) << height;
  }
  Face face;
  double most = 0.0;
  Mat3<double> last(1.0);
  for (int step = -900; step <= 900; ++step) {  // over the crown of the head, a little beside it
    const double along = step * 0.1 * kDegree;
    face.look(face.target(std::atan2(0.001, std::sin(along)), -(90 * kDegree - std::abs(along)), 2.0));
    if (step > -900) most = std::max(most, difference(face.turn_of(Face::left), last));
    last = face.turn_of(Face::left);
  }
  EXPECT_LT(most, 0.25 * kDegree);
}

TEST(look_at, odd_targets_and_heads_leave_the_eyes_straight) {
  Face face;
  const V eyes =
      transform_point(model_matrix(face.skeleton, face.pose.span(), Face::head), V(face.setup.between_eyes_m));
  EXPECT_NEAR(face.look(eyes).yaw_rad, 0.0f, 1e-12f);
  EXPECT_LT(difference(face.turn_of(Face::left), Mat3<double>(1.0)), 1e-6);
  Transform head = face.skeleton.rest[Face::head];
  head.scale = Vec3<float>(0.0f);
  face.pose.span().set(Face::head, head);
  EXPECT_EQ(face.look({1, 2, 3}), Gaze{});
  face.rest();
  face.setup.inner.most_rad = face.setup.outer.most_rad = 0.0f;  // files have it: the full turn for any angle
  face.look(face.target(10 * kDegree, 0.0, 2.0));
  EXPECT_LT(difference(face.turn_of(Face::left), about_y(12 * kDegree)), 2e-6);
  test::PoseBuffer& pose = face.pose;
  const Transform before = pose.span().get(Face::left);
  face.look({1, 2, 3}, 0.0f);
  EXPECT_TRUE(same_bits(before, pose.span().get(Face::left)));
}

TEST(look_at, checks_its_setup_and_its_job) {
  Face face;
  const auto refused = [&](auto change) {
    EyesSetup bad = face.setup;
    change(bad);
    const auto eyes = prepare_eyes(face.skeleton, bad);
    return eyes ? ErrorCode::ok : eyes.error();
  };
  EXPECT_EQ(refused([](auto& s) { s.head = 5; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(refused([](auto& s) { s.left = 5; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(refused([](auto& s) { s.up = {0, 0, -2}; }), ErrorCode::unsupported);
  EXPECT_EQ(refused([](auto& s) { s.forward = Vec3<float>(0.0f); }), ErrorCode::unsupported);
  EXPECT_EQ(refused([](auto& s) { s.down.most_rad = -1.0f; }), ErrorCode::negative_weight);
  EXPECT_EQ(refused([](auto& s) { s.fade_rad = std::nanf(""); }), ErrorCode::not_finite);
  EXPECT_EQ(refused([](auto& s) { s.right = kNone; }), ErrorCode::ok) << "a character with one eye";
  const Eyes eyes = prepare_eyes(face.skeleton, face.setup).value();
  LookAtJob job{&face.skeleton, face.pose.span(), &eyes, {1, 2, 3}};
  EXPECT_EQ(check(job), ErrorCode::ok);
  job.weight = 1.5f;
  EXPECT_EQ(check(job), ErrorCode::not_a_fraction);
  job.weight = 1.0f;
  job.target.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check(job), ErrorCode::not_finite);
  job.target.x = 0.0;
  test::PoseBuffer other(6);
  job.local = other.span();
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
}

TEST(look_at, as_a_procedure_keeps_its_version_while_the_target_stays_and_allocates_nothing) {
  Face face;
  const Eyes eyes = prepare_eyes(face.skeleton, face.setup).value();
  LookAt look{.eyes = &eyes, .target = face.target(40 * kDegree, 0.0, 2.0)};
  const PoseProcedure procedure = as_procedure(look);
  EXPECT_EQ(as_procedure(look).version, procedure.version);
  const test::AllocationCounter allocated;
  procedure.run(procedure.context, {face.skeleton, face.pose.span(), {}, {}, 1.0f});
  EXPECT_EQ(allocated.count(), 0u);
  EXPECT_EQ(look.error, ErrorCode::ok);
  EXPECT_NEAR(static_cast<double>(look.gaze.yaw_rad), 40 * kDegree, 1e-6);
  look.target.x += 0.1;
  EXPECT_NE(as_procedure(look).version, procedure.version);
}

}  // namespace
}  // namespace sinew
