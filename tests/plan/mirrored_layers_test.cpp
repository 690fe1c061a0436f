// SPDX-License-Identifier: MIT
// Mirrored layers. The test remembering_frames compares frames of random layers with fresh ones.
#include <gtest/gtest.h>

#include "runtime/animation/mirror_animation.h"
#include "runtime/base/same_bits.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/random_inputs.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/two_sided.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

constexpr std::uint32_t kClip = 0, kMirroredClip = 1;

/// A body with two clips; the second is the first mirrored key by key.
struct TwoClips {
  scenes::TwoSided body;
  std::shared_ptr<const MirrorMap> map;
  Scene scene;

  explicit TwoClips(scenes::RightSide right) : body(scenes::two_sided(right)) {
    FixedRandom random(4);
    scene.skeleton = body.skeleton;
    Animation animation{"move", 1.0, {}, {}};
    for (const std::uint32_t j : {0u, 2u, 5u, 9u, 11u}) {  // only the left side
      BoneAnimation& bone = animation.bones.emplace_back();
      bone.joint = j;
      const Transform& rest = scene.skeleton.rest[j];
      bone.rotation = {Interpolation::linear, {0.0f, 1.0f}, {rest.rotation, random.rotation_by(0.5) * rest.rotation}};
      bone.translation = {
          Interpolation::linear, {0.0f, 1.0f}, {rest.translation, rest.translation + random.vec3(-0.1, 0.1)}};
    }
    map = std::make_shared<const MirrorMap>(make_mirror_map(body.skeleton));
    scene.animations = {animation, mirror_animation(animation, *map, scene.skeleton)};
    finish_scene(scene);
  }
  Needs needs() const {
    Needs needs;
    needs.in.additive = true;
    needs.in.masks = {std::vector<float>(scene.skeleton.joint_count(), 0.25f)};
    for (const std::uint32_t j : {5u, 9u, 11u}) needs.in.masks[0][j] = 0.75f;
    needs.in.mirror = map;
    return needs;
  }
  std::vector<Affine> model(const Plan& plan, std::span<const ClipLayer> layers) const {
    FrameBuffer frame(plan);
    EXPECT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    return {frame.result().model.begin(), frame.result().model.end()};
  }
};

void expect_near(const std::vector<Affine>& a, const std::vector<Affine>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t j = 0; j < a.size(); ++j) EXPECT_LE(distance(a[j], b[j]), tolerance) << j;
}

TEST(mirrored_layers, each_kind_gives_what_the_clip_that_was_mirrored_key_by_key_gives) {
  for (const scenes::RightSide right : scenes::kRightSides) {
    const TwoClips two(right);
    const Plan plan = compile_plan(lend(two.scene), two.needs());
    const double tolerance = scenes::is_symmetric(right) ? 0.0 : 2e-6;
    for (const LayerKind kind : {LayerKind::blend, LayerKind::add_to_rest, LayerKind::add_to_start})
      for (const std::uint32_t mask : {kNone, 0u}) {
        const ClipLayer played[] = {{kClip, 0.3, 0.8f}, {kClip, 0.7, 0.7f, mask, kind, true}};
        const ClipLayer baked[] = {{kClip, 0.3, 0.8f}, {kMirroredClip, 0.7, 0.7f, mask, kind}};
        expect_near(two.model(plan, played), two.model(plan, baked), tolerance == 0.0 ? 1e-6 : tolerance);
        const ClipLayer alone[] = {{kClip, 0.7, 1.0f, mask, kind, true}},
                        baked_alone[] = {{kMirroredClip, 0.7, 1.0f, mask, kind}};
        expect_near(two.model(plan, alone), two.model(plan, baked_alone), tolerance == 0.0 ? 1e-6 : tolerance);
      }
  }
}

TEST(mirrored_layers, P06_a_plan_without_a_mirror_refuses_them_and_frames_without_one_do_no_work) {
  const TwoClips two(scenes::RightSide::any_axes);
  Needs needs = two.needs();
  const Plan with = compile_plan(lend(two.scene), needs);
  needs.in.mirror = nullptr;
  const Plan without = compile_plan(lend(two.scene), needs);
  EXPECT_TRUE(with.runs(Stage::mirror));
  EXPECT_FALSE(without.runs(Stage::mirror));
  EXPECT_LT(without.frame_bytes(), with.frame_bytes());
  FrameBuffer frame(without), other(with);
  const ClipLayer plain{kClip, 0.4}, turned{.clip = kClip, .time_s = 0.4, .mirrored = true};
  EXPECT_EQ(run_plan(without, {.layers = {&turned, 1}, .weights = {}, .root = {}}, frame), ErrorCode::not_in_needs);
  ASSERT_EQ(run_plan(without, {.layers = {&plain, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
  ASSERT_EQ(run_plan(with, {.layers = {&plain, 1}, .weights = {}, .root = {}}, other), ErrorCode::ok);
  EXPECT_EQ(frame.result().work.poses_mirrored, 0u);
  EXPECT_EQ(other.result().work.poses_mirrored, 0u);
  EXPECT_TRUE(same_bits<Affine>(frame.result().model, other.result().model));
  const AllocationCounter counter;
  ASSERT_EQ(run_plan(with, {.layers = {&turned, 1}, .weights = {}, .root = {}}, other), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
  EXPECT_EQ(other.result().work.poses_mirrored, 1u);
}

TEST(mirrored_layers, joints_that_only_the_other_side_moves_are_moved) {
  const TwoClips two(scenes::RightSide::mirrored_axes);
  Scene scene = two.scene;
  scene.animations.pop_back();
  std::erase_if(scene.animations[0].bones, [](const BoneAnimation& bone) { return bone.joint == 0; });
  scene.clips.clear();
  finish_scene(scene);
  Needs needs = two.needs();
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer kept(plan), fresh(plan);
  const ClipLayer plain{kClip, 0.4}, turned{.clip = kClip, .time_s = 0.8, .mirrored = true};
  ASSERT_EQ(run_plan(plan, {.layers = {&plain, 1}, .weights = {}, .root = {}}, kept), ErrorCode::ok);
  for (FrameBuffer* frame : {&kept, &fresh})
    ASSERT_EQ(run_plan(plan, {.layers = {&turned, 1}, .weights = {}, .root = {}}, *frame), ErrorCode::ok);
  EXPECT_TRUE(same_bits<Affine>(kept.result().model, fresh.result().model));
  EXPECT_NE(kept.result().model[12], two.model(plan, std::span(&plain, 1))[12]) << "the right hand";
}

/// A scene with one moving and one resting clip. The rest weights of partner targets differ. The mirror's reference
/// pose is not the rest pose, so mirroring also moves joints at rest.
struct LopsidedRest {
  Scene scene;
  Needs needs;

  LopsidedRest() : scene(random_scene(5, {.targets = 3})) {
    float rest = 0.0f;
    for (MeshInstance& instance : scene.instances)
      for (float& weight : instance.rest_weights) weight = rest += 0.125f;
    Animation still{"still", 1.0, {}, {}};
    scene.animations = {scene.animations[0], still};
    scene.clips.clear();
    finish_scene(scene);
    MirrorMap map = make_mirror_map(scene.skeleton, {.reference = scenes::moved_from_rest(scene.skeleton, 7)});
    map.weight_source = some_mirror(scene).weight_source;
    needs.in.mirror = std::make_shared<const MirrorMap>(std::move(map));
    needs.in.additive = true;
  }
};

TEST(mirrored_layers, a_clip_that_rests_adds_nothing_on_the_other_side_either) {
  const LopsidedRest lopsided;
  const Plan plan = compile_plan(lend(lopsided.scene), lopsided.needs);
  FrameBuffer without(plan), with(plan);
  for (const LayerKind kind : {LayerKind::add_to_rest, LayerKind::add_to_start}) {
    const ClipLayer layers[] = {{0, 0.6}, {1, 0.3, 0.75f, kNone, kind, true}};
    ASSERT_EQ(run_plan(plan, {.layers = std::span(layers, 1), .weights = {}, .root = {}}, without), ErrorCode::ok);
    ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, with), ErrorCode::ok);
    EXPECT_TRUE(same_bits<Affine>(with.result().model, without.result().model));
    EXPECT_TRUE(same_bits<float>(with.result().weights, without.result().weights));
  }
}

TEST(mirrored_layers, joints_that_the_mirror_alone_moves_are_moved) {
  const LopsidedRest lopsided;
  Scene scene = lopsided.scene;
  scene.animations.erase(scene.animations.begin());  // the remaining clip rests
  scene.clips.clear();
  finish_scene(scene);
  const Plan plan = compile_plan(lend(scene), lopsided.needs);
  FrameBuffer kept(plan), fresh(plan);
  const ClipLayer plain{0, 0.4}, turned{.clip = 0, .time_s = 0.4, .mirrored = true};
  ASSERT_EQ(run_plan(plan, {.layers = {&plain, 1}, .weights = {}, .root = {}}, kept), ErrorCode::ok);
  const std::vector<Affine> rest(kept.result().model.begin(), kept.result().model.end());
  for (FrameBuffer* frame : {&kept, &fresh})
    ASSERT_EQ(run_plan(plan, {.layers = {&turned, 1}, .weights = {}, .root = {}}, *frame), ErrorCode::ok);
  EXPECT_TRUE(same_bits<Affine>(kept.result().model, fresh.result().model));
  EXPECT_FALSE(same_bits<Affine>(kept.result().model, rest));
}

TEST(mirrored_layers, P07_scales_of_one_side_reach_the_other) {
  TwoClips two(scenes::RightSide::mirrored_axes);
  BoneAnimation& bone = two.scene.animations[0].bones[1];
  bone.scale = {Interpolation::step, {0.0f}, {glm::vec3(1, 2, 1)}};
  two.scene.animations.pop_back();
  two.scene.clips.clear();
  finish_scene(two.scene);
  const auto kind = [&](const Needs& needs, std::uint32_t joint) {
    return compile_plan(lend(two.scene), needs).compiled()->joint_scales[joint].kind;
  };
  Needs needs = two.needs();
  EXPECT_EQ(kind(needs, 3), ScaleKind::uneven);
  EXPECT_EQ(kind(needs, 6), ScaleKind::none);
  needs.in.mirror = nullptr;
  EXPECT_EQ(kind(needs, 3), ScaleKind::none);
}

TEST(mirrored_layers, partners_of_joints_that_are_kept_stay_in_a_skeleton_lod) {
  const TwoClips two(scenes::RightSide::any_axes);
  Needs needs = two.needs();
  const Plan full = compile_plan(lend(two.scene), needs);
  needs.out.skeleton_lod.kept = {true, true,  true,  true,  true,  true,  false,
                                 true, false, false, false, false, false, false};
  const Plan lean = compile_plan(lend(two.scene), needs);
  const ClipLayer turned{.clip = kClip, .time_s = 0.8, .mirrored = true};
  const std::vector<Affine> all = two.model(full, {&turned, 1}), some = two.model(lean, {&turned, 1});
  ASSERT_EQ(some.size(), 9u) << "the right arm and foot are kept with the left ones";
  for (std::uint32_t j = 0; j < 9; ++j) EXPECT_EQ(some[j], all[j]) << j;
}

TEST(mirrored_layers, morph_weights_of_partners_are_exchanged) {
  RandomSceneOptions options;
  options.targets = 3;
  const Scene scene = random_scene(5, options);
  Needs needs;
  needs.in.mirror = std::make_shared<const MirrorMap>(some_mirror(scene));
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer plain(plan), turned(plan);
  const ClipLayer layer{0, 0.6}, mirrored{.clip = 0, .time_s = 0.6, .mirrored = true};
  ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, plain), ErrorCode::ok);
  ASSERT_EQ(run_plan(plan, {.layers = {&mirrored, 1}, .weights = {}, .root = {}}, turned), ErrorCode::ok);
  const std::span<const float> before = plain.result().weights, after = turned.result().weights;
  ASSERT_GT(before.size(), 2u);
  for (std::size_t w = 0; w < before.size(); ++w) EXPECT_EQ(after[w], before[needs.in.mirror->weight_source[w]]) << w;
  EXPECT_NE(before[0], before[2]);
}

}  // namespace
}  // namespace sinew::test
