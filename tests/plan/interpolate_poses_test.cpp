// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/interpolate_poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/animation/truth_pose.h"
#include "runtime/base/same_bits.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

Needs between() {
  Needs needs;
  needs.in.between_updates = true;
  needs.in.additive = true;
  return needs;
}

FrameInput from_to(std::span<const ClipLayer> layers, std::span<const ClipLayer> ahead, float interpolation_factor) {
  FrameInput input;
  input.layers = layers;
  input.next_layers = ahead;
  input.interpolation_factor = interpolation_factor;
  return input;
}

const FrameResult& run(const Plan& plan, const FrameInput& input, FrameBuffer& frame) {
  EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  return frame.result();
}

void expect_same(const FrameResult& a, const FrameResult& b) {
  EXPECT_TRUE(same_bits<Affine>(a.model, b.model));
  EXPECT_TRUE(same_bits<float>(a.weights, b.weights));
  EXPECT_TRUE(same_bits<float>(a.properties, b.properties));
  for (std::size_t p = 0; p < a.primitives.size(); ++p)
    EXPECT_TRUE(same_bits<glm::vec3>(a.primitives[p].positions, b.primitives[p].positions));
}

const std::vector<ClipLayer> kStart = {{0, 0.31, 0.7f}, {1, 0.2, 0.3f}},
                             kEnd = {{0, 0.41, 0.4f}, {1, 0.3, 0.4f}, {0, 1.0, 0.5f, kNone, LayerKind::add_to_start}};

TEST(interpolate_poses, N27_at_both_ends_frames_have_the_bits_of_frames_without_it) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Scene scene = random_scene(seed);
    Needs needs = between();
    const Plan plan = compile_plan(lend(scene), needs);
    needs.in.between_updates = false;
    const Plan plain = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan), expected(plain);
    expect_same(run(plan, from_to(kStart, kEnd, 0.0f), frame), run(plain, from_to(kStart, {}, 0.0f), expected));
    expect_same(run(plan, from_to(kStart, kEnd, 1.0f), frame), run(plain, from_to(kEnd, {}, 0.0f), expected));
    expect_same(run(plan, from_to({}, kEnd, 0.0f), frame), run(plain, {}, expected));
  }
}

/// Local transforms of all joints at a time of the first clip, in double.
std::vector<Transformd> locals_at(const Scene& scene, double time_s) {
  TruthPose pose;
  evaluate_truth(scene.animations[0], scene.skeleton, time_s, pose);
  return pose.local;
}

TEST(interpolate_poses, N17_between_them_rotations_take_the_shorter_arc_and_numbers_the_straight_line) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Scene scene = random_scene(seed);
    const Plan plan = compile_plan(lend(scene), between());
    FrameBuffer frame(plan), at_start(plan), at_end(plan);
    const ClipLayer start{0, 0.4}, end{0, 0.9};
    const std::vector<Transformd> a = locals_at(scene, start.time_s), b = locals_at(scene, end.time_s);
    const FrameResult &from = run(plan, from_to({&start, 1}, {}, 0.0f), at_start),
                      &to = run(plan, from_to({&end, 1}, {}, 0.0f), at_end);
    for (const float s : {0.25f, 0.5f, 0.9f}) {
      const double t = static_cast<double>(s);
      std::vector<Transformd> local;
      for (std::size_t j = 0; j < a.size(); ++j) {
        const Quat<double> q = normalised(a[j].rotation), r = aligned_with(q, normalised(b[j].rotation));
        local.push_back({(1.0 - t) * a[j].translation + t * b[j].translation, normalised(q * (1.0 - t) + r * t),
                         (1.0 - t) * a[j].scale + t * b[j].scale});
      }
      std::vector<Affined> model(local.size());
      model_from_local(scene.skeleton, local, model);
      const FrameResult& found = run(plan, from_to({&start, 1}, {&end, 1}, s), frame);
      for (std::size_t j = 0; j < model.size(); ++j)
        for (int r = 0; r < 3; ++r)
          EXPECT_LT(glm::length(Vec4<double>(found.model[j].row[r]) - model[j].row[r]), 2e-5)
              << "seed " << seed << " joint " << j;
      for (std::size_t w = 0; w < found.weights.size(); ++w)
        EXPECT_NEAR(static_cast<double>(found.weights[w]),
                    (1.0 - t) * static_cast<double>(from.weights[w]) + t * static_cast<double>(to.weights[w]), 1e-6);
    }
  }
}

TEST(interpolate_poses, P19_each_end_is_sampled_once_however_many_frames_lie_between) {
  const Scene scene = random_scene(4);
  const Plan plan = compile_plan(lend(scene), between());
  FrameBuffer frame(plan);
  const std::uint64_t tracks = plan.clip_tracks()[0].joints + plan.clip_tracks()[0].weights;
  std::uint64_t sampled = 0, interpolated = 0;
  const AllocationCounter counter;
  for (int n = 0; n < 40; ++n) {  // ten intervals of four frames
    const ClipLayer start{0, 0.04 * (n / 4)}, end{0, 0.04 * (n / 4 + 1)};
    const FrameResult& result = run(plan, from_to({&start, 1}, {&end, 1}, 0.25f * static_cast<float>(n % 4)), frame);
    sampled += result.work.tracks_sampled;
    interpolated += result.work.poses_interpolated;
  }
  EXPECT_EQ(sampled, 11 * tracks) << "one more than intervals: the last one's end";
  EXPECT_EQ(interpolated, 30u);
  EXPECT_EQ(counter.count(), 0u);
}

TEST(interpolate_poses, P19_buffers_that_take_turns_share_the_ends) {
  const Scene scene = random_scene(4);
  const Plan plan = compile_plan(lend(scene), between());
  FrameBuffer buffers[3] = {FrameBuffer(plan), FrameBuffer(plan), FrameBuffer(plan)}, alone(plan);
  std::uint64_t sampled = 0, sampled_alone = 0;
  for (std::uint64_t n = 0; n < 40; ++n) {
    const ClipLayer start{0, 0.04 * static_cast<double>(n / 4)}, end{0, 0.04 * static_cast<double>(n / 4 + 1)};
    const FrameInput input = from_to({&start, 1}, {&end, 1}, 0.25f * static_cast<float>(n % 4));
    FrameBuffer& frame = buffers[n % 3];
    frame.count_from(n);
    if (n > 0) frame.follow(buffers[(n - 1) % 3]);
    expect_same(run(plan, input, frame), run(plan, input, alone));
    sampled += frame.result().work.tracks_sampled;
    sampled_alone += alone.result().work.tracks_sampled;
  }
  EXPECT_EQ(sampled, sampled_alone);
}

TEST(interpolate_poses, N27_frames_do_not_depend_on_those_before) {
  const Scene scene = random_scene(9);
  const Plan plan = compile_plan(lend(scene), between());
  FrameBuffer used(plan);
  const FrameInput inputs[] = {from_to(kStart, kEnd, 0.5f), from_to(kEnd, kStart, 0.25f), from_to(kEnd, {}, 0.75f),
                               from_to({}, kEnd, 0.5f),     from_to(kStart, kEnd, 0.5f),  from_to(kEnd, kEnd, 0.5f),
                               from_to(kStart, kEnd, 0.0f)};
  for (const FrameInput& input : inputs)
    for (int again = 0; again < 2; ++again) {
      FrameBuffer fresh(plan);
      expect_same(run(plan, input, used), run(plan, input, fresh));
      EXPECT_EQ(used.result().work == WorkCounters{}, again == 1);
    }
}

/// Each input differs from the others in one part only; some poses are at rest. A frame must never reuse a result that
/// belongs to another input.
TEST(interpolate_poses, N27_any_frame_may_follow_any_other) {
  Scene scene = random_scene(9);
  const auto still = static_cast<std::uint32_t>(scene.animations.size());  // its joints stay at rest
  scene.animations.push_back({"still", 1.0, {}, {}});
  finish_scene(scene);
  Needs needs = between();
  needs.out.properties = true;
  const Plan plan = compile_plan(lend(scene), needs);
  const std::vector<ClipLayer> rest = {{still, 0.5}}, moved = {{0, 0.7}}, later = {{0, 0.8}}, other = {{1, 0.7}},
                               weaker = {{0, 0.7, 0.5f}};
  const FrameInput inputs[] = {from_to(rest, {}, 0.0f),      from_to(moved, {}, 0.0f),   from_to(rest, moved, 0.5f),
                               from_to(rest, moved, 0.75f),  from_to(rest, later, 0.5f), from_to(rest, other, 0.5f),
                               from_to(rest, weaker, 0.5f),  from_to(rest, rest, 0.5f),  from_to(moved, rest, 0.5f),
                               from_to(kStart, moved, 0.5f), from_to(rest, kEnd, 0.5f),  from_to(rest, {}, 0.5f)};
  for (const FrameInput& first : inputs)
    for (const FrameInput& second : inputs) {
      FrameBuffer used(plan), fresh(plan);
      run(plan, first, used);
      expect_same(run(plan, second, used), run(plan, second, fresh));
    }
}

TEST(interpolate_poses, weights_of_the_caller_are_those_of_the_frame) {
  const Scene scene = random_scene(4);
  const Plan plan = compile_plan(lend(scene), between());
  FrameBuffer frame(plan);
  const std::vector<float> given(scene.weight_count(), 0.625f);
  FrameInput input = from_to(kStart, kEnd, 0.5f);
  input.weights = given;
  EXPECT_TRUE(same_bits<float>(run(plan, input, frame).weights, given));
  input.weights = {};
  FrameBuffer fresh(plan);
  expect_same(run(plan, input, frame), run(plan, input, fresh));
}

TEST(interpolate_poses, what_nobody_asks_for_takes_no_memory_and_is_refused) {
  const Scene scene = random_scene(4);
  Needs needs = between();
  const Plan plan = compile_plan(lend(scene), needs);
  needs.in.between_updates = false;
  const Plan plain = compile_plan(lend(scene), needs);
  EXPECT_GT(plan.frame_bytes(), plain.frame_bytes());
  FrameBuffer frame(plain), asked(plan);
  EXPECT_EQ(run_plan(plain, from_to(kStart, kEnd, 0.5f), frame), ErrorCode::not_in_needs);
  EXPECT_EQ(run_plan(plain, from_to(kStart, kEnd, 0.0f), frame), ErrorCode::ok);
  for (const float wrong : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(run_plan(plan, from_to(kStart, kEnd, wrong), asked), ErrorCode::not_a_fraction);
  const ClipLayer nowhere{99, 0.0};
  EXPECT_EQ(run_plan(plan, from_to(kStart, {&nowhere, 1}, 0.5f), asked), ErrorCode::index_out_of_range);
  EXPECT_EQ(run_plan(plan, from_to(kStart, {&nowhere, 1}, 0.0f), asked), ErrorCode::ok) << "not looked at";
}

}  // namespace
}  // namespace sinew::test
