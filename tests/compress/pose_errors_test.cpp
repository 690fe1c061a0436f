// SPDX-License-Identifier: MIT
#include "runtime/compress/pose_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/simd_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

/// A tree with random fixed matrices at some joints, and several roots.
Skeleton random_skeleton(test::FixedRandom& random, std::uint32_t count) {
  std::vector<std::uint32_t> parents(count, kNone);
  for (std::uint32_t j = 1; j < count; ++j)
    if (j % 7 != 6) parents[j] = (j - 1) / 2;
  Skeleton skeleton = test::skeleton_of(std::move(parents));
  for (std::uint32_t j = 0; j < count; j += 5) {
    skeleton.fixed_matrix_of[j] = static_cast<std::uint32_t>(skeleton.fixed_matrices.size());
    skeleton.fixed_matrices.push_back(affine_from_transform(random.transform()));
  }
  return skeleton;
}

struct Block {
  Skeleton skeleton;
  std::vector<Aabb> boxes;
  std::vector<std::vector<Transformd>> locals;   // [poses][J]
  std::vector<std::vector<BoxCorners>> corners;  // [poses][J] of the truth
};

Block random_block(std::uint64_t seed, std::uint32_t joints, std::size_t poses) {
  test::FixedRandom random(seed);
  Block block{random_skeleton(random, joints), {}, {}, {}};
  for (std::uint32_t j = 0; j < joints; ++j) {
    Aabb& box = block.boxes.emplace_back();
    box.add(random.vec3(-1, 1));
    box.add(random.vec3(-1, 1));
  }
  for (std::size_t p = 0; p < poses; ++p) {
    std::vector<Transformd>& local = block.locals.emplace_back();
    std::vector<BoxCorners>& corners = block.corners.emplace_back();
    for (const Aabb& box : block.boxes) {
      local.push_back(in_double(random.transform()));
      corners.push_back(corners_in_model(affine_from_transform(in_double(random.transform())), box));
    }
  }
  return block;
}

/// The equation of the header, joint by joint.
std::vector<double> truth_of(const Block& block) {
  std::vector<double> squared;
  std::vector<Affined> model(block.boxes.size());
  for (std::size_t p = 0; p < block.locals.size(); ++p) {
    model_from_local(block.skeleton, block.locals[p], model);
    for (std::size_t j = 0; j < model.size(); ++j) {
      const BoxCorners at = corners_in_model(model[j], block.boxes[j]);
      double largest = 0.0;
      for (std::size_t c = 0; c < 8; ++c) {
        const auto away = [&](std::size_t axis) { return at[axis][c] - block.corners[p][j][axis][c]; };
        const double square = away(0) * away(0) + away(1) * away(1) + away(2) * away(2);
        if (square > largest) largest = square;
      }
      squared.push_back(largest);
    }
  }
  return squared;
}

/// The largest of every `stride`-th number from `first` on, at most `count`.
double largest_of(const std::vector<double>& numbers, std::size_t first, std::size_t stride, std::size_t count) {
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, numbers[first + i * stride]);
  return largest;
}

std::vector<double> errors_of(const Block& block) {
  const std::size_t joints = block.boxes.size();
  PoseBlock poses(joints);
  std::vector<const BoxCorners*> truth;
  for (std::size_t p = 0; p < block.locals.size(); ++p) {
    for (std::size_t j = 0; j < joints; ++j) poses.set(p, j, block.locals[p][j]);
    truth.push_back(block.corners[p].data());
  }
  std::vector<double> models(joints * PoseErrorsJob::kModelNumbers), squared(joints * truth.size(), -1.0);
  std::vector<double> largest(joints, 0.25), worst(truth.size(), 1e9);
  const PoseErrorsJob job{.skeleton = &block.skeleton,
                          .boxes = block.boxes,
                          .poses = &poses,
                          .truth = truth,
                          .models = models,
                          .squared = squared,
                          .largest = largest,
                          .worst = worst};
  EXPECT_EQ(check(job), ErrorCode::ok);
  run_unchecked(job);
  for (std::size_t j = 0; j < joints; ++j)
    EXPECT_EQ(largest[j], std::max(0.25, largest_of(squared, j, joints, truth.size())));
  for (std::size_t p = 0; p < truth.size(); ++p) EXPECT_EQ(worst[p], largest_of(squared, p * joints, 1, joints));
  return squared;
}

TEST(pose_errors, every_instruction_set_gives_the_bits_of_the_plain_equation) {
  for (const std::uint32_t joints : {1u, 2u, 23u})
    for (std::size_t poses = 0; poses <= PoseBlock::kPoses; ++poses) {
      const Block block = random_block(10 * joints + poses, joints, poses);
      const std::vector<double> truth = truth_of(block);
      for (const std::int64_t target : test::simd_targets()) {
        const test::OnlyTarget only(target);
        EXPECT_EQ(errors_of(block), truth) << test::simd_name(target) << " " << joints << " " << poses;
      }
    }
}

TEST(pose_errors, numbers_that_are_not_finite_count_as_no_error) {
  Block block = random_block(5, 3, 2);
  block.locals[1][2].translation.x = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> errors = errors_of(block);
  EXPECT_EQ(errors, truth_of(block));
  EXPECT_EQ(errors[5], 0.0);
  EXPECT_GT(errors[2], 0.0);
}

TEST(pose_errors, refuses_memory_that_is_too_small) {
  const Block block = random_block(6, 3, 2);
  PoseBlock poses(3), fewer(2);
  std::vector<double> models(3 * PoseErrorsJob::kModelNumbers), squared(6), largest(3), worst(2);
  const std::vector<const BoxCorners*> truth{block.corners[0].data(), block.corners[1].data()}, many(9, truth[0]);
  const PoseErrorsJob good{&block.skeleton, block.boxes, &poses, truth, models, squared, largest, worst};
  EXPECT_EQ(check(good), ErrorCode::ok);
  std::vector<PoseErrorsJob> bad(8, good);
  bad[0].skeleton = nullptr;
  bad[1].poses = &fewer;
  bad[2].boxes = bad[2].boxes.first(2);
  bad[3].truth = many;
  bad[4].models = bad[4].models.first(models.size() - 1);
  bad[5].squared = bad[5].squared.first(5);
  bad[6].largest = bad[6].largest.first(2);
  bad[7].worst = bad[7].worst.first(1);
  for (const PoseErrorsJob& job : bad) EXPECT_EQ(check(job), ErrorCode::size_mismatch) << &job - bad.data();
}

}  // namespace
}  // namespace sinew
