// SPDX-License-Identifier: MIT
// Contracts of scenes, plans and frame buffers: what an engine may do, and the error codes for what it may not.
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/all_finite.h"
#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

/// A caller's memory block for one frame. Guard bytes behind it show writes beyond its end.
class GuardedBlock {
 public:
  explicit GuardedBlock(std::size_t byte_count) : lines_(byte_count / sizeof(Line) + kGuardLines), bytes_(byte_count) {
    for (Line& line : lines_)
      for (std::byte& byte : line.bytes) byte = kGuard;
  }
  std::span<std::byte> block() { return all().first(bytes_); }
  bool is_intact() {
    for (const std::byte byte : all().subspan(bytes_))
      if (byte != kGuard) return false;
    return true;
  }

 private:
  struct alignas(FrameBuffer::kAlignment) Line {
    std::byte bytes[FrameBuffer::kAlignment];
  };
  static constexpr std::byte kGuard{0xa5};
  static constexpr std::size_t kGuardLines = 4096;

  std::span<std::byte> all() { return std::as_writable_bytes(std::span(lines_)); }

  std::vector<Line> lines_;
  std::size_t bytes_;
};

TEST(plan_contracts, a_buffer_refuses_a_plan_that_was_compiled_again_for_another_scene_in_the_same_object) {
  Scene scene = prop_scene();
  Plan plan = compile_plan(lend(scene), {});
  GuardedBlock memory(plan.frame_bytes());
  FrameBuffer frame(plan, memory.block());
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  scene = random_scene(3);
  plan = compile_plan(lend(scene), {});
  EXPECT_EQ(run_plan(plan, {}, frame), ErrorCode::wrong_plan);
  EXPECT_TRUE(memory.is_intact());
  EXPECT_TRUE(holds_result_of(frame, {})) << "of the last good frame";
}

TEST(plan_contracts, a_buffer_is_of_the_plan_that_it_was_made_for_and_of_its_copies) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {}), copy = plan, again = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  EXPECT_EQ(run_plan(copy, {}, frame), ErrorCode::ok);
  EXPECT_EQ(run_plan(again, {}, frame), ErrorCode::wrong_plan) << "it may keep other clips";
  EXPECT_EQ(run_plan(Plan{}, {}, frame), ErrorCode::no_plan);
}

TEST(plan_contracts, a_buffer_does_not_follow_one_of_another_plan) {
  const Scene arm = arm_scene(), prop = prop_scene();
  const Plan plan = compile_plan(lend(arm), {}), other = compile_plan(lend(prop), {});
  FrameBuffer frame(plan), foreign(other);
  ASSERT_EQ(run_plan(other, {}, foreign), ErrorCode::ok);
  frame.follow(foreign);
  EXPECT_EQ(run_plan(plan, {}, frame), ErrorCode::wrong_plan);
}

/// Hashes of frames at several times of two clips.
std::vector<std::uint64_t> hashes_of_frames(const Plan& plan, FrameBuffer& frame) {
  std::vector<std::uint64_t> hashes;
  for (const double time_s : {0.0, 0.3, 0.7, 1.4}) {
    const ClipLayer layers[] = {{0, time_s, 0.75f}, {1, 0.5 * time_s, 0.5f}};
    EXPECT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    hashes.push_back(hash_pose(frame.result()));
    hashes.push_back(hash_vertices(frame.result()));
  }
  return hashes;
}

/// Adds clips and animations until their arrays are reallocated.
void grow_clips(Scene& scene) {
  const Clip* const clips_before = scene.clips.data();
  const Animation* const animations_before = scene.animations.data();
  while (scene.clips.data() == clips_before || scene.animations.data() == animations_before) {
    scene.animations.push_back(scene.animations[0]);
    scene.clips.push_back(compile_clip(scene.animations[0], scene.skeleton, rest_weights_of(scene), scene.first_weight,
                                       scene.properties));
  }
}

TEST(plan_contracts, clips_may_be_added_to_the_scene_and_removed_while_plans_run) {
  for (const bool leaves_joints_out : {false, true}) {
    Scene scene = random_scene(5);
    Needs needs;
    if (leaves_joints_out) needs.out.skeleton_lod.kept.assign(scene.skeleton.joint_count(), false);
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    const std::vector<std::uint64_t> before = hashes_of_frames(plan, frame);
    const auto known = static_cast<std::uint32_t>(scene.clips.size());
    grow_clips(scene);
    EXPECT_EQ(hashes_of_frames(plan, frame), before);
    const ClipLayer added{known, 0.5};
    EXPECT_EQ(run_plan(plan, {.layers = {&added, 1}, .weights = {}, .root = {}}, frame), ErrorCode::index_out_of_range)
        << "the plan does not know the clip";
    const Plan grown = compile_plan(lend(scene), needs);
    FrameBuffer of_grown(grown);
    EXPECT_EQ(run_plan(grown, {.layers = {&added, 1}, .weights = {}, .root = {}}, of_grown), ErrorCode::ok);
    scene.clips.clear();
    scene.clips.shrink_to_fit();
    scene.animations.clear();
    EXPECT_EQ(hashes_of_frames(plan, frame), before);
    FrameBuffer made_afterwards(plan);
    EXPECT_EQ(hashes_of_frames(plan, made_afterwards), before);
  }
}

TEST(plan_contracts, a_plan_outlives_its_handle_in_frame_buffers) {
  const Scene scene = random_scene(5);
  Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  const Plan second = plan;
  plan = Plan{};
  FrameBuffer fresh(second);
  EXPECT_EQ(hashes_of_frames(second, frame), hashes_of_frames(second, fresh));
}

TEST(plan_contracts, a_plan_keeps_its_scene_alive) {
  const Scene scene = random_scene(5);
  const Plan of_lent = compile_plan(lend(scene), {});
  FrameBuffer expected(of_lent);
  const std::vector<std::uint64_t> hashes = hashes_of_frames(of_lent, expected);

  std::vector<Plan> plans;  // and nothing else has their scenes
  plans.push_back(compile_plan(Scene(scene), {}));
  std::shared_ptr<const Scene> shared = share(Scene(scene));
  const std::weak_ptr<const Scene> watched = shared;
  plans.push_back(compile_plan(shared, {}));
  shared.reset();
  for (const Plan& plan : plans) {
    FrameBuffer frame(plan);
    EXPECT_EQ(hashes_of_frames(plan, frame), hashes);
  }
  auto last = std::make_unique<FrameBuffer>(plans[1]);
  plans.clear();
  EXPECT_FALSE(watched.expired()) << "the frame buffer still has it";
  last.reset();
  EXPECT_TRUE(watched.expired());
}

TEST(plan_contracts, a_default_plan_breaks_the_contract_of_all_that_needs_one) {
  const Plan none;
  EXPECT_FALSE(none.is_compiled());
  EXPECT_DEATH(FrameBuffer{none}, "contract broken: .*a default plan has no content");
  EXPECT_DEATH(none.frame_bytes(), "contract broken: .*a default plan has no content");
  EXPECT_DEATH(none.needs(), "contract broken: .*a default plan has no content");
  EXPECT_DEATH(kept_joints(none), "contract broken: .*a default plan has no joints");
  EXPECT_DEATH(compile_plan(std::shared_ptr<const Scene>(), {}), "contract broken: .*a plan needs a scene");
}

TEST(plan_contracts, a_buffer_that_was_moved_from_says_so) {
  const Plan plan = compile_plan(arm_scene(), {});
  FrameBuffer frame(plan);
  FrameBuffer moved = std::move(frame);
  EXPECT_EQ(run_plan(plan, {}, moved), ErrorCode::ok);
  EXPECT_EQ(run_plan(plan, {}, frame), ErrorCode::moved_from);  // NOLINT(bugprone-use-after-move)
  moved.follow(frame);
  EXPECT_EQ(run_plan(plan, {}, moved), ErrorCode::moved_from);
}

TEST(plan_contracts, an_index_that_compile_plan_would_follow_out_of_bounds_breaks_a_contract) {
  const Scene good = arm_scene();
  const auto refuses = [&](const char* name, const std::function<void(Scene&)>& damage) {
    Scene bad = good;
    damage(bad);
    EXPECT_DEATH(compile_plan(lend(bad), {}), "contract broken: .*has passed check") << name;
  };
  EXPECT_TRUE(compile_plan(lend(good), {}).is_compiled());
  refuses("mesh", [](Scene& s) { s.instances[0].mesh = static_cast<std::uint32_t>(s.meshes.size()); });
  refuses("joint", [](Scene& s) { s.instances[0].joint = static_cast<std::uint32_t>(s.skeleton.joint_count()); });
  refuses("skin", [](Scene& s) { s.instances[0].skin = static_cast<std::uint32_t>(s.skins.size()); });
  refuses("joint of a skin", [](Scene& s) { s.skins[0].joints.back() = 3; });
  refuses("bind matrices", [](Scene& s) { s.skins[0].inverse_bind.pop_back(); });
  refuses("parent", [](Scene& s) { s.skeleton.parents[1] = 1; });
  refuses("rest pose", [](Scene& s) { s.skeleton.rest.pop_back(); });
  refuses("hidden joint", [](Scene& s) { s.hidden_joints = {3}; });
  refuses("material",
          [](Scene& s) { s.meshes[0].primitives[0].material = static_cast<std::uint32_t>(s.materials.size()); });
  refuses("triangle", [](Scene& s) { s.meshes[0].primitives[0].indices.assign(3, 4); });
  refuses("joint of a vertex", [](Scene& s) { s.meshes[0].primitives[0].influences.joints.back() = 2; });
  refuses("morph weights", [](Scene& s) { s.first_weight.pop_back(); });
}

struct BadNumber {
  const char* name;
  std::function<void(FrameInput&, ClipLayer& layer, ClipLayer& next, std::vector<float>& weights)> set;
  ErrorCode error = ErrorCode::not_finite;
};

std::vector<BadNumber> bad_numbers() {
  std::vector<BadNumber> bad;
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const float x : {nan, inf, -inf}) {
    for (int i = 0; i < 12; ++i)
      bad.push_back({"root", [=](FrameInput& input, auto&, auto&, auto&) { input.root.row[i / 4][i % 4] = x; }});
    bad.push_back({"time of a layer", [=](auto&, ClipLayer& layer, auto&, auto&) { layer.time_s = x; }});
    bad.push_back({"weight of a layer", [=](auto&, ClipLayer& layer, auto&, auto&) { layer.weight = x; }});
    bad.push_back({"time of a next layer", [=](auto&, auto&, ClipLayer& next, auto&) { next.time_s = x; }});
    bad.push_back({"weight of a next layer", [=](auto&, auto&, ClipLayer& next, auto&) { next.weight = x; }});
    bad.push_back({"morph weight", [=](auto&, auto&, auto&, auto& weights) { weights.back() = x; }});
    bad.push_back({"interpolation factor",
                   [=](FrameInput& input, auto&, auto&, auto&) { input.interpolation_factor = x; },
                   ErrorCode::not_a_fraction});
  }
  for (const float x : {std::nextafter(1e9f, 2e9f), 1e38f}) {
    for (int i = 0; i < 12; ++i)
      bad.push_back({"large root", [=](FrameInput& input, auto&, auto&, auto&) { input.root.row[i / 4][i % 4] = -x; },
                     ErrorCode::too_large});
    bad.push_back({"large weight of a layer", [=](auto&, ClipLayer& layer, auto&, auto&) { layer.weight = x; },
                   ErrorCode::too_large});
    bad.push_back({"large weight of a next layer", [=](auto&, auto&, ClipLayer& next, auto&) { next.weight = x; },
                   ErrorCode::too_large});
    bad.push_back(
        {"large morph weight", [=](auto&, auto&, auto&, auto& weights) { weights.back() = -x; }, ErrorCode::too_large});
  }
  bad.push_back(
      {"interpolation factor above 1",
       [](FrameInput& input, auto&, auto&, auto&) { input.interpolation_factor = std::nextafter(1.0f, 2.0f); },
       ErrorCode::not_a_fraction});
  bad.push_back({"mask", [](auto&, ClipLayer& layer, auto&, auto&) { layer.mask = 0; }, ErrorCode::index_out_of_range});
  return bad;
}

TEST(plan_contracts, masks_are_one_finite_weight_of_at_least_zero_for_each_joint) {
  const Scene scene = random_scene(4);
  const std::vector<float> good(scene.skeleton.joint_count(), 0.5f);
  Needs needs;
  needs.in.masks = {good};
  EXPECT_TRUE(compile_plan(lend(scene), needs).runs(Stage::blend));
  std::vector<std::vector<float>> bad(4, good);
  bad[0].back() = std::numeric_limits<float>::quiet_NaN();
  bad[1].front() = std::numeric_limits<float>::infinity();
  bad[2][1] = -0.5f;
  bad[3].pop_back();
  for (const std::vector<float>& mask : bad) {
    needs.in.masks = {good, mask};
    EXPECT_DEATH(compile_plan(lend(scene), needs), "contract broken: .*in.masks");
  }
}

TEST(plan_contracts, the_largest_numbers_that_are_not_refused_give_finite_frames) {
  const float most = 1e9f;
  for (const Scene& scene : {random_scene(4), face_scene()}) {
    const Plan plan = compile_plan(lend(scene), {.out = {.bounds = true}});
    FrameBuffer frame(plan);
    const std::vector<ClipLayer> layers(4, {0, 0.3, most});
    const std::vector<float> weights(scene.weight_count(), most);
    FrameInput input{.layers = layers, .weights = {}, .root = affine_from(glm::mat3(most), glm::vec3(-most))};
    for (const bool given : {false, true}) {
      if (given) input.weights = weights;
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      EXPECT_TRUE(all_finite(frame.result().model));
      EXPECT_TRUE(all_finite(frame.result().weights));
      for (const DeformedPrimitive& p : frame.result().primitives)
        EXPECT_TRUE(all_finite(p.positions) && all_finite(p.normals) && all_finite(p.tangents));
    }
  }
}

TEST(plan_contracts, why_refused_names_field_index_and_rule) {
  const Scene scene = random_scene(4);
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  std::vector<ClipLayer> layers = {{0, 0.4, 0.5f}, {1, 0.6, 0.5f}};
  std::vector<float> weights(scene.weight_count(), 0.25f);
  FrameInput input{.layers = layers, .weights = weights, .root = {}};
  const auto why = [&] {
    const std::string text = why_refused(plan, input, frame);
    EXPECT_EQ(text.empty(), run_plan(plan, input, frame) == ErrorCode::ok) << text;
    return text;
  };
  EXPECT_EQ(why(), "");
  layers[1].weight = -1.0f;
  EXPECT_EQ(why(), "layers[1].weight: a weight is below 0, and only additive layers subtract");
  layers[1] = {99, 0.6};
  EXPECT_EQ(why(), "layers[1].clip: the plan was compiled for fewer clips");
  layers[1] = {1, 0.6, 0.5f, kNone, LayerKind::add_to_rest};
  EXPECT_EQ(why(), "layers[1].kind: additive layers are not declared in the needs");
  layers[1] = layers[0];
  weights.back() = 1e20f;
  EXPECT_EQ(why(),
            "weights[" + std::to_string(weights.size() - 1) + "]: a number is so large that results could overflow");
  input.weights = input.weights.first(1);
  EXPECT_EQ(why(), "weights: not one for each morph weight of the scene");
  input.weights = {};
  input.root.row[1].w = std::numeric_limits<float>::infinity();
  EXPECT_EQ(why(), "root: a number is NaN or infinite");
  EXPECT_EQ(why_refused(Plan{}, input, frame), "plan: the plan is a default one, which compile_plan did not make");
}

TEST(plan_contracts, numbers_of_the_input_that_mean_nothing_are_refused_and_the_last_frame_stays) {
  const Scene scene = random_scene(4);
  Needs needs;
  needs.in.between_updates = true;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  const ClipLayer good{0, 0.4}, good_next{1, 0.6};
  const std::vector<float> good_weights(scene.weight_count(), 0.25f);
  ASSERT_FALSE(good_weights.empty());
  const FrameInput fine{.layers = {&good, 1},
                        .weights = good_weights,
                        .root = {},
                        .next_layers = {&good_next, 1},
                        .interpolation_factor = 0.5f};
  ASSERT_EQ(run_plan(plan, fine, frame), ErrorCode::ok);
  const std::uint64_t last = hash_pose(frame.result());
  for (const BadNumber& bad : bad_numbers()) {
    ClipLayer layer = good, next = good_next;
    std::vector<float> weights = good_weights;
    FrameInput input = fine;
    bad.set(input, layer, next, weights);
    input.layers = {&layer, 1};
    input.next_layers = {&next, 1};
    input.weights = weights;
    EXPECT_EQ(run_plan(plan, input, frame), bad.error) << bad.name;
    input.asleep = true;
    EXPECT_EQ(run_plan(plan, input, frame), bad.error) << bad.name << ", asleep";
    EXPECT_EQ(hash_pose(frame.result()), last) << bad.name;
    EXPECT_TRUE(holds_result_of(frame, fine)) << bad.name;
  }
}

}  // namespace
}  // namespace sinew::test
