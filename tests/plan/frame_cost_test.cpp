// SPDX-License-Identifier: MIT
// Stages that are left out cost nothing: no work and no memory. No frame allocates.
#include <algorithm>
#include <new>

#include <gtest/gtest.h>

#include "runtime/plan/plan_stages.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

struct NamedCount {
  const char* stage;
  std::uint64_t work;
};

std::vector<NamedCount> work_of_stages(const WorkCounters& w) {
  return {{"sample", w.tracks_sampled},
          {"mirror", w.poses_mirrored},
          {"blend", w.poses_blended},
          {"add", w.poses_added},
          {"pose_program", w.poses_copied + w.poses_overlaid + w.joints_overridden + w.procedures_run},
          {"interpolate", w.poses_interpolated},
          {"correctives", w.poses_compared},
          {"local_to_model", w.joints_composed},
          {"palette", w.palette_entries},
          {"split_palette", w.palette_entries_split},
          {"combinations", w.combinations_blended},
          {"winding", w.windings_tested},
          {"morph", w.morph_deltas + w.vertices_morphed},
          {"skin_linear", w.vertices_skinned_linear},
          {"skin_dual_quaternion", w.vertices_skinned_dual_quaternion},
          {"geometry_cache", w.vertices_from_cache + w.vertices_blended + w.smooth_triangles + w.cache_frames_decoded},
          {"flat_normals", w.flat_triangles},
          {"bounds", w.bounds_vertices}};
}

Needs needs_by_bits(std::uint32_t bits) {
  Needs needs;
  needs.out.joints = bits & 1;
  needs.out.positions = bits & 2;
  needs.out.normals = bits & 4;
  needs.out.tangents = bits & 8;
  needs.out.bounds = bits & 16;
  needs.in.max_layers = bits & 32 ? 1 : 3;
  needs.skin.kind = bits & 64 ? Skinning::dual_quaternion : Skinning::linear;
  needs.out.weights = (bits & 1) == 0;
  needs.in.additive = bits & 8;
  return needs;
}

TEST(frame_cost, a_stage_left_out_does_exactly_nothing_and_one_that_runs_does_what_the_plan_says) {
  for (std::uint32_t seed = 0; seed < 16; ++seed) {
    RandomSceneOptions options;
    options.skins = seed & 1 ? 2 : 0;
    options.targets = seed & 2 ? 2 : 0;
    options.clips = seed & 4 ? 2 : 0;
    options.flat_normals = seed & 8;
    options.correctives = options.targets > 0 ? seed % 3 : 0;
    const Scene scene = random_scene(seed, options);
    for (std::uint32_t bits = 0; bits < 128; ++bits) {
      const Plan plan = compile_plan(lend(scene), needs_by_bits(bits));
      FrameBuffer frame(plan);
      std::vector<ClipLayer> layers;
      if (!scene.clips.empty()) layers.push_back({0, 0.4, 1.0f});
      if (!scene.clips.empty() && plan.needs().in.max_layers > 1) layers.push_back({1, 0.9, 0.5f});
      if (!scene.clips.empty() && plan.needs().in.additive)
        layers.push_back({1, 0.7, 0.5f, kNone, LayerKind::add_to_start});
      ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      for (const auto& [name, work] : work_of_stages(frame.result().work))
        EXPECT_EQ(work > 0, stage(plan, name).runs && (name != std::string("bounds") || stage(plan, name).count > 0))
            << name << " seed " << seed << " needs " << bits;
      EXPECT_EQ(frame.result().work.vertices_skinned_linear, stage(plan, "skin_linear").count);
      EXPECT_EQ(frame.result().work.vertices_skinned_dual_quaternion, stage(plan, "skin_dual_quaternion").count);
      EXPECT_EQ(frame.result().work.palette_entries, stage(plan, "palette").count);
      EXPECT_EQ(frame.result().work.combinations_blended, stage(plan, "combinations").count);
      EXPECT_EQ(frame.result().work.windings_tested, stage(plan, "winding").count);
      EXPECT_EQ(frame.result().work.poses_compared, stage(plan, "correctives").count);
      EXPECT_EQ(frame.result().work.joints_composed, stage(plan, "local_to_model").count);
      EXPECT_EQ(frame.result().work.flat_triangles, stage(plan, "flat_normals").count);
      EXPECT_EQ(frame.result().work.bounds_vertices, stage(plan, "bounds").count);
    }
  }
}

TEST(frame_cost, no_stage_changes_what_another_shows) {
  const Scene scene = random_scene(21);
  const ClipLayer layer{0, 0.4, 1.0f};
  const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
  Needs everything = needs_by_bits(31);
  const Plan whole = compile_plan(lend(scene), everything);
  FrameBuffer all(whole);
  ASSERT_EQ(run_plan(whole, input, all), ErrorCode::ok);
  for (std::uint32_t bits = 0; bits < 32; ++bits) {
    const Plan plan = compile_plan(lend(scene), needs_by_bits(bits));
    FrameBuffer some(plan);
    ASSERT_EQ(run_plan(plan, input, some), ErrorCode::ok);
    const auto same = [](const auto& a, const auto& b) {
      return a.empty() || std::equal(a.begin(), a.end(), b.begin(), b.end());
    };
    EXPECT_TRUE(same(some.result().model, all.result().model));
    for (std::size_t p = 0; p < plan.primitives().size(); ++p) {
      const DeformedPrimitive &a = some.result().primitives[p], &b = all.result().primitives[p];
      EXPECT_TRUE(same(a.positions, b.positions) && same(a.normals, b.normals) && same(a.tangents, b.tangents)) << bits;
      EXPECT_TRUE((bits & 2) != 0 || a.positions.empty());
      EXPECT_TRUE((bits & 4) != 0 || a.normals.empty());
      EXPECT_TRUE((bits & 8) != 0 || a.tangents.empty());
    }
  }
}

TEST(frame_cost, static_nodes_and_targets_of_weight_zero_do_not_change_the_work_of_animation) {
  RandomSceneOptions options;
  options.instances = 1;
  const Scene scene = random_scene(22, options);
  options.targets = 12;
  const Scene more_targets = random_scene(22, options);
  const ClipLayer layer{0, 0.4, 1.0f};
  const auto work = [&](const Scene& shown, std::vector<float> weights) {
    const Plan plan = compile_plan(lend(shown), {});
    FrameBuffer frame(plan);
    EXPECT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = weights, .root = {}}, frame), ErrorCode::ok);
    return frame.result().work;
  };
  EXPECT_EQ(work(scene, std::vector<float>(3, 0.0f)).morph_deltas, 0u);
  EXPECT_EQ(work(more_targets, std::vector<float>(12, 0.0f)).vertices_morphed, 0u);
  EXPECT_EQ(work(more_targets, std::vector<float>(12, 0.0f)).vertices_skinned_linear,
            work(scene, std::vector<float>(3, 0.0f)).vertices_skinned_linear);
}

TEST(frame_cost, a_frame_allocates_nothing) {
  for (std::uint32_t bits = 0; bits < 128; bits += 3) {
    RandomSceneOptions options;
    options.flat_normals = bits % 2;
    options.correctives = bits % 3;
    const Scene scene = random_scene(bits, options);
    const Plan plan = compile_plan(lend(scene), needs_by_bits(bits));
    FrameBuffer frame(plan);
    const AllocationCounter counter;
    for (const double time_s : {0.0, 0.7, 1.9}) {
      const ClipLayer layers[] = {{0, time_s, 1.0f}, {1, 0.9, 0.5f}};
      const std::size_t count = plan.needs().in.max_layers == 1 ? 1 : 2;
      ASSERT_EQ(run_plan(plan, {.layers = std::span(layers, count), .weights = {}, .root = {}}, frame), ErrorCode::ok);
    }
    EXPECT_EQ(counter.count(), 0u) << bits;
  }
}

TEST(frame_cost, the_counter_of_allocations_counts) {
  const AllocationCounter counter;
  // The operators are called by name, because a compiler may remove an unused new-expression.
  constexpr std::align_val_t kAlignment{64};
  ::operator delete(::operator new(10));
  ::operator delete(::operator new(640, kAlignment), kAlignment);
  EXPECT_EQ(counter.count(), 2u);
}

TEST(frame_cost, the_same_input_gives_the_same_bits_whatever_ran_before) {
  const Scene scene = random_scene(23);
  Needs needs;
  needs.out.bounds = true;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer fresh(plan), used(plan);
  const ClipLayer now[] = {{0, 0.4, 0.8f}, {1, 1.2, 0.1f}}, before{1, 1.9, 1.0f};
  const std::vector<float> odd(scene.weight_count(), 7.0f);
  ASSERT_EQ(run_plan(plan, {.layers = {&before, 1}, .weights = odd, .root = {}}, used), ErrorCode::ok);
  for (FrameBuffer* frame : {&fresh, &used})
    ASSERT_EQ(run_plan(plan, {.layers = now, .weights = {}, .root = {}}, *frame), ErrorCode::ok);
  for (std::size_t p = 0; p < plan.primitives().size(); ++p) {
    const DeformedPrimitive &a = fresh.result().primitives[p], &b = used.result().primitives[p];
    EXPECT_TRUE(std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(), b.positions.end()));
    EXPECT_TRUE(std::equal(a.normals.begin(), a.normals.end(), b.normals.begin(), b.normals.end()));
  }
  EXPECT_LE(used.result().work.vertices_skinned_linear, fresh.result().work.vertices_skinned_linear);
}

/// For each stage in order: true if it did work.
std::vector<bool> worked(const WorkCounters& w) {
  return {w.tracks_sampled > 0,
          w.poses_mirrored > 0,
          w.poses_blended > 0,
          w.poses_added > 0,
          w.poses_copied > 0,
          w.poses_interpolated > 0,
          w.poses_compared > 0,
          false,
          w.joints_composed > 0,
          w.palette_entries > 0,
          w.palette_entries_split > 0,
          w.combinations_blended > 0,
          w.windings_tested > 0,
          w.morph_deltas > 0,
          w.vertices_skinned_linear > 0,
          w.vertices_skinned_dual_quaternion > 0,
          w.vertices_skinned_center_of_rotation > 0,
          w.vertices_from_cache > 0,
          w.flat_triangles > 0,
          w.bounds_vertices > 0};
}

TEST(frame_cost, stages_have_times_when_asked_for_and_only_those_that_worked) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    RandomSceneOptions options;
    options.skins = seed & 1 ? 2 : 0;
    options.targets = seed & 2 ? 2 : 0;
    options.flat_normals = seed & 4;
    const Scene scene = random_scene(seed, options);
    Needs needs = needs_by_bits(127);
    needs.in.max_layers = 2;
    needs.out.stage_times = true;
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    const ClipLayer layers[] = {{0, 0.4, 1.0f}, {1, 0.9, 0.5f}, {1, 0.7, 0.5f, kNone, LayerKind::add_to_start}};
    ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    const std::vector<bool> expected = worked(frame.result().work);
    const std::vector<PlanStage> stages = plan.stages();
    ASSERT_EQ(frame.result().stage_ns.size(), stages.size());
    for (std::size_t s = 0; s < stages.size(); ++s) {
      if (stages[s].stage == "bounds" || stages[s].stage == "properties") continue;  // counters cover only a part
      EXPECT_EQ(frame.result().stage_ns[s] > 0, expected[s]) << stages[s].stage << " seed " << seed;
    }
    ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    for (const std::uint64_t ns : frame.result().stage_ns) EXPECT_EQ(ns, 0u) << "the same input again runs no stage";
  }
}

TEST(frame_cost, times_that_nobody_asks_for_take_no_memory) {
  const Scene scene = random_scene(3);
  Needs needs;
  const Plan without = compile_plan(lend(scene), needs);
  needs.out.stage_times = true;
  EXPECT_LT(without.frame_bytes(), compile_plan(lend(scene), needs).frame_bytes());
  FrameBuffer frame(without);
  ASSERT_EQ(run_plan(without, {}, frame), ErrorCode::ok);
  EXPECT_TRUE(frame.result().stage_ns.empty());
}

TEST(frame_cost, stages_are_named_in_the_order_of_their_times) {
  const Scene scene = random_scene(3);
  const std::vector<PlanStage> stages = compile_plan(lend(scene), Needs{}).stages();
  ASSERT_EQ(stages.size(), kStageCount);
  const char* names[kStageCount] = {"sample",
                                    "mirror",
                                    "blend",
                                    "add",
                                    "pose_program",
                                    "interpolate",
                                    "correctives",
                                    "properties",
                                    "local_to_model",
                                    "palette",
                                    "split_palette",
                                    "combinations",
                                    "winding",
                                    "morph",
                                    "skin_linear",
                                    "skin_dual_quaternion",
                                    "skin_center_of_rotation",
                                    "geometry_cache",
                                    "flat_normals",
                                    "bounds"};
  for (std::size_t s = 0; s < kStageCount; ++s) EXPECT_EQ(stages[s].stage, names[s]);
}

}  // namespace
}  // namespace sinew::test
