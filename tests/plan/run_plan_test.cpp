// SPDX-License-Identifier: MIT
#include "runtime/plan/run_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/pose/sample_clip.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// One frame of a scene.
struct Frame {
  Plan plan;
  FrameBuffer buffer;
  ErrorCode error = ErrorCode::ok;

  Frame(const Scene& scene, const Needs& needs) : plan(compile_plan(lend(scene), needs)), buffer(plan) {}
  Frame(const Scene& scene, const Needs& needs, const FrameInput& input) : Frame(scene, needs) { run(input); }

  const FrameResult& run(const FrameInput& input) {
    error = run_plan(plan, input, buffer);
    return buffer.result();
  }
  const FrameResult& result() const { return buffer.result(); }
};

/// The other work, and the sample of one clip with one track.
WorkCounters work_of_one_track(WorkCounters work) {
  work.clips_sampled = work.tracks_sampled = 1;
  return work;
}

Affine moved_by(const glm::vec3& t) { return affine_from(glm::mat3(1.0f), t); }

TEST(run_plan, a_prop_stands_at_its_joint_and_keeps_its_own_vertices) {
  const Scene scene = prop_scene();
  const Frame frame(scene, {}, {.layers = {}, .weights = {}, .root = moved_by({1, 2, 3})});
  ASSERT_EQ(frame.error, ErrorCode::ok);
  EXPECT_EQ(frame.result().instances[0].world_from_mesh, moved_by({1, 2, 3}));
  EXPECT_EQ(frame.result().model[0], moved_by({1, 2, 3}));
  EXPECT_TRUE(frame.result().primitives[0].positions.empty());
  EXPECT_TRUE(frame.result().primitives[0].normals.empty());
  EXPECT_EQ(frame.result().work, (WorkCounters{.joints_composed = 1}));
}

TEST(run_plan, G29_an_arm_bends_in_world_space_wherever_its_node_is) {
  const Scene scene = arm_scene();
  const ClipLayer layer{0, 1.0, 1.0f};
  const Frame frame(scene, {}, {.layers = {&layer, 1}, .weights = {}, .root = moved_by({0, 0, 10})});
  ASSERT_EQ(frame.error, ErrorCode::ok);
  const auto positions = frame.result().primitives[0].positions;
  ASSERT_EQ(positions.size(), 4u);
  EXPECT_TRUE(is_near(positions[0], glm::vec3(0, 0, 10), 1e-6));
  EXPECT_TRUE(is_near(positions[1], glm::vec3(-1, 1, 10), 1e-6));
  EXPECT_TRUE(is_near(positions[2], glm::vec3(0.125f, 1.125f, 10), 1e-6));  // half of (.25 1), half of (0 1.25)
  EXPECT_TRUE(is_near(positions[3], glm::vec3(-0.125f, 0.875f, 10), 1e-6));
  EXPECT_EQ(frame.result().instances[0].world_from_mesh, Affine{});
  EXPECT_EQ(frame.result().work,
            work_of_one_track({.joints_composed = 3, .palette_entries = 2, .vertices_skinned_linear = 4}));
}

TEST(run_plan, dual_quaternions_keep_the_radius_where_linear_blending_cuts_the_corner) {
  const Scene scene = arm_scene();
  const ClipLayer layer{0, 1.0, 1.0f};
  Needs needs;
  needs.skin.kind = Skinning::dual_quaternion;
  const Frame frame(scene, needs, {.layers = {&layer, 1}, .weights = {}, .root = {}});
  const glm::vec3 p = frame.result().primitives[0].positions[2];
  const float r = 0.25f * std::sqrt(0.5f);  // 45 degrees about the elbow at (0 1)
  EXPECT_TRUE(is_near(p, glm::vec3(r, 1 + r, 0), 1e-6));
  EXPECT_EQ(frame.result().work.vertices_skinned_dual_quaternion, 4u);
  EXPECT_EQ(frame.result().work.palette_entries_split, 2u);
  EXPECT_EQ(frame.result().work.vertices_skinned_linear, 0u);
}

TEST(run_plan, N21_skin_turns_about_its_centers_of_rotation) {
  Scene scene = arm_scene();
  Primitive& arm = scene.meshes[0].primitives[0];
  arm.centers_of_rotation = arm.positions;
  arm.centers_of_rotation[2] = arm.centers_of_rotation[3] = {0, 1.5f, 0};  // half a metre beyond the elbow
  const ClipLayer layer{0, 1.0, 1.0f};
  const Frame frame(scene, {.skin = {.kind = Skinning::center_of_rotation}},
                    {.layers = {&layer, 1}, .weights = {}, .root = {}});
  ASSERT_EQ(frame.error, ErrorCode::ok);
  const float half = std::sqrt(0.5f);  // 45 degrees; the center itself: half of (0 1.5), half of (-.5 1)
  const glm::vec3 center(-0.25f, 1.25f, 0), arm_of_2 = {half * 0.75f, -half * 0.25f, 0};
  EXPECT_TRUE(is_near(frame.result().primitives[0].positions[2], center + arm_of_2, 1e-6));
  EXPECT_TRUE(is_near(frame.result().primitives[0].positions[1], glm::vec3(-1, 1, 0), 1e-6));
  EXPECT_TRUE(is_near(frame.result().primitives[0].normals[2], glm::vec3(0, 0, 1), 1e-6));
  EXPECT_EQ(frame.result().work, work_of_one_track({.joints_composed = 3,
                                                    .palette_entries = 2,
                                                    .palette_entries_split = 2,
                                                    .vertices_skinned_center_of_rotation = 4}));
}

TEST(run_plan, N21_without_centers_it_has_the_bits_of_linear_blending) {
  const Scene scene = arm_scene();
  const ClipLayer layer{0, 0.7, 1.0f};
  const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
  const Frame linear(scene, {}, input), center(scene, {.skin = {.kind = Skinning::center_of_rotation}}, input);
  const auto a = linear.result().primitives[0].positions, b = center.result().primitives[0].positions;
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
  EXPECT_EQ(linear.result().work, center.result().work);
}

TEST(run_plan, G43_weights_come_from_the_clip_else_from_rest_and_the_caller_overrides_both) {
  const Scene scene = face_scene();
  Frame frame(scene, {});
  const auto weights = [](const FrameResult& r) { return std::vector<float>(r.weights.begin(), r.weights.end()); };
  EXPECT_EQ(weights(frame.run({})), (std::vector<float>{0.25f, 0.0f}));
  const ClipLayer layer{0, 0.5, 1.0f};
  EXPECT_EQ(weights(frame.run({.layers = {&layer, 1}, .weights = {}, .root = {}})), (std::vector<float>{0.5f, 1.0f}));
  const std::vector<float> own = {-1.0f, 3.0f};
  EXPECT_EQ(weights(frame.run({.layers = {&layer, 1}, .weights = own, .root = {}})), own);
  EXPECT_EQ(frame.result().work.tracks_sampled, 0u);  // the clip only has weights, and the plan does not output them
}

TEST(run_plan, morph_weights_below_zero_and_above_one_are_legal) {
  const Scene scene = face_scene();
  const std::vector<float> weights = {-2.0f, 3.0f};
  const Frame frame(scene, {}, {.layers = {}, .weights = weights, .root = {}});
  const DeformedPrimitive& face = frame.result().primitives[0];
  EXPECT_EQ(face.positions[0], glm::vec3(-1, -1, -2));
  EXPECT_EQ(face.positions[1], glm::vec3(4, -1, 0));
  EXPECT_TRUE(is_near(face.normals[0], glm::normalize(glm::vec3(-2, 0, 1)), 1e-7));
  EXPECT_EQ(face.normals[3], glm::vec3(0, 0, 1));
  EXPECT_EQ(frame.result().work, (WorkCounters{.joints_composed = 1, .morph_deltas = 6, .vertices_morphed = 4}));
}

TEST(run_plan, G47_colours_are_clamped_after_the_sum) {
  const Scene scene = face_scene();
  const std::vector<float> weights = {0.0f, 1.0f}, many = {0.0f, 4.0f};
  Frame frame(scene, {}, {.layers = {}, .weights = weights, .root = {}});
  EXPECT_EQ(frame.result().primitives[0].colors[1], glm::vec4(0.75f, 0.5f, 0.75f, 1.0f));
  EXPECT_EQ(frame.result().primitives[0].colors[0], glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
  frame.run({.layers = {}, .weights = many, .root = {}});
  EXPECT_EQ(frame.result().primitives[0].colors[1], glm::vec4(1.0f, 0.5f, 0.75f, 1.0f));
}

TEST(run_plan, zero_weights_cost_nothing_and_show_the_base) {
  const Scene scene = face_scene();
  const Primitive& base = scene.meshes[0].primitives[0];
  const std::vector<float> weights = {0.0f, 0.0f};
  const Frame frame(scene, {}, {.layers = {}, .weights = weights, .root = {}});
  const DeformedPrimitive& face = frame.result().primitives[0];
  EXPECT_TRUE(std::equal(face.positions.begin(), face.positions.end(), base.positions.begin(), base.positions.end()));
  EXPECT_TRUE(std::equal(face.normals.begin(), face.normals.end(), base.normals.begin(), base.normals.end()));
  EXPECT_TRUE(std::equal(face.colors.begin(), face.colors.end(), base.colors.begin(), base.colors.end()));
  EXPECT_EQ(frame.result().work, (WorkCounters{.joints_composed = 1}));
}

TEST(run_plan, N26_weights_too_small_to_see_count_as_zero) {
  const Scene scene = face_scene();
  const std::vector<float> weights = {1e-30f, -1e-40f};
  const Frame frame(scene, {}, {.layers = {}, .weights = weights, .root = {}});
  EXPECT_EQ(frame.result().work.morph_deltas, 0u);
}

TEST(run_plan, P06_one_layer_of_full_weight_has_the_bits_of_sample_clip) {
  const Scene scene = random_scene(11);
  for (const double time_s : {0.0, 0.37, 1.1, 2.0, 9.0}) {
    const ClipLayer layers[] = {{1, 0.3, 0.0f}, {0, time_s, 1.0f}};  // a layer of weight 0 counts as absent
    const Frame frame(scene, {}, {.layers = layers, .weights = {}, .root = {}});
    std::vector<float> weights(scene.weight_count());
    alignas(64) float memory[PoseSpan::floats_for(16)];
    const PoseSpan pose = pose_over(memory, scene.skeleton.joint_count());
    EXPECT_EQ(run(SampleClipJob{.clip = &scene.clips[0], .time_s = time_s, .pose = pose, .weights = weights}),
              ErrorCode::ok);
    for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j) {
      const std::uint32_t parent = scene.skeleton.parents[j], fixed = scene.skeleton.fixed_matrix_of[j];
      const Affine local = fixed == kNone ? affine_from_transform(pose.get(j)) : scene.skeleton.fixed_matrices[fixed];
      EXPECT_EQ(frame.result().model[j], (parent == kNone ? Affine{} : frame.result().model[parent]) * local) << j;
    }
    EXPECT_TRUE(std::equal(weights.begin(), weights.end(), frame.result().weights.begin()));
    EXPECT_EQ(frame.result().work.poses_blended, 0u);
  }
}

TEST(run_plan, layers_that_do_not_fill_up_to_one_leave_the_rest_to_the_rest_pose) {
  const Scene scene = arm_scene();
  const ClipLayer half{0, 1.0, 0.5f};
  const Frame frame(scene, {}, {.layers = {&half, 1}, .weights = {}, .root = {}});
  ASSERT_EQ(frame.error, ErrorCode::ok);
  const float c = std::sqrt(0.5f);  // half of 90 degrees: the tip stands at 45
  EXPECT_TRUE(is_near(frame.result().primitives[0].positions[1], glm::vec3(-c, 1 + c, 0), 1e-6));
  EXPECT_EQ(frame.result().work.poses_blended, 1u);
}

TEST(run_plan, morph_weights_blend_like_poses) {
  const Scene scene = face_scene();
  Frame frame(scene, {});
  const ClipLayer layers[] = {{0, 0.0, 0.5f}, {0, 1.0, 0.25f}};  // (0 0), (1 2), rest (0.25 0) with weight 0.25
  frame.run({.layers = layers, .weights = {}, .root = {}});
  EXPECT_FLOAT_EQ(frame.result().weights[0], 0.3125f);
  EXPECT_FLOAT_EQ(frame.result().weights[1], 0.5f);
  const ClipLayer heavy[] = {{0, 0.0, 3.0f}, {0, 1.0, 1.0f}};  // normalised: 3/4 and 1/4
  frame.run({.layers = heavy, .weights = {}, .root = {}});
  EXPECT_FLOAT_EQ(frame.result().weights[0], 0.25f);
  EXPECT_FLOAT_EQ(frame.result().weights[1], 0.5f);
}

TEST(run_plan, G22_no_layers_give_the_rest_pose_also_after_a_clip) {
  const Scene scene = random_scene(12);
  const ClipLayer layer{0, 0.7, 1.0f};
  const Frame rested(scene, {}, {});
  Frame frame(scene, {}, {.layers = {&layer, 1}, .weights = {}, .root = {}});
  EXPECT_FALSE(std::equal(frame.result().model.begin(), frame.result().model.end(), rested.result().model.begin()));
  frame.run({});
  EXPECT_TRUE(std::equal(frame.result().model.begin(), frame.result().model.end(), rested.result().model.begin()));
}

TEST(run_plan, G48_mirrored_follows_the_sign_of_the_determinant_every_frame) {
  Scene scene = prop_scene();
  Animation flip;
  flip.duration_s = 1.0;
  flip.bones.resize(1);
  flip.bones[0].scale = {Interpolation::linear, {0, 1}, {{1, 1, 1}, {-1, 1, 1}}};
  scene.animations.push_back(flip);
  finish_scene(scene);
  Frame frame(scene, {});
  const auto mirrored_at = [&](double time_s, const Affine& root) {
    const ClipLayer layer{0, time_s, 1.0f};
    return frame.run({.layers = {&layer, 1}, .weights = {}, .root = root}).instances[0].mirrored;
  };
  EXPECT_FALSE(mirrored_at(0.25, {}));
  EXPECT_FALSE(mirrored_at(0.5, {}));  // with scale 0 no winding is right
  EXPECT_TRUE(mirrored_at(0.75, {}));
  Affine small = {{{-1e-15f, 0, 0, 0}, {0, 1e-15f, 0, 0}, {0, 0, 1e-15f, 0}}};  // the product underflows in float
  EXPECT_TRUE(mirrored_at(0.25, small));
  EXPECT_FALSE(mirrored_at(0.75, small));
}

TEST(run_plan, G48_a_skinned_mesh_is_mirrored_with_the_first_joint_of_its_skin) {
  Scene scene = arm_scene();
  scene.skeleton.rest[1].scale.x = -1.0f;  // the node of a skinned mesh has no effect
  finish_scene(scene);
  EXPECT_FALSE(Frame(scene, {}, {}).result().instances[0].mirrored);
  scene.skeleton.rest[0].scale.z = -1.0f;
  finish_scene(scene);
  EXPECT_TRUE(Frame(scene, {}, {}).result().instances[0].mirrored);
}

TEST(run_plan, frames_count_up_and_can_be_counted_from_anywhere) {
  const Scene scene = prop_scene();
  Frame frame(scene, {}, {});
  EXPECT_EQ(frame.result().frame, 1u);
  EXPECT_EQ(frame.run({}).frame, 2u);
  frame.buffer.count_from(99);
  EXPECT_EQ(frame.run({}).frame, 100u);
}

TEST(run_plan, rejects_what_it_cannot_show_and_keeps_the_last_good_frame) {
  const Scene scene = face_scene();
  Needs needs;
  needs.in.max_layers = 2;
  Frame frame(scene, needs, {});
  const std::vector<float> one = {1.0f}, bad = {1.0f, kNan};
  const double inf = std::numeric_limits<double>::infinity();
  const struct {
    std::vector<ClipLayer> layers;
    std::vector<float> weights;
    ErrorCode error;
  } cases[] = {{{{1, 0.0, 1.0f}}, {}, ErrorCode::index_out_of_range},
               {{{kNone, 0.0, 0.0f}}, {}, ErrorCode::index_out_of_range},
               {{{0, inf, 1.0f}}, {}, ErrorCode::not_finite},
               {{{0, 0.0, kNan}}, {}, ErrorCode::not_finite},
               {{{0, 0.0, -0.5f}}, {}, ErrorCode::negative_weight},
               {{{0, 0.0, 1.0f, 0}}, {}, ErrorCode::index_out_of_range},
               {{{0, 0.0, 1.0f, kNone, LayerKind::add_to_rest}}, {}, ErrorCode::not_in_needs},
               {{{0, 0.0, 1.0f}, {0, 0.0, 1.0f}, {0, 0.0, 1.0f}}, {}, ErrorCode::too_many_layers},
               {{}, one, ErrorCode::size_mismatch},
               {{}, bad, ErrorCode::not_finite}};
  for (const auto& c : cases) {
    EXPECT_EQ(frame.run({.layers = c.layers, .weights = c.weights, .root = {}}).frame, 1u);
    EXPECT_EQ(frame.error, c.error);
    EXPECT_EQ(frame.result().weights[0], 0.25f);
  }
}

TEST(run_plan, a_plan_without_blending_rejects_partial_weights) {
  const Scene scene = face_scene();
  Needs needs;
  needs.in.max_layers = 1;
  Frame frame(scene, needs);
  const ClipLayer half{0, 0.0, 0.5f}, full{0, 0.0, 1.0f};
  frame.run({.layers = {&half, 1}, .weights = {}, .root = {}});
  EXPECT_EQ(frame.error, ErrorCode::not_in_needs);
  frame.run({.layers = {&full, 1}, .weights = {}, .root = {}});
  EXPECT_EQ(frame.error, ErrorCode::ok);
}

TEST(run_plan, layers_that_add_leave_the_rest_pose_and_the_blended_layers_in_their_memory) {
  const Scene scene = face_scene();
  Needs needs;
  needs.in.additive = true;
  needs.in.max_layers = 1;
  Frame frame(scene, needs, {});
  const Affine rest = frame.result().model[0];
  const ClipLayer added[] = {{0, 1.0, 1.0f, kNone, LayerKind::add_to_rest}};
  const std::vector<float> on_top(frame.run({.layers = added, .weights = {}, .root = {}}).weights.begin(),
                                  frame.result().weights.end());
  EXPECT_EQ(frame.error, ErrorCode::ok);
  const ClipLayer alone[] = {{0, 1.0, 1.0f}};
  const std::vector<float> played(frame.run({.layers = alone, .weights = {}, .root = {}}).weights.begin(),
                                  frame.result().weights.end());
  EXPECT_EQ(on_top, played);  // adding the clip's difference from rest to the rest pose gives the clip
  frame.run({});
  EXPECT_EQ(frame.result().model[0], rest);
}

TEST(run_plan, a_layer_with_a_mask_below_a_joint_moves_that_limb_alone) {
  const Scene scene = random_scene(12);
  const Skeleton& skeleton = scene.skeleton;
  const std::uint32_t joint = skeleton.level_begin[1];
  Needs needs;
  needs.in.masks = {mask_below(skeleton, joint)};
  const ClipLayer masked{0, 0.7, 1.0f, 0};
  const Frame rest(scene, needs, {}), moved(scene, needs, {.layers = {&masked, 1}, .weights = {}, .root = {}});
  ASSERT_EQ(moved.error, ErrorCode::ok);
  std::size_t below = 0;
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    std::uint32_t above = j;
    while (above != joint && above != kNone) above = skeleton.parents[above];
    EXPECT_EQ(needs.in.masks[0][j], above == joint ? 1.0f : 0.0f) << j;
    below += above == joint;
    if (above == kNone) {
      EXPECT_EQ(moved.result().model[j], rest.result().model[j]) << j;
    }
  }
  EXPECT_TRUE(below > 0 && below < skeleton.joint_count());
  EXPECT_NE(moved.result().model[joint], rest.result().model[joint]);
  EXPECT_EQ(mask_below(skeleton, joint, 0.25f)[joint], 0.25f);
  EXPECT_DEATH(mask_below(skeleton, 999), "contract broken: .*a mask begins at a joint");
}

TEST(run_plan, clips_are_found_by_the_first_of_a_name) {
  Scene scene = arm_scene();
  scene.animations.push_back(scene.animations[0]);
  scene.animations.push_back(scene.animations[0]);
  scene.animations[1].name = scene.animations[2].name = "walk";
  finish_scene(scene);
  EXPECT_EQ(find_clip(scene, "walk"), 1u);
  EXPECT_EQ(find_clip(scene, "wal"), std::nullopt);
}

TEST(run_plan, rejects_the_frame_buffer_of_another_plan) {
  const Scene arm = arm_scene(), face = face_scene();
  const Plan plan = compile_plan(lend(arm), {}), other = compile_plan(lend(face), {});
  Needs fewer;
  fewer.out.tangents = fewer.out.normals = false;
  const Plan same_scene = compile_plan(lend(arm), fewer);
  FrameBuffer of_other(other), of_same_scene(same_scene);
  EXPECT_EQ(run_plan(plan, {}, of_other), ErrorCode::wrong_plan);
  EXPECT_EQ(run_plan(plan, {}, of_same_scene), ErrorCode::wrong_plan);
}

TEST(run_plan, an_empty_scene_gives_an_empty_frame) {
  Scene scene;
  scene.skeleton.level_begin = {0};
  finish_scene(scene);
  Needs needs;
  needs.out.bounds = true;
  const Frame frame(scene, needs, {});
  EXPECT_EQ(frame.error, ErrorCode::ok);
  EXPECT_TRUE(frame.result().model.empty() && frame.result().instances.empty() && frame.result().primitives.empty());
  EXPECT_EQ(frame.result().work, WorkCounters{});
}

}  // namespace
}  // namespace sinew::test
