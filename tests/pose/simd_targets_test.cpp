// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>

#include "runtime/pose/blend_poses.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "tests/support/simd_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr std::uint32_t kTargetJoints = 53;  // not a multiple of any vector length

void append(std::vector<float>& numbers, const std::vector<Affine>& matrices) {
  for (const Affine& m : matrices)
    for (const glm::vec4& row : m.row) numbers.insert(numbers.end(), {row.x, row.y, row.z, row.w});
}

/// Poses of a clip with all kinds of tracks, their blends and model matrices.
std::vector<float> results() {
  test::FixedRandom random(27);
  std::vector<std::vector<float>> times{test::random_times(random, 12), test::random_times(random, 9)};
  std::vector<BoneAnimation> bones(kTargetJoints);
  for (std::uint32_t j = 0; j < kTargetJoints; ++j) {
    const bool cubic = random.below(3) == 0;
    bones[j].joint = j;
    bones[j].rotation =
        test::random_rotations(random, cubic ? Interpolation::cubic_spline : Interpolation::linear, times[j % 7 == 0]);
    bones[j].translation =
        test::random_vectors(random, cubic ? Interpolation::linear : Interpolation::cubic_spline, times[j % 5 == 0]);
  }
  const Skeleton skeleton = test::chain_skeleton(kTargetJoints);
  const Clip clip = test::clip_of(test::animation_of(std::move(bones)), skeleton);
  std::vector<Affine> model(kTargetJoints);
  test::PoseBuffer a(kTargetJoints), b(kTargetJoints), rest(kTargetJoints), out(kTargetJoints);
  std::vector<float> mask(kTargetJoints);
  for (float& m : mask) m = static_cast<float>(random.unit());
  std::vector<float> numbers;
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(
        run(SampleClipJob{.clip = &clip, .time_s = random.in(0, clip.duration_s()), .pose = a.span(), .weights = {}}),
        ErrorCode::ok);
    EXPECT_EQ(
        run(SampleClipJob{.clip = &clip, .time_s = random.in(0, clip.duration_s()), .pose = b.span(), .weights = {}}),
        ErrorCode::ok);
    const BlendLayer layers[] = {{a.span(), 0.4f, {}}, {b.span(), 0.7f, mask}};
    EXPECT_EQ(run(BlendPosesJob{layers, rest.span(), out.span()}), ErrorCode::ok);
    EXPECT_EQ(run(LocalToModelJob{&skeleton, out.span(), {}, model}), ErrorCode::ok);
    append(numbers, model);
    for (const PoseSpan& pose : {a.span(), out.span()})
      for (std::size_t p = 0; p < PoseSpan::plane_count; ++p)
        numbers.insert(numbers.end(), pose.plane(PoseSpan::Plane(p)), pose.plane(PoseSpan::Plane(p)) + kTargetJoints);
  }
  return numbers;
}

TEST(simd_targets, N27_N28_every_instruction_set_gives_the_same_bits) {
  const std::vector<float> expected = results();
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    const std::vector<float> found = results();
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(float)), 0) << test::simd_name(target);
  }
  EXPECT_FALSE(test::simd_targets().empty());
}

TEST(simd_targets, N28_model_matrices_have_the_bits_of_the_plain_product) {
  test::FixedRandom random(28);
  Skeleton skeleton = test::chain_skeleton(kTargetJoints);
  skeleton.fixed_matrices.push_back(affine_from_transform(random.transform()));
  skeleton.fixed_matrix_of[20] = 0;
  test::PoseBuffer pose(kTargetJoints);
  for (std::size_t j = 0; j < kTargetJoints; ++j) pose.span().set(j, random.transform(0.9, 1.1));
  const Affine root = affine_from_transform(random.transform());
  std::vector<Affine> model(kTargetJoints);
  EXPECT_EQ(run(LocalToModelJob{&skeleton, pose.span(), root, model}), ErrorCode::ok);
  Affine expected = root;
  for (std::size_t j = 0; j < kTargetJoints; ++j) {
    expected = expected * (j == 20 ? skeleton.fixed_matrices[0] : affine_from_transform(pose.span().get(j)));
    EXPECT_EQ(model[j], expected) << j;
  }
}

}  // namespace
}  // namespace sinew
