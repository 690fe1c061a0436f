// SPDX-License-Identifier: MIT
// Results that have not changed since the last frame are neither computed again nor reported as new. Their bits are
// those of a fresh frame.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "runtime/base/same_bits.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/frame_equality.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

void expect_same(const FrameResult& a, const FrameResult& b) { EXPECT_EQ(first_difference(a, b), ""); }

Needs needs_by_bits(std::uint32_t bits) {
  Needs needs;
  needs.out.positions = !(bits & 1);
  needs.out.normals = !(bits & 2);
  needs.out.bounds = bits & 4;
  needs.in.additive = bits & 8;
  needs.skin.kind = bits & 16 ? Skinning::dual_quaternion : Skinning::linear;
  return needs;
}

/// Inputs with few different values, so that whole inputs, palettes and weights often repeat.
class FewInputs {
 public:
  FewInputs(const Scene& scene, std::uint32_t seed) : scene_(scene), random_(seed) {}

  FrameInput next() {
    layers_.clear();
    weights_.clear();
    if (!scene_.clips.empty() && choose(4) > 0)
      layers_.push_back({choose(static_cast<std::uint32_t>(scene_.clips.size())), 0.5 * choose(3)});
    if (!scene_.clips.empty() && choose(4) == 0) layers_.push_back({0, 100.0 + choose(3)});
    if (choose(2) == 0) weights_.assign(scene_.weight_count(), static_cast<float>(choose(2)));
    root_ = {};
    if (choose(4) == 0) root_.row[0].w = 1.0f;
    if (choose(6) == 0) root_.row[1].y = -1.0f;
    out_of_view_.clear();
    if (choose(2) == 0)
      for (std::size_t i = 0; i < scene_.instances.size(); ++i) out_of_view_.push_back(choose(3) == 0);
    return {
        .layers = layers_, .weights = weights_, .root = root_, .out_of_view = out_of_view_, .asleep = choose(5) == 0};
  }

 private:
  std::uint32_t choose(std::uint32_t count) { return random_.below(count); }

  const Scene& scene_;
  FixedRandom random_;
  std::vector<ClipLayer> layers_;
  std::vector<float> weights_;
  std::vector<std::uint8_t> out_of_view_;
  Affine root_;
};

Scene scene_by_seed(std::uint32_t seed) {
  RandomSceneOptions options;
  options.skins = seed % 3;
  options.targets = seed % 2 * 2;
  options.clips = 2;
  if (seed % 7 == 6) return face_scene();  // none of its clips moves a joint
  options.flat_normals = seed % 2 == 0;
  options.correctives = options.targets > 0 ? seed % 3 : 0;
  Scene scene = random_scene(seed, options);
  if (seed % 3 == 0) move_few_joints(scene);
  return scene;
}

TEST(unchanged_frames, P19_the_same_input_again_does_exactly_nothing) {
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    const Scene scene = scene_by_seed(seed);
    const Plan plan = compile_plan(lend(scene), needs_by_bits(seed));
    FrameBuffer frame(plan), fresh(plan);
    const ClipLayer layer{0, 0.7};
    const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
    for (FrameBuffer* buffer : {&frame, &fresh}) ASSERT_EQ(run_plan(plan, input, *buffer), ErrorCode::ok);
    ASSERT_NE(frame.result().work, WorkCounters{});
    for (std::uint64_t number = 2; number < 4; ++number) {
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      EXPECT_EQ(frame.result().work, WorkCounters{});
      EXPECT_EQ(frame.result().frame, number);
      EXPECT_EQ(frame.result().since_frame, 1u);
      expect_same(frame.result(), fresh.result());
      for (const DeformedPrimitive& shape : frame.result().primitives) EXPECT_LE(shape.since_frame, 1u);
    }
  }
}

TEST(unchanged_frames, P19_a_clip_held_at_its_end_is_not_skinned_again) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  std::uint64_t skinned = 0;
  for (const double time_s : {0.5, 50.0, 51.0, 52.0, 0.5}) {
    const ClipLayer layer{0, time_s};
    ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    skinned += frame.result().work.vertices_skinned_linear;
    EXPECT_GT(frame.result().work.tracks_sampled, 0u);
    const std::uint64_t number = frame.result().frame;
    EXPECT_EQ(frame.result().primitives[0].since_frame, number == 1 ? 1u : number == 5 ? 5u : 2u);
  }
  EXPECT_EQ(skinned, 3 * 4u);
}

TEST(unchanged_frames, P01_joints_that_no_clip_moves_are_composed_once) {
  const Scene scene = face_scene();
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  for (int number = 0; number < 5; ++number) {
    const ClipLayer layer{0, 0.2 * number};
    FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
    if (number == 4) input.root.row[2].w = 1.0f;
    FrameBuffer fresh(plan);
    for (FrameBuffer* buffer : {&frame, &fresh}) ASSERT_EQ(run_plan(plan, input, *buffer), ErrorCode::ok);
    expect_same(frame.result(), fresh.result());
    EXPECT_EQ(frame.result().work.joints_composed, number == 0 || number == 4 ? 1u : 0u) << number;
    EXPECT_EQ(frame.result().work.tracks_sampled, 2u);
    EXPECT_EQ(frame.result().primitives[0].since_frame, frame.result().frame);
  }
}

TEST(unchanged_frames, P01_joints_that_no_clip_moves_stand_while_layers_blend_and_between_updates) {
  Scene scene = arm_scene();
  // Clips drop numbers as small as 3e-19.
  scene.skeleton.rest[0] = {{0.1f, -0.7f, 0.3f}, quat_xyzw(0.6f, 3e-19f, 0.0f, 0.8f), glm::vec3(1.1f, 0.9f, 1.3f)};
  scene.skeleton.rest[1].rotation = glm::normalize(glm::quat(0.7f, 0.1f, -0.4f, 0.5f));
  finish_scene(scene);
  Needs needs;
  needs.in.between_updates = true;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan), alone(plan);
  const ClipLayer one{0, 0.5};
  ASSERT_EQ(run_plan(plan, {.layers = {&one, 1}, .weights = {}, .root = {}}, alone), ErrorCode::ok);
  for (int number = 0; number < 8; ++number) {
    const ClipLayer now[] = {{0, 0.1 * number, 0.7f}, {0, 0.9, 0.4f}},
                    ahead[] = {{0, 0.1 * number + 0.1, 0.5f}, {0, 0.3, 0.3f}};
    FrameInput input{.layers = now, .weights = {}, .root = {}};
    if (number > 4) {
      input.next_layers = ahead;
      input.interpolation_factor = 0.3f;
    }
    FrameBuffer fresh(plan);
    for (FrameBuffer* buffer : {&frame, &fresh}) ASSERT_EQ(run_plan(plan, input, *buffer), ErrorCode::ok);
    expect_same(frame.result(), fresh.result());
    EXPECT_EQ(frame.result().work.joints_composed, number == 0 ? 3u : 1u) << number;
    for (const std::size_t joint : {0u, 1u})
      EXPECT_TRUE(same_bits(frame.result().model[joint], alone.result().model[joint])) << number;
  }
}

TEST(unchanged_frames, P01_poses_of_one_clip_after_another_are_those_of_fresh_ones) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scene scene = random_scene(seed);
    Needs needs;
    needs.in.additive = true;
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    const std::vector<std::vector<ClipLayer>> all = {{{0, 0.1}},
                                                     {{0, 0.3}},
                                                     {{1, 0.3}},
                                                     {{1, 0.4}, {0, 0.9, 0.0f}},
                                                     {{1, 0.5}, {0, 0.9, 1.0f}},
                                                     {{1, 0.6}},
                                                     {},
                                                     {{1, 0.7}},
                                                     {{1, 0.8, 0.5f}},
                                                     {{1, 0.9}},
                                                     {{1, 1.0}, {0, 0.3, 0.5f, kNone, LayerKind::add_to_rest}},
                                                     {{1, 1.1}},
                                                     {{0, 1.2, 2.0f}},
                                                     {{0, 1.3}}};
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const bool asleep : {false, i % 5 == 4}) {
        FrameBuffer fresh(plan);
        for (FrameBuffer* buffer : {&frame, &fresh})
          ASSERT_EQ(run_plan(plan, {.layers = all[i], .weights = {}, .root = {}, .asleep = asleep}, *buffer),
                    ErrorCode::ok);
        expect_same(frame.result(), fresh.result());
      }
  }
}

TEST(unchanged_frames, a_scene_without_clips_does_nothing_from_its_second_frame_on) {
  RandomSceneOptions options;
  options.clips = 0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    options.skins = seed % 2 * 2;
    options.targets = seed / 2 % 2 * 3;
    options.flat_normals = seed > 3;
    const Scene scene = random_scene(seed, options);
    const Plan plan = compile_plan(lend(scene), needs_by_bits(4));
    FrameBuffer frame(plan);
    for (int number = 1; number <= 4; ++number) {
      ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
      EXPECT_EQ(frame.result().work == WorkCounters{}, number > 1) << seed;
    }
  }
}

TEST(unchanged_frames, P19_a_moved_face_is_not_morphed_again) {
  const Scene scene = face_scene();
  Needs needs;
  needs.out.bounds = true;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  const std::vector<float> weights(scene.weight_count(), 0.5f);
  FrameInput input{.layers = {}, .weights = weights, .root = {}};
  ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  EXPECT_GT(frame.result().work.morph_deltas, 0u);
  const float left = frame.result().instances[0].bounds.lower.x;
  input.root.row[0].w = 2.0f;
  ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().primitives[0].since_frame, 1u);
  EXPECT_EQ(frame.result().instances[0].bounds.lower.x, left + 2.0f);  // the bounds moved all the same
}

/// One character uses several buffers in turn; each frame is compared with one in a fresh buffer.
/// out  how many shapes were unchanged since an earlier frame
std::size_t run_in_turns(std::uint32_t seed, std::size_t buffer_count) {
  const Scene scene = scene_by_seed(seed);
  const Plan plan = compile_plan(lend(scene), needs_by_bits(seed));
  std::vector<FrameBuffer> buffers;
  for (std::size_t b = 0; b < buffer_count; ++b) buffers.emplace_back(plan);
  FewInputs inputs(scene, seed);
  std::vector<std::map<std::uint64_t, std::uint64_t>> hash_of_frame(
      plan.primitives().size());  // [primitives], by frame number
  FixedRandom random(seed + 1000);
  std::size_t at = 0, kept = 0;
  for (std::uint64_t number = 1; number <= 40; ++number) {
    const std::size_t next = random.below(3) % buffer_count;
    const FrameInput input = inputs.next();
    buffers[next].count_from(number - 1);
    if (number > 1) buffers[next].follow(buffers[at]);
    at = next;
    FrameBuffer fresh(plan);
    for (FrameBuffer* buffer : {&buffers[at], &fresh}) EXPECT_EQ(run_plan(plan, input, *buffer), ErrorCode::ok);
    expect_same(buffers[at].result(), fresh.result());
    for (std::size_t p = 0; p < plan.primitives().size(); ++p) {
      const DeformedPrimitive& shape = buffers[at].result().primitives[p];
      const std::uint32_t i = plan.primitives()[p].instance;
      const bool is_seen = !input.asleep && (input.out_of_view.empty() || input.out_of_view[i] == 0);
      EXPECT_EQ(shape.since_frame != 0, plan.primitives()[p].deformed() && is_seen) << p;
      EXPECT_LE(shape.since_frame, number);
      if (shape.since_frame == 0) continue;
      const std::uint64_t hash = hash_of_frame[p][number] = hash_shape(shape);
      for (auto seen = hash_of_frame[p].lower_bound(shape.since_frame); seen != hash_of_frame[p].end(); ++seen)
        EXPECT_EQ(seen->second, hash) << "primitive " << p << " frame " << number << " since " << shape.since_frame;
      kept += shape.since_frame < number;
    }
  }
  return kept;
}

TEST(unchanged_frames, P19_results_and_stamps_are_right_whatever_ran_before) {
  std::size_t kept = 0;
  for (std::uint32_t seed = 0; seed < 32; ++seed) kept += run_in_turns(seed, 1);
  EXPECT_GT(kept, 32 * 10u);
}

TEST(unchanged_frames, P19_results_and_stamps_are_right_for_buffers_that_take_turns) {
  std::size_t kept = 0;
  for (std::uint32_t seed = 0; seed < 32; ++seed) kept += run_in_turns(seed, 3);
  EXPECT_GT(kept, 32 * 10u);
}

TEST(unchanged_frames, a_frame_with_more_adding_layers_than_are_kept_is_right_as_well) {
  const Scene scene = face_scene();
  const Plan plan = compile_plan(lend(scene), {.in = {.additive = true}});
  FrameBuffer frame(plan);
  std::vector<ClipLayer> layers(100, {0, 0.25, 0.01f, kNone, LayerKind::add_to_rest});
  for (int round = 0; round < 3; ++round) {
    layers.back().time_s = 0.5 * (round + 1);
    FrameBuffer fresh(plan);
    for (FrameBuffer* buffer : {&frame, &fresh})
      ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, *buffer), ErrorCode::ok);
    expect_same(frame.result(), fresh.result());
  }
}

TEST(unchanged_frames, a_frame_buffer_knows_its_plan_from_another_of_the_same_size) {
  const Scene scene = arm_scene();
  Needs cofactor;
  cofactor.skin.normal_rule = NormalRule::cofactor;
  const Plan linear = compile_plan(lend(scene), {}), other = compile_plan(lend(scene), cofactor);
  ASSERT_EQ(linear.frame_bytes(), other.frame_bytes());
  FrameBuffer frame(linear);
  ASSERT_EQ(run_plan(linear, {}, frame), ErrorCode::ok);
  EXPECT_EQ(run_plan(other, {}, frame), ErrorCode::wrong_plan);
}

TEST(unchanged_frames, a_clip_that_moves_no_joint_and_plays_alone_leaves_matrices_as_they_are) {
  Scene scene = arm_scene();
  scene.animations.push_back({"still", 1.0, {}, {}});
  finish_scene(scene);
  const Plan plan = compile_plan(lend(scene), Needs{});
  FrameBuffer frame(plan);
  const auto composed = [&](std::vector<ClipLayer> layers) {
    EXPECT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    return frame.result().work.joints_composed;
  };
  const std::size_t joints = scene.skeleton.joint_count();
  EXPECT_EQ(composed({{1, 0.1}}), joints);
  EXPECT_EQ(composed({{1, 0.2}}), 0u);
  EXPECT_EQ(composed({{1, 0.3}, {0, 0.3, 0.0f}}), 0u) << "what has no weight does not play";
  EXPECT_EQ(composed({{0, 0.3, 0.0f}, {1, 0.4}}), 0u);
  EXPECT_EQ(composed({}), 0u) << "nor does anything";
  EXPECT_GT(composed({{0, 0.5}}), 0u);
  EXPECT_GT(composed({{1, 0.6}}), 0u) << "the clip before moved a joint";
  EXPECT_EQ(composed({{1, 0.7}}), 0u);
  EXPECT_GT(composed({{1, 0.8}, {1, 0.9}}), 0u) << "sums of two are rounded";
  EXPECT_GT(composed({{1, 0.8, 0.5f}}), 0u);
}

}  // namespace
}  // namespace sinew::test
