// SPDX-License-Identifier: MIT
// Masks of the input, which may change from frame to frame, in layers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/base/same_bits.h"
#include "tests/plan/frame_equality.h"
#include "tests/plan/program_scene.h"

namespace sinew::test {
namespace {

/// A mask of the input in place of that of the needs, which is shorter by one.
FrameInput masked_by_input(const ProgramScene& actor, std::span<const ClipLayer> layers) {
  FrameInput input{.layers = layers, .weights = {}, .root = {}};
  input.program_inputs.masks = {&actor.mask, 1};
  return input;
}

TEST(input_masks, layers_name_masks_of_the_input_after_those_of_the_needs) {
  ProgramScene actor(3);
  Needs needs = actor.plan.needs();
  needs.in.masks.push_back(actor.mask_weights);
  const Plan planned = compile_plan(lend(actor.scene), needs);
  FrameBuffer by_needs(planned), by_input(actor.plan);
  ClipLayer layers[] = {{0, 0.3, 0.5f}, {1, 0.7, 0.5f, 1}, {0, 0.4, 0.5f, 1, LayerKind::add_to_rest}};
  for (int frame = 0; frame < 3; ++frame) {
    if (frame == 2) layers[0].time_s = 0.35;
    ASSERT_EQ(run_plan(planned, {.layers = layers, .weights = {}, .root = {}}, by_needs), ErrorCode::ok);
    ASSERT_EQ(run_plan(actor.plan, masked_by_input(actor, layers), by_input), ErrorCode::ok);
    EXPECT_EQ(first_difference(by_needs.result(), by_input.result()), "") << frame;
    EXPECT_EQ(by_input.result().work.clips_sampled, frame == 1 ? 0u : 3u) << "an equal version is an equal mask";
  }
  std::fill(actor.mask_weights.begin(), actor.mask_weights.end(), 0.0f);
  actor.mask.version = 2;
  ASSERT_EQ(run_plan(actor.plan, masked_by_input(actor, layers), by_input), ErrorCode::ok);
  const ClipLayer unmasked[] = {layers[0]};
  FrameBuffer alone(actor.plan);
  ASSERT_EQ(run_plan(actor.plan, {.layers = unmasked, .weights = {}, .root = {}}, alone), ErrorCode::ok);
  for (std::size_t j = 0; j < actor.scene.skeleton.joint_count(); ++j)
    EXPECT_TRUE(same_bits(alone.result().local.get(j), by_input.result().local.get(j))) << j;
  layers[1].mask = 2;
  EXPECT_EQ(run_plan(actor.plan, masked_by_input(actor, layers), by_input), ErrorCode::index_out_of_range);
}

TEST(input_masks, poses_between_updates_follow_a_mask_of_the_input_that_changes) {
  ProgramScene actor(3);
  Needs needs = actor.plan.needs();
  needs.in.between_updates = true;
  const Plan plan = compile_plan(lend(actor.scene), needs);
  const ClipLayer layers[] = {{0, 0.3, 0.5f}, {1, 0.7, 0.5f, 1}}, next[] = {{0, 0.4, 0.5f}, {1, 0.8, 0.5f, 1}};
  FrameBuffer kept(plan);
  for (int frame = 0; frame < 3; ++frame) {
    FrameInput input = masked_by_input(actor, layers);
    input.next_layers = next;
    input.interpolation_factor = 0.25f * static_cast<float>(1 + frame);
    FrameBuffer fresh(plan);
    ASSERT_EQ(run_plan(plan, input, kept), ErrorCode::ok);
    ASSERT_EQ(run_plan(plan, input, fresh), ErrorCode::ok);
    EXPECT_EQ(first_difference(fresh.result(), kept.result()), "") << frame;
    actor.mask_weights[1] += 0.5f;
    ++actor.mask.version;
  }
}

}  // namespace
}  // namespace sinew::test
