// SPDX-License-Identifier: MIT
#include "runtime/clip/decompile_clip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/base/same_bits.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/paging/cut_clip.h"
#include "tests/clip/varied_clip.h"

namespace sinew::test {
namespace {

/// The inputs of compile_clip for varied_clip (varied_clip.h), except the rest pose.
struct Rest {
  Skeleton skeleton = chain_skeleton(21);
  std::vector<float> weights{0.1f, 0.2f, 0.3f, 0.4f};
  std::vector<std::uint32_t> first{0, 4};
  PropertyTable properties;
};

bool samples_the_same(const Clip& a, const Clip& b) {
  const std::vector<float> x = samples_of(a), y = samples_of(b);
  return same_bits(std::span<const float>(x), std::span<const float>(y));
}

TEST(decompile_clip, compiled_again_it_samples_the_bits_of_the_unpacked_clip) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const Clip clip = varied_clip(seed);
    const Rest rest;  // its pose differs from that of the clip, which has its own copy
    const auto animation =
        decompile_clip(clip, clip_rest(rest.skeleton, rest.weights, rest.properties), rest.first, rest.properties);
    ASSERT_TRUE(animation);
    EXPECT_EQ(animation->name, clip.name());
    EXPECT_EQ(animation->duration_s, clip.duration_s());
    const Clip again = compile_clip(*animation, rest.skeleton, rest.weights, rest.first);
    EXPECT_TRUE(samples_the_same(again, unpacked(clip))) << seed;
    EXPECT_EQ(again.counts().rotations, clip.counts().rotations);
    EXPECT_EQ(again.counts().translations, clip.counts().translations);
    EXPECT_EQ(again.counts().weights, clip.counts().weights);
  }
}

TEST(decompile_clip, keys_that_were_never_rounded_come_back_as_they_were) {
  Rest rest;
  FixedRandom random(3);
  const std::vector<float> times = random_times(random, 5);
  Animation animation;
  for (const Interpolation kind :
       {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline, Interpolation::squad}) {
    BoneAnimation bone;
    bone.joint = static_cast<std::uint32_t>(animation.bones.size());
    bone.rotation = random_rotations(random, kind, times);
    if (kind != Interpolation::squad) bone.scale = random_vectors(random, kind, times);
    animation.bones.push_back(bone);
  }
  animation.weights.push_back({0, random_weights(random, Interpolation::cubic_spline, times, 2), 1});
  animation.duration_s = 9.0;
  const Clip clip = compile_clip(animation, rest.skeleton, rest.weights, rest.first);
  const auto found = decompile_clip(clip, clip_rest(rest.skeleton, rest.weights, rest.properties), rest.first, {});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->bones.size(), animation.bones.size());
  for (std::size_t b = 0; b < animation.bones.size(); ++b) {
    EXPECT_EQ(found->bones[b].joint, animation.bones[b].joint);
    EXPECT_EQ(found->bones[b].rotation.times_s, animation.bones[b].rotation.times_s);
    EXPECT_TRUE(found->bones[b].rotation.values == animation.bones[b].rotation.values) << b;
    EXPECT_TRUE(found->bones[b].scale.values == animation.bones[b].scale.values) << b;
  }
  ASSERT_EQ(found->weights.size(), 1u);
  EXPECT_EQ(found->weights[0].first_target, 1u);
  EXPECT_EQ(found->weights[0].weights.values, animation.weights[0].weights.values);
}

TEST(decompile_clip, what_is_held_is_one_key_and_what_rests_is_none) {
  Rest rest;
  rest.properties.entries = {{{PropertyKind::metallic, 0}, 0, 1}, {{PropertyKind::roughness, 0}, 1, 1}};
  rest.properties.rest = {0.5f, 0.25f};
  Animation animation;
  BoneAnimation bone;
  bone.joint = 4;
  bone.translation = track_of<glm::vec3>(Interpolation::step, {0.0f}, {glm::vec3(1, 2, 3)});
  animation.bones.push_back(bone);
  animation.weights.push_back({0, {Interpolation::step, {0.0f}, {0.75f, 0.875f}, 2}, 2});
  animation.properties.push_back({{PropertyKind::roughness, 0}, {Interpolation::step, {0.0f}, {1.0f}, 1}});
  const Clip clip = compile_clip(animation, rest.skeleton, rest.weights, rest.first, rest.properties);
  const auto found =
      decompile_clip(clip, clip_rest(rest.skeleton, rest.weights, rest.properties), rest.first, rest.properties);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->bones.size(), 1u);
  EXPECT_EQ(found->bones[0].joint, 4u);
  EXPECT_EQ(found->bones[0].translation.values, std::vector{glm::vec3(1, 2, 3)});
  EXPECT_TRUE(found->bones[0].rotation.empty());
  ASSERT_EQ(found->weights.size(), 1u);
  EXPECT_EQ(found->weights[0].first_target, 2u);
  EXPECT_EQ(found->weights[0].weights.values, (std::vector{0.75f, 0.875f}));
  ASSERT_EQ(found->properties.size(), 1u);
  EXPECT_EQ(found->properties[0].target.kind, PropertyKind::roughness);
}

TEST(decompile_clip, a_single_key_of_any_interpolation_is_held) {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const Clip first = first_keys(varied_clip(seed));
    const Rest rest;
    const auto animation =
        decompile_clip(first, clip_rest(rest.skeleton, rest.weights, rest.properties), rest.first, rest.properties);
    ASSERT_TRUE(animation);
    for (const BoneAnimation& bone : animation->bones) {
      EXPECT_EQ(check(bone.translation), ErrorCode::ok);
      EXPECT_EQ(check(bone.rotation), ErrorCode::ok);
    }
    const Clip again = compile_clip(*animation, rest.skeleton, rest.weights, rest.first);
    EXPECT_TRUE(samples_the_same(again, unpacked(first))) << seed;
  }
}

TEST(decompile_clip, one_joint_moves_as_it_does_in_the_clip) {
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    const Clip clip = varied_clip(seed), played = unpacked(clip);
    PoseBuffer pose(clip.joint_count());
    for (std::uint32_t joint = 0; joint < clip.joint_count(); ++joint) {
      const BoneAnimation bone = decompile_joint(clip, joint);
      EXPECT_EQ(bone.joint, joint);
      for (double t = -0.2; t < 5.0; t += 0.11) {
        EXPECT_EQ(run(SampleClipJob{&played, t, pose.span(), {}}), ErrorCode::ok);
        const Transform expected = pose.span().get(joint);
        const Transformd found = bone.interpolate<double>(t, {});
        EXPECT_LE(glm::length(found.translation - glm::dvec3(expected.translation)), 1e-5) << joint << " at " << t;
        const Quat<double> rotation = aligned_with(found.rotation, quat_cast<double>(expected.rotation));
        EXPECT_LE(safe_length(rotation - found.rotation), 2e-6) << t;
        EXPECT_LE(glm::length(found.scale - glm::dvec3(expected.scale)), 1e-6) << t;
      }
    }
  }
}

TEST(decompile_clip, a_clip_of_other_instances_or_properties_is_refused) {
  Rest rest;
  FixedRandom random(5);
  Animation animation;
  animation.weights.push_back({0, random_weights(random, Interpolation::linear, {0.0f, 1.0f}, 4), 0});
  const Clip clip = compile_clip(animation, rest.skeleton, rest.weights, rest.first);
  const ClipRest of_two = clip_rest(rest.skeleton, rest.weights, {});
  EXPECT_TRUE(decompile_clip(clip, of_two, std::vector<std::uint32_t>{0, 4}, {}));
  EXPECT_EQ(decompile_clip(clip, of_two, std::vector<std::uint32_t>{0, 2, 4}, {}).error(), ErrorCode::unsupported);
}

TEST(decompile_clip, a_clip_that_moves_a_part_of_a_property_is_refused) {
  Rest rest;
  FixedRandom random(6);
  rest.properties.entries = {{{PropertyKind::light_color, 0}, 0, 3}, {{PropertyKind::light_color, 1}, 3, 3}};
  rest.properties.rest.assign(6, 1.0f);
  Animation animation;
  animation.properties.push_back(
      {{PropertyKind::light_color, 1}, random_weights(random, Interpolation::linear, {0.0f, 1.0f}, 3)});
  const Clip clip = compile_clip(animation, rest.skeleton, rest.weights, rest.first, rest.properties);
  const ClipRest same = clip_rest(rest.skeleton, rest.weights, rest.properties);
  ASSERT_TRUE(decompile_clip(clip, same, rest.first, rest.properties));
  PropertyTable shifted = rest.properties;  // same total, but other component counts
  shifted.entries[1] = {{PropertyKind::light_intensity, 1}, 4, 1};
  EXPECT_EQ(decompile_clip(clip, same, rest.first, shifted).error(), ErrorCode::unsupported);
  shifted.entries[1] = {{PropertyKind::texture_scale, 0}, 3, 2};
  EXPECT_EQ(decompile_clip(clip, same, rest.first, shifted).error(), ErrorCode::unsupported);
}

}  // namespace
}  // namespace sinew::test
