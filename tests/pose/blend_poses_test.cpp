// SPDX-License-Identifier: MIT
#include "runtime/pose/blend_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "runtime/base/same_bits.h"
#include "tests/reference/sampling.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using test::PoseBuffer;

PoseBuffer random_pose(test::FixedRandom& random, std::size_t joints) {
  PoseBuffer pose(joints);
  for (std::size_t j = 0; j < joints; ++j) pose.span().set(j, random.transform());
  return pose;
}

TEST(blend_poses, rejections_name_the_broken_rule) {
  PoseBuffer a(3), b(2), rest(3), out(3);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float ones[2] = {1, 1}, masks[][3] = {{1, 1, std::nanf("")}, {-0.1f, 1, 1}, {1, kInfinity, 1}};
  BlendLayer layers[1] = {{a.span(), 1.0f, {}}};
  const BlendPosesJob good{.layers = layers, .rest = rest.span(), .pose = out.span()};
  EXPECT_EQ(check(good), ErrorCode::ok);
  const struct {
    const char* what;
    std::function<void(BlendPosesJob&, BlendLayer&)> damage;
    ErrorCode expected;
  } cases[] = {
      {"rest of other size", [&](BlendPosesJob& j, BlendLayer&) { j.rest = b.span(); }, ErrorCode::size_mismatch},
      {"layer of other size", [&](BlendPosesJob&, BlendLayer& l) { l.pose = b.span(); }, ErrorCode::size_mismatch},
      {"no output", [](BlendPosesJob& j, BlendLayer&) { j.pose.planes = nullptr; }, ErrorCode::size_mismatch},
      {"short mask", [&](BlendPosesJob&, BlendLayer& l) { l.joint_weights = ones; }, ErrorCode::size_mismatch},
      {"NaN weight", [](BlendPosesJob&, BlendLayer& l) { l.weight = std::nanf(""); }, ErrorCode::not_finite},
      {"negative weight", [](BlendPosesJob&, BlendLayer& l) { l.weight = -0.1f; }, ErrorCode::not_finite},
      {"infinite weight", [](BlendPosesJob&, BlendLayer& l) { l.weight = kInfinity; }, ErrorCode::not_finite},
      {"NaN in a mask", [&](BlendPosesJob&, BlendLayer& l) { l.joint_weights = masks[0]; }, ErrorCode::not_finite},
      {"negative in a mask", [&](BlendPosesJob&, BlendLayer& l) { l.joint_weights = masks[1]; }, ErrorCode::not_finite},
      {"infinite in a mask", [&](BlendPosesJob&, BlendLayer& l) { l.joint_weights = masks[2]; }, ErrorCode::not_finite},
  };
  for (const auto& c : cases) {
    BlendPosesJob job = good;
    BlendLayer layer = layers[0];
    job.layers = {&layer, 1};
    c.damage(job, layer);
    EXPECT_EQ(check(job), c.expected) << c.what;
  }
}

TEST(blend_poses, hand_computed_halves_and_the_rest_fills_up) {
  PoseBuffer a(1), b(1), rest(1), out(1);
  const float h = std::sqrt(0.5f);
  a.span().set(0, {{2, 0, 0}, quat_xyzw(h, 0.0f, 0.0f, h), {1, 1, 1}});
  b.span().set(0, {{4, 2, 0}, quat_identity<float>(), {3, 1, 1}});
  BlendLayer both[] = {{a.span(), 0.5f, {}}, {b.span(), 0.5f, {}}};
  EXPECT_EQ(run(BlendPosesJob{both, rest.span(), out.span()}), ErrorCode::ok);
  EXPECT_EQ(out.span().get(0).translation, glm::vec3(3, 1, 0));
  EXPECT_EQ(out.span().get(0).scale, glm::vec3(2, 1, 1));
  EXPECT_TRUE(test::same_rotation(out.span().get(0).rotation,
                                  quat_xyzw(std::sin(M_PI / 8), 0.0, 0.0, std::cos(M_PI / 8)), 1e-7));
  BlendLayer quarter[] = {{a.span(), 0.25f, {}}};
  EXPECT_EQ(run(BlendPosesJob{quarter, rest.span(), out.span()}), ErrorCode::ok);
  EXPECT_EQ(out.span().get(0).translation, glm::vec3(0.5f, 0, 0));
}

TEST(blend_poses, agrees_with_the_reference) {
  test::FixedRandom random(5);
  for (std::size_t round = 0; round < 50; ++round) {
    const std::size_t joints = 30 + round % 17;  // tails of every length: masks have no padding
    PoseBuffer rest = random_pose(random, joints), out(joints);
    std::vector<PoseBuffer> poses;
    std::vector<std::vector<float>> masks;
    std::vector<BlendLayer> layers;
    const std::size_t count = 1 + random.below(20);
    for (std::size_t l = 0; l < count; ++l) {
      poses.push_back(random_pose(random, joints));
      auto& mask = masks.emplace_back();
      for (std::size_t j = 0; j < joints; ++j)
        mask.push_back(random.below(4) == 0 ? 0.0f : static_cast<float>(random.unit()));
    }
    for (std::size_t l = 0; l < count; ++l)
      layers.push_back({poses[l].span(), static_cast<float>(random.in(0, 1.5)),
                        l % 2 && round % 3 ? std::span<const float>(masks[l]) : std::span<const float>()});
    const BlendPosesJob job{layers, rest.span(), out.span()};
    ASSERT_EQ(run(job), ErrorCode::ok);
    for (std::size_t j = 0; j < joints; ++j) {
      std::vector<Transform> values;
      std::vector<reference::Real> weights;
      reference::Real sum = 0;
      for (const BlendLayer& l : layers) {
        values.push_back(l.pose.get(j));
        weights.push_back(l.joint_weights.empty() ? l.weight : l.weight * l.joint_weights[j]);
        sum += weights.back();
      }
      values.push_back(rest.span().get(j));
      weights.push_back(std::max<reference::Real>(0, 1 - sum));
      const auto truth = reference::blend(values, weights);
      const Transform found = out.span().get(j);
      EXPECT_TRUE(test::is_near(Vec3<double>(found.translation), reference::vec3_of(truth.translation), 2e-6));
      EXPECT_TRUE(test::is_near(Vec3<double>(found.scale), reference::vec3_of(truth.scale), 2e-6));
      EXPECT_TRUE(test::same_rotation(found.rotation, reference::quat_of(truth.rotation), 1e-5));
    }
  }
}

TEST(blend_poses, masks_of_ones_give_the_same_bits_as_no_masks) {
  test::FixedRandom random(6);
  const std::size_t joints = 37;
  PoseBuffer rest = random_pose(random, joints), plain(joints), masked(joints);
  std::vector<PoseBuffer> poses;
  for (std::size_t l = 0; l < 20; ++l) poses.push_back(random_pose(random, joints));
  const std::vector<float> ones(joints, 1.0f);
  for (const float total : {0.4f, 1.0f, 1.7f})
    for (std::size_t count = 1; count <= poses.size(); ++count) {
      std::vector<BlendLayer> layers;
      for (std::size_t l = 0; l < count; ++l)
        layers.push_back({poses[l].span(), total * static_cast<float>(1 + l % 3) / static_cast<float>(count), {}});
      EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), plain.span()}), ErrorCode::ok);
      for (BlendLayer& layer : layers) layer.joint_weights = ones;
      EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), masked.span()}), ErrorCode::ok);
      for (std::size_t j = 0; j < joints; ++j)
        ASSERT_TRUE(same_bits(plain.span().get(j), masked.span().get(j))) << count << " layers, joint " << j;
    }
}

TEST(blend_poses, P06_one_full_layer_and_no_layer_come_out_bit_for_bit) {
  test::FixedRandom random(6);
  PoseBuffer a = random_pose(random, 5), b = random_pose(random, 5), rest = random_pose(random, 5), out(5);
  BlendLayer layers[] = {{a.span(), 1.0f, {}}, {b.span(), 0.0f, {}}};
  EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), out.span()}), ErrorCode::ok);
  for (std::size_t j = 0; j < 5; ++j) EXPECT_EQ(out.span().get(j), a.span().get(j));
  EXPECT_EQ(run(BlendPosesJob{{}, rest.span(), out.span()}), ErrorCode::ok);
  for (std::size_t j = 0; j < 5; ++j) EXPECT_EQ(out.span().get(j), rest.span().get(j));
}

TEST(blend_poses, N17_signs_of_rotations_and_order_of_layers_do_not_matter) {
  test::FixedRandom random(17);
  PoseBuffer a = random_pose(random, 9), b = random_pose(random, 9), c = random_pose(random, 9), rest(9), out(9),
             other(9);
  BlendLayer layers[] = {{a.span(), 0.5f, {}}, {b.span(), 0.3f, {}}, {c.span(), 0.2f, {}}};
  EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), out.span()}), ErrorCode::ok);
  for (std::size_t j = 0; j < 9; ++j) {
    Transform t = b.span().get(j);
    t.rotation = -t.rotation;
    b.span().set(j, t);
  }
  std::swap(layers[0], layers[2]);
  EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), other.span()}), ErrorCode::ok);
  for (std::size_t j = 0; j < 9; ++j) {
    EXPECT_TRUE(test::same_rotation(out.span().get(j).rotation, other.span().get(j).rotation, 1e-6));
    EXPECT_TRUE(test::is_near(out.span().get(j).translation, other.span().get(j).translation, 1e-6));
  }
}

glm::quat about_x(double degrees) {
  const double half = degrees * M_PI / 360;
  return quat_xyzw(static_cast<float>(std::sin(half)), 0.0f, 0.0f, static_cast<float>(std::cos(half)));
}

/// Blends three layers of equal weight in every order; masks have the same weights, joint by joint.
template <class Expect>
void blend_in_every_order(std::array<PoseSpan, 3> poses, PoseSpan rest, const Expect& expect) {
  PoseBuffer out(rest.joint_count);
  const std::vector<float> ones(rest.joint_count, 1.0f);
  std::array<std::size_t, 3> order = {0, 1, 2};
  do {
    for (const bool masked : {false, true}) {
      std::vector<BlendLayer> layers;
      for (const std::size_t i : order) layers.push_back({poses[i], 1.0f / 3, {}});
      if (masked) layers[0].joint_weights = ones;
      EXPECT_EQ(run(BlendPosesJob{layers, rest, out.span()}), ErrorCode::ok);
      for (std::size_t j = 0; j < rest.joint_count; ++j) expect(order[0], out.span().get(j));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(blend_poses, N17_layers_of_equal_weight_within_a_right_angle_blend_alike_in_any_order) {
  test::FixedRandom random(41);
  for (int round = 0; round < 50; ++round) {
    PoseBuffer a(1), b(1), c(1), rest(1);
    const glm::quat middle = random.rotation<float>();
    for (PoseBuffer* pose : {&a, &b, &c}) {
      const glm::quat q = middle * random.rotation_by<float>(0.75);               // 43 degrees: any two are within 90
      pose->span().set(0, {{}, random.in(-1.0, 1.0) < 0.0 ? q : -q, {1, 1, 1}});  // either quaternion of the rotation
    }
    PoseBuffer first(1);
    const BlendLayer layers[] = {{a.span(), 1.0f / 3, {}}, {b.span(), 1.0f / 3, {}}, {c.span(), 1.0f / 3, {}}};
    EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), first.span()}), ErrorCode::ok);
    blend_in_every_order({a.span(), b.span(), c.span()}, rest.span(), [&](std::size_t, const Transform& blended) {
      EXPECT_TRUE(test::same_rotation(blended.rotation, first.span().get(0).rotation, 1e-6)) << round;
      EXPECT_LE(test::angle_between(blended.rotation, middle), 0.75) << round;  // a mean is among what it is of
    });
  }
}

TEST(blend_poses, N17_of_equal_weights_on_several_sides_the_first_is_the_pivot) {
  PoseBuffer none(1), there(1), back(1), rest(1);
  there.span().set(0, {{}, about_x(170), {1, 1, 1}});
  back.span().set(0, {{}, about_x(-170), {1, 1, 1}});
  const double turned = 2 * std::atan2(2 * std::sin(M_PI * 85 / 180), 1.0) * 180 / M_PI;  // 126.7 degrees
  const glm::quat expected[] = {about_x(0), about_x(turned), about_x(-turned)};
  blend_in_every_order({none.span(), there.span(), back.span()}, rest.span(),
                       [&](std::size_t pivot, const Transform& blended) {
                         EXPECT_TRUE(test::same_rotation(blended.rotation, expected[pivot], 1e-6)) << pivot;
                       });
}

TEST(blend_poses, N18_the_pivot_is_the_heaviest_layer_and_the_first_of_equals) {
  PoseBuffer a(1), b(1), rest(1), out(1);
  const glm::quat q = quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f);
  a.span().set(0, {{}, q, {1, 1, 1}});
  b.span().set(0, {{}, -q, {1, 1, 1}});
  for (const float weight_a : {0.5f, 0.4f, 0.6f}) {
    BlendLayer layers[] = {{a.span(), weight_a, {}}, {b.span(), 1.0f - weight_a, {}}};
    EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), out.span()}), ErrorCode::ok);
    EXPECT_EQ(quat_dot(out.span().get(0).rotation, q) > 0, weight_a >= 0.5f) << weight_a;
  }
}

TEST(blend_poses, N02_opposite_rotations_blend_to_themselves_not_to_zero) {
  PoseBuffer a(1), b(1), rest(1), out(1);
  const glm::quat q = quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f);
  a.span().set(0, {{}, q, {1, 1, 1}});
  b.span().set(0, {{}, -q, {1, 1, 1}});
  BlendLayer layers[] = {{a.span(), 0.5f, {}}, {b.span(), 0.5f, {}}};
  EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), out.span()}), ErrorCode::ok);
  EXPECT_TRUE(test::same_rotation(out.span().get(0).rotation, q, 1e-7));
}

TEST(blend_poses, N26_weights_too_small_to_matter_count_as_none) {
  test::FixedRandom random(26);
  PoseBuffer a = random_pose(random, 3), b = random_pose(random, 3), rest(3), out(3);
  // The length shows that nothing was blended: a blend would normalise.
  for (std::size_t j = 0; j < 3; ++j) a.span().set(j, {{1, 2, 3}, random.rotation() * 0.5f, {1, 1, 1}});
  BlendLayer layers[] = {{a.span(), 1.0f, {}}, {b.span(), 1e-30f, {}}};
  EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), out.span()}), ErrorCode::ok);
  for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(out.span().get(j), a.span().get(j));
}

TEST(blend_poses, N26_weights_of_any_size_blend_by_their_shares) {
  test::FixedRandom random(27);
  PoseBuffer a = random_pose(random, 5), b = random_pose(random, 5), rest(5), shares(5), out(5);
  EXPECT_EQ(run(BlendPosesJob{std::array<BlendLayer, 2>{{{a.span(), 0.25f, {}}, {b.span(), 0.75f, {}}}}, rest.span(),
                              shares.span()}),
            ErrorCode::ok);
  EXPECT_EQ(run(BlendPosesJob{std::array<BlendLayer, 2>{{{a.span(), 1e25f, {}}, {b.span(), 3e25f, {}}}}, rest.span(),
                              out.span()}),
            ErrorCode::ok);
  for (std::size_t j = 0; j < 5; ++j) {
    const Transform found = out.span().get(j), expected = shares.span().get(j);
    EXPECT_LT(glm::length(found.translation - expected.translation), 1e-5f);
    EXPECT_LT(glm::length(found.scale - expected.scale), 1e-5f);
    EXPECT_TRUE(test::same_rotation(found.rotation, expected.rotation, 1e-6));
  }
}

TEST(blend_poses, output_may_be_an_input) {
  test::FixedRandom random(7);
  PoseBuffer a = random_pose(random, 20), b = random_pose(random, 20), rest(20), out(20);
  BlendLayer layers[] = {{a.span(), 0.25f, {}}, {b.span(), 0.75f, {}}};
  EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), out.span()}), ErrorCode::ok);
  EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), b.span()}), ErrorCode::ok);
  for (std::size_t j = 0; j < 20; ++j) EXPECT_EQ(out.span().get(j), b.span().get(j));
}

TEST(blend_poses, allocates_nothing_and_takes_no_joints) {
  PoseBuffer a(0), rest(0), out(0), b(30);
  BlendLayer none[] = {{a.span(), 1.0f, {}}}, some[] = {{b.span(), 0.4f, {}}};
  const BlendPosesJob job{none, rest.span(), out.span()};
  EXPECT_EQ(check(job), ErrorCode::ok);
  const test::AllocationCounter counter;
  EXPECT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(run(BlendPosesJob{some, b.span(), b.span()}), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace sinew
