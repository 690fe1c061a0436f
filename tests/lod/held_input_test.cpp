// SPDX-License-Identifier: MIT
// HeldInput must hold every field of the input.
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/lod/update_rate.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

bool same_layer(const ClipLayer& a, const ClipLayer& b) {
  return a.clip == b.clip && a.time_s == b.time_s && a.weight == b.weight && a.mask == b.mask && a.kind == b.kind;
}

/// Compares all fields. When FrameInput gains a field, this does not compile until the field is compared too.
void expect_same_input(const FrameInput& a, const FrameInput& b) {
  const auto& [layers, weights, root, next_layers, interpolation_factor, out_of_view, geometry, program, inputs,
               asleep] = a;
  EXPECT_TRUE(std::ranges::equal(layers, b.layers, same_layer));
  EXPECT_TRUE(std::ranges::equal(weights, b.weights));
  EXPECT_EQ(root, b.root);
  EXPECT_TRUE(std::ranges::equal(next_layers, b.next_layers, same_layer));
  EXPECT_EQ(interpolation_factor, b.interpolation_factor);
  EXPECT_TRUE(std::ranges::equal(out_of_view, b.out_of_view));
  EXPECT_TRUE(std::ranges::equal(geometry, b.geometry, same_geometry));
  EXPECT_TRUE(std::ranges::equal(program, b.program));
  const auto& [externals, overrides, procedures, masks, pages] = inputs;
  EXPECT_EQ(externals.size(), b.program_inputs.externals.size());  // pose_programs_test.cpp has what is in them
  EXPECT_EQ(overrides.size(), b.program_inputs.overrides.size());
  EXPECT_EQ(procedures.size(), b.program_inputs.procedures.size());
  EXPECT_EQ(masks.size(), b.program_inputs.masks.size());
  EXPECT_TRUE(std::ranges::equal(pages, b.program_inputs.pages));
  EXPECT_EQ(asleep, b.asleep);
}

/// A source that never has a frame loaded.
GeometryInput late_geometry(float number) {
  VertexSource source;
  source.has = [](const void*, std::uint32_t) noexcept { return true; };
  source.show = [](void*, std::uint32_t, double) noexcept { return ShownVertices{}; };
  source.content = 7;
  return {.source = source, .time_s = number, .weight = number};
}

/// An input with no field at its default, and the arrays behind its views.
struct FullInput {
  FullInput(const Scene& scene, float number)
      : layers{{0, number, 0.5f}, {1, 0.5, number}},
        next_layers{{1, number, 0.25f}},
        weights(scene.weight_count(), number),
        out_of_view(scene.instances.size(), 1),
        geometry{late_geometry(number)} {
    input.layers = layers;
    input.next_layers = next_layers;
    input.weights = weights;
    input.out_of_view = out_of_view;
    input.geometry = geometry;
    program.rest(number);
    input.program = program.ops();
    input.program_inputs = {.overrides = {&overrides, 1}, .masks = {}, .pages = pages};
    input.root.row[0].w = number;
    input.interpolation_factor = number;
  }
  FullInput(const FullInput&) = delete;
  FullInput& operator=(const FullInput&) = delete;

  std::vector<ClipLayer> layers, next_layers;
  std::vector<float> weights;
  std::vector<std::uint8_t> out_of_view;
  std::vector<GeometryInput> geometry;
  PoseProgram program;
  JointOverrides overrides;
  std::vector<const Clip*> pages = {nullptr};
  FrameInput input;
};

struct HeldInputTest : testing::Test {
  HeldInputTest() : scene(random_scene(3)) {
    Needs needs;
    needs.in.between_updates = true;
    needs.in.cached_instances = {0};
    needs.in.program = {.ops = 1, .slots = 1, .overrides = 1};
    plan = compile_plan(lend(scene), needs);
  }
  Scene scene;
  Plan plan;
};

using held_input = HeldInputTest;

TEST_F(held_input, a_copy_has_every_field_and_views_nothing_of_the_caller) {
  InputCopy copy(plan);
  const FullInput expected(scene, 0.25f);
  {
    FullInput given(scene, 0.25f);
    given.input.asleep = true;
    const AllocationCounter counter;
    EXPECT_EQ(copy.check_room(given.input), ErrorCode::ok);
    copy.assign(given.input);
    EXPECT_EQ(counter.count(), 0u);
    std::fill(given.weights.begin(), given.weights.end(), -1.0f);
    given.layers[0].clip = given.next_layers[0].clip = 77;
    given.out_of_view[0] = 0;
    given.geometry[0].time_s = 99.0;
  }
  FrameInput asleep = expected.input;
  asleep.asleep = true;
  expect_same_input(copy.view(), asleep);
}

TEST_F(held_input, frames_in_between_get_all_of_the_input_that_is_held_but_what_is_out_of_view) {
  HeldInput held(plan);
  const FullInput first(scene, 0.25f), second(scene, 0.75f), third(scene, 0.5f);
  expect_same_input(held.next(first.input, UpdateLevel::every_second, 0, 0), first.input);

  FrameInput now = second.input;
  now.out_of_view = {};
  FrameInput expected = first.input;
  expected.out_of_view = {};
  expect_same_input(held.next(now, UpdateLevel::every_second, 1, 0), expected);
  expect_same_input(held.next(third.input, UpdateLevel::every_second, 2, 0), third.input);
}

TEST_F(held_input, a_pose_between_two_updates_is_held_to_the_bit) {
  HeldInput held(plan);
  FrameBuffer buffer(plan), expected(plan);
  FullInput first(scene, 0.25f), second(scene, 0.75f);
  first.input.program = second.input.program = {};  // which excludes layers
  ASSERT_EQ(run_plan(plan, first.input, expected), ErrorCode::ok);
  ASSERT_EQ(run_plan(plan, held.next(first.input, UpdateLevel::every_fourth, 0, 0), buffer), ErrorCode::ok);
  for (std::uint64_t frame = 1; frame < 4; ++frame) {
    ASSERT_EQ(run_plan(plan, held.next(second.input, UpdateLevel::every_fourth, frame, 0), buffer), ErrorCode::ok);
    EXPECT_EQ(buffer.result().work, WorkCounters{});
    EXPECT_TRUE(same_bits<Affine>(buffer.result().model, expected.result().model));
  }
}

}  // namespace
}  // namespace sinew::test
