// SPDX-License-Identifier: MIT
// Mesh instances whose vertices come from a source in place of their pose.
#include "runtime/plan/evaluate/play_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "runtime/math/determinant_sign.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/frame_equality.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/waving_vertices.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

/// A random scene in which every mesh instance may play a vertex source.
class play_geometry : public testing::Test {
 protected:
  play_geometry() : scene_(random_scene(31)), waves_(scene_) {
    for (std::uint32_t i = 0; i < scene_.instances.size(); ++i) needs_.in.cached_instances.push_back(i);
    compile();
  }

  void compile() {
    plan_ = compile_plan(lend(scene_), needs_);
    frame_.emplace(plan_);
    geometry_.assign(needs_.in.cached_instances.size(), {});
  }

  /// Input in which all instances play at a time, while a clip poses them.
  FrameInput input_at(double time_s, float weight, double clip_time_s = 0.4) {
    layer_ = {.clip = 0, .time_s = clip_time_s};
    for (GeometryInput& input : geometry_) input = {waves_.source(), time_s, weight};
    FrameInput input{.layers = {&layer_, 1}, .weights = {}, .root = root_};
    input.geometry = geometry_;
    return input;
  }

  const FrameResult& run(const FrameInput& input) {
    EXPECT_EQ(run_plan(plan_, input, *frame_), ErrorCode::ok);
    return frame_->result();
  }
  const FrameResult& play(double time_s, float weight) { return run(input_at(time_s, weight)); }

  Scene scene_;
  WavingVertices waves_;
  Needs needs_;
  Plan plan_;
  std::optional<FrameBuffer> frame_;
  std::vector<GeometryInput> geometry_;
  ClipLayer layer_;
  Affine root_;
};

TEST_F(play_geometry, at_weight_1_vertices_are_those_of_the_source_bit_for_bit_and_nothing_is_skinned) {
  root_.row[0].w = 3.0f;
  const FrameResult& shown = play(0.5, 1.0f);
  ASSERT_FALSE(shown.primitives.empty());
  for (const DeformedPrimitive& shape : shown.primitives) {
    ASSERT_FALSE(shape.positions.empty());
    for (std::size_t v = 0; v < shape.positions.size(); ++v)
      ASSERT_EQ(shape.positions[v], waves_.position(shape.instance, shape.primitive, v, 0.5));
    EXPECT_TRUE(same_bits(shown.instances[shape.instance].world_from_mesh, root_));
    EXPECT_TRUE(shown.instances[shape.instance].from_cache);
    EXPECT_FALSE(shown.instances[shape.instance].late);
  }
  EXPECT_EQ(shown.work.vertices_skinned_linear, 0u);
  EXPECT_EQ(shown.work.vertices_morphed, 0u);
  EXPECT_EQ(shown.work.palette_entries, 0u);
  EXPECT_GT(shown.work.vertices_from_cache, 0u);
  EXPECT_EQ(shown.work.vertices_blended, 0u);
}

TEST_F(play_geometry, at_weight_0_nothing_is_asked_of_the_source) {
  const Plan without = compile_plan(lend(scene_), Needs{});
  FrameBuffer posed(without);
  FrameInput input = input_at(0.5, 0.0f);
  const FrameResult& shown = run(input);
  EXPECT_EQ(waves_.shows, 0u);
  input.geometry = {};
  ASSERT_EQ(run_plan(without, input, posed), ErrorCode::ok);
  for (std::size_t p = 0; p < shown.primitives.size(); ++p)
    if (!posed.result().primitives[p].positions.empty()) {
      EXPECT_TRUE(same_bits<glm::vec3>(shown.primitives[p].positions, posed.result().primitives[p].positions));
    }
  EXPECT_EQ(shown.work.vertices_from_cache, 0u);
  EXPECT_EQ(shown.work.cache_frames_decoded, 0u);
}

TEST_F(play_geometry, between_the_weights_pose_and_source_are_blended_in_world_space) {
  root_.row[1].w = 2.0f;
  FrameInput input = input_at(0.5, 0.25f);
  FrameBuffer posed(plan_);
  FrameInput pose = input;
  pose.geometry = {};
  ASSERT_EQ(run_plan(plan_, pose, posed), ErrorCode::ok);
  const FrameResult& shown = run(input);
  for (const DeformedPrimitive& shape : shown.primitives) {
    const DeformedPrimitive& from =
        posed.result().primitives[static_cast<std::size_t>(&shape - shown.primitives.data())];
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
      const glm::vec3 x = transform_point(posed.result().instances[shape.instance].world_from_mesh, from.positions[v]);
      const glm::vec3 y = transform_point(root_, waves_.position(shape.instance, shape.primitive, v, 0.5));
      const glm::vec3 expected = 0.75f * x + 0.25f * y;
      ASSERT_LT(glm::distance(shape.positions[v], expected), 1e-5f);
      if (!shape.normals.empty()) {
        ASSERT_NEAR(glm::length(shape.normals[v]), 1.0f, 1e-6f);
      }
    }
    EXPECT_TRUE(same_bits(shown.instances[shape.instance].world_from_mesh, Affine{}));
  }
  EXPECT_EQ(shown.work.vertices_blended, shown.work.vertices_from_cache);
}

TEST_F(play_geometry, frames_have_room_for_each_attribute_of_the_largest_source) {
  std::size_t largest = 0;
  for (const Mesh& mesh : scene_.meshes)
    for (const Primitive& primitive : mesh.primitives)
      if (!primitive.tangents.empty()) largest = std::max(largest, primitive.vertex_count());
  ASSERT_GT(largest, 0u);
  const auto bytes_of_tangents = [&](bool plays) {
    Needs with = needs_, without = needs_;
    if (!plays) with.in.cached_instances = without.in.cached_instances = {};
    without.out.tangents = false;
    return compile_plan(lend(scene_), with).frame_bytes() - compile_plan(lend(scene_), without).frame_bytes();
  };
  EXPECT_GE(bytes_of_tangents(true), bytes_of_tangents(false) + largest * sizeof(glm::vec4));
}

TEST_F(play_geometry, the_same_time_and_weight_again_run_no_stage) {
  for (const float weight : {1.0f, 0.5f}) {
    const std::uint64_t first = play(0.5, weight).frame, shows = waves_.shows;
    for (int k = 0; k < 3; ++k) {
      const FrameResult& again = play(0.5, weight);
      EXPECT_EQ(again.work, WorkCounters{});
      EXPECT_EQ(again.since_frame, first);
      for (const DeformedPrimitive& shape : again.primitives) EXPECT_EQ(shape.since_frame, first);
    }
    EXPECT_EQ(waves_.shows, shows);
  }
}

TEST_F(play_geometry, a_pose_that_moves_writes_no_vertices_of_a_paused_source) {
  const std::uint64_t first = play(0.5, 1.0f).frame, writes = waves_.writes;
  const FrameResult& moved = run(input_at(0.5, 1.0f, 0.9));
  EXPECT_GT(moved.work.tracks_sampled, 0u);
  EXPECT_EQ(moved.work.vertices_from_cache, 0u);
  EXPECT_EQ(waves_.writes, writes);
  for (const DeformedPrimitive& shape : moved.primitives) EXPECT_EQ(shape.since_frame, first);
}

TEST_F(play_geometry, what_nobody_sees_is_not_decoded) {
  const std::vector<std::uint8_t> unseen(scene_.instances.size(), 1);
  for (int k = 0; k < 4; ++k) {
    FrameInput input = input_at(0.25 * k, 1.0f);
    input.out_of_view = unseen;
    const FrameResult& shown = run(input);
    EXPECT_EQ(shown.work.cache_frames_decoded, 0u);
    if (k > 0) {
      EXPECT_EQ(shown.work, WorkCounters{}) << "the time of what is out of view is no change";
    }
  }
  FrameInput asleep = input_at(2.0, 1.0f);
  asleep.asleep = true;
  EXPECT_EQ(run(asleep).work, WorkCounters{});
  EXPECT_EQ(waves_.shows, 0u);
}

TEST_F(play_geometry, what_was_out_of_view_or_asleep_is_new_when_it_comes_back) {
  for (const bool sleeps : {false, true}) {
    play(0.5, 1.0f);
    FrameInput away = input_at(0.5, 1.0f);
    const std::vector<std::uint8_t> unseen(scene_.instances.size(), 1);
    away.asleep = sleeps;
    if (!sleeps) away.out_of_view = unseen;
    run(away);
    const FrameResult& back = play(0.5, 1.0f);
    for (const DeformedPrimitive& shape : back.primitives) EXPECT_EQ(shape.since_frame, back.frame) << sleeps;
  }
}

TEST_F(play_geometry, one_source_that_is_late_among_others_is_asked_again) {
  for (const std::size_t late : {0u, 1u}) {
    WavingVertices slow(scene_, 2 + late);
    slow.there_until = 0.5;
    const auto input = [&] {
      const FrameInput all = input_at(0.75, 1.0f);
      geometry_[late] = {slow.source(), 0.75, 1.0f};
      return all;
    };
    EXPECT_TRUE(run(input()).instances[late].late);
    EXPECT_FALSE(holds_result_of(*frame_, input()));
    slow.there_until = 2.0;
    EXPECT_FALSE(run(input()).instances[late].late);
  }
}

TEST_F(play_geometry, what_is_late_shows_the_newest_that_is_and_says_so) {
  waves_.there_until = 0.5;
  const FrameResult& late = play(0.75, 1.0f);
  EXPECT_TRUE(late.instances[0].late);
  EXPECT_EQ(late.primitives[0].positions[0], waves_.position(0, 0, 0, 0.5));
  const std::uint64_t since = late.primitives[0].since_frame;
  EXPECT_EQ(play(0.75, 1.0f).primitives[0].since_frame, since) << "still the same vertices";
  EXPECT_TRUE(frame_->result().instances[0].late);
  EXPECT_FALSE(holds_result_of(*frame_, input_at(0.75, 1.0f))) << "the source may have more now";
  waves_.there_until = 2.0;
  const FrameResult& there = play(0.75, 1.0f);
  EXPECT_FALSE(there.instances[0].late);
  EXPECT_EQ(there.primitives[0].positions[0], waves_.position(0, 0, 0, 0.75));
  EXPECT_EQ(there.primitives[0].since_frame, there.frame);
}

TEST_F(play_geometry, a_source_with_nothing_yet_leaves_the_pose) {
  waves_.there_until = -1e9;
  const FrameResult& late = play(0.75, 1.0f);
  EXPECT_TRUE(late.instances[0].late);
  EXPECT_FALSE(late.instances[0].from_cache);
  FrameBuffer posed(plan_);
  FrameInput pose = input_at(0.75, 0.0f);
  ASSERT_EQ(run_plan(plan_, pose, posed), ErrorCode::ok);
  EXPECT_TRUE(same_shape(late.primitives[0], posed.result().primitives[0]));
}

TEST_F(play_geometry, boxes_at_weight_1_are_those_that_the_source_knows) {
  needs_.out.bounds = true;
  compile();
  root_.row[2].w = -4.0f;
  const FrameResult& shown = play(0.5, 1.0f);
  EXPECT_EQ(shown.work.bounds_vertices, 0u);
  for (std::uint32_t i = 0; i < scene_.instances.size(); ++i) {
    const Aabb box = waves_.bounds(i, 0.5);
    EXPECT_NEAR(shown.instances[i].bounds.lower.z, box.lower.z - 4.0f, 1e-5f);
    EXPECT_NEAR(shown.instances[i].bounds.upper.x, box.upper.x, 1e-5f);
  }
  EXPECT_GT(play(0.5, 0.5f).work.bounds_vertices, 0u);
}

TEST_F(play_geometry, bad_inputs_answer_codes_and_leave_the_last_frame) {
  play(0.5, 1.0f);
  const std::uint64_t number = frame_->result().frame;
  const auto refused = [&](const auto& change) {
    FrameInput input = input_at(0.75, 1.0f);
    change(input);
    const ErrorCode code = run_plan(plan_, input, *frame_);
    EXPECT_EQ(frame_->result().frame, number);
    return code;
  };
  EXPECT_EQ(refused([&](FrameInput& in) { in.geometry = in.geometry.first(1); }), ErrorCode::size_mismatch);
  EXPECT_EQ(refused([&](FrameInput&) { geometry_[0].time_s = std::numeric_limits<double>::infinity(); }),
            ErrorCode::not_finite);
  EXPECT_EQ(refused([&](FrameInput&) { geometry_[0].weight = std::numeric_limits<float>::quiet_NaN(); }),
            ErrorCode::not_finite);
  EXPECT_EQ(refused([&](FrameInput&) { geometry_[0].weight = -0.5f; }), ErrorCode::not_a_fraction);
  EXPECT_EQ(refused([&](FrameInput&) { geometry_[0].weight = 1.5f; }), ErrorCode::not_a_fraction);
  EXPECT_EQ(refused([&](FrameInput&) { geometry_[1].time_s += 1.0; }), ErrorCode::two_times) << "one time a source";
  waves_.without.insert(0);
  EXPECT_EQ(refused([](FrameInput&) {}), ErrorCode::index_out_of_range);
}

TEST_F(play_geometry, a_source_plays_at_one_time_a_frame_except_at_weight_0) {
  ASSERT_GE(scene_.instances.size(), 2u);
  for (const std::size_t idle : {0u, 1u}) {
    const FrameInput input = input_at(0.75, 1.0f);
    geometry_[idle].time_s = 9.0;
    EXPECT_EQ(run_plan(plan_, input, *frame_), ErrorCode::two_times);
    geometry_[idle].weight = 0.0f;
    EXPECT_EQ(run_plan(plan_, input, *frame_), ErrorCode::ok);
    WavingVertices others(scene_);
    geometry_[idle] = {others.source(), 9.0, 1.0f};
    EXPECT_EQ(run_plan(plan_, input, *frame_), ErrorCode::ok) << "a source of its own";
  }
}

TEST_F(play_geometry, instances_with_copies_play_in_their_own_space_only) {
  std::uint32_t i = 0;
  while (scene_.instances[i].skin != kNone) ++i;
  scene_.instances[i].copies.resize(2);
  scene_.instances[i].copies[1].translation = {50.0f, 0.0f, 0.0f};
  needs_.out.bounds = true;
  compile();
  EXPECT_EQ(run_plan(plan_, input_at(0.5, 1.0f), *frame_), ErrorCode::unsupported);
  waves_.space = VertexSpace::mesh;
  for (const float weight : {1.0f, 0.5f}) {
    const FrameResult& shown = play(0.5, weight);
    const Affine& world_from_joint = shown.model[scene_.instances[i].joint];
    EXPECT_TRUE(same_bits(shown.instances[i].world_from_mesh, world_from_joint));
    Aabb box;
    const DeformedPrimitive& shape = shown.primitives[shown.instances[i].first_primitive];
    for (const glm::vec3& x : shape.positions) {
      box.add(transform_point(world_from_joint, x));
      box.add(transform_point(world_from_joint, x + glm::vec3(50.0f, 0.0f, 0.0f)));
    }
    const Aabb& found = shown.instances[i].bounds;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(found.lower[axis], box.lower[axis] + 1e-4f);
      EXPECT_GE(found.upper[axis], box.upper[axis] - 1e-4f);
    }
  }
}

TEST_F(play_geometry, in_the_space_of_meshes_turns_over_where_the_joint_mirrors_and_nowhere_else) {
  waves_.space = VertexSpace::mesh;
  for (const float height : {1.0f, -1.0f, 0.0f}) {
    root_.row[1].y = height;  // scales the whole scene; height 0 makes it flat, which is not mirrored
    const FrameResult& shown = play(0.5, 1.0f);
    bool any = false;
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      const bool mirrors = determinant_sign(shown.model[scene_.instances[i].joint]) < 0;
      EXPECT_EQ(shown.instances[i].mirrored, mirrors) << i << ' ' << height;
      any |= mirrors;
    }
    EXPECT_TRUE(height != 0.0f || !any);
  }
}

TEST_F(play_geometry, a_plan_without_it_has_no_stage_and_no_memory) {
  const Plan without = compile_plan(lend(scene_), Needs{});
  EXPECT_FALSE(without.runs(Stage::geometry_cache));
  EXPECT_EQ(stage(without, "geometry_cache").reason, "no mesh instance is asked to play from a cache");
  EXPECT_TRUE(plan_.runs(Stage::geometry_cache));
  EXPECT_EQ(
      stage(plan_, "geometry_cache").reason,
      std::to_string(plan_.primitives().size()) +
          " primitives may play from a cache, in place of morph and skin; normals that it lacks follow the triangles");
  needs_ = {.out = {.joints = true, .positions = false, .normals = false, .tangents = false},
            .in = {.cached_instances = {0}}};
  EXPECT_EQ(stage(compile_plan(lend(scene_), needs_), "geometry_cache").reason,
            "no attribute that is asked for can play");
  EXPECT_LT(without.frame_bytes(), plan_.frame_bytes());
  std::uint64_t vertices = 0;
  for (const DeformedPrimitive& shape : play(0.5, 1.0f).primitives)
    vertices +=
        primitive_of(plan_, plan_.primitives()[static_cast<std::size_t>(&shape - frame_->result().primitives.data())])
            .vertex_count();
  EXPECT_EQ(stage(plan_, "geometry_cache").count, vertices);
}

TEST_F(play_geometry, frames_allocate_nothing) {
  play(0.0, 1.0f);
  const AllocationCounter counter;
  for (int k = 1; k < 20; ++k) play(0.1 * k, k % 3 == 0 ? 0.5f : 1.0f);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace sinew::test
