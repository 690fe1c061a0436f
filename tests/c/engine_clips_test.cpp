// SPDX-License-Identifier: MIT
// Libraries, mirroring and retargeting: the C interface gives the bits of the C++ one. C code in engine_clips.c makes
// the calls.
#include "tests/c/engine_clips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <string>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/model/mirror_scene.h"
#include "runtime/plan/run_plan.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/retarget_animation.h"
#include "tests/c/numbers.h"
#include "tests/library/named_scene.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

/// A body with Mixamo's joint names on two straight legs. It bends its left leg and walks on within one second.
Scene walker(float size) {
  Scene scene;
  scene.skeleton = skeleton_of({kNone, 0, 0, 1, 2, 3, 4});
  const char* names[] = {"Hips", "LeftUpLeg", "RightUpLeg", "LeftLeg", "RightLeg", "LeftFoot", "RightFoot"};
  const glm::vec3 places[] = {{0, 1, 0},        {0.1f, 0, 0},     {-0.1f, 0, 0},   {0, -0.5f, 0},
                              {0, -0.5f, 0.0f}, {0, -0.4f, 0.0f}, {0, -0.4f, 0.0f}};
  for (std::size_t j = 0; j < std::size(names); ++j) {
    scene.skeleton.names[j] = names[j];
    scene.skeleton.rest[j].translation = places[j] * (j == 3 || j == 4 ? size * size : size);
  }
  Animation walk{"walk", 1.0, {}, {}};
  BoneAnimation hips, thigh, shank;
  hips.joint = 0;
  hips.translation = {Interpolation::linear, {0, 1}, {{0, size, 0}, {0.02f, size * 0.9f, 0.3f}}};
  thigh.joint = 1;
  thigh.rotation = {Interpolation::linear, {0, 1}, {{1, 0, 0, 0}, glm::angleAxis(-0.6f, glm::vec3(1, 0, 0))}};
  shank.joint = 3;
  shank.rotation = {Interpolation::linear, {0, 1}, {{1, 0, 0, 0}, glm::angleAxis(0.9f, glm::vec3(1, 0, 0))}};
  walk.bones = {hips, thigh, shank};
  scene.animations = {walk};
  finish_scene(scene);
  return scene;
}

std::vector<float> model_of(const Scene& scene, const PoseSpan& pose) {
  std::vector<Affine> model(scene.skeleton.joint_count());
  EXPECT_EQ(run(LocalToModelJob{.skeleton = &scene.skeleton, .local = pose, .root = {}, .model = model}),
            ErrorCode::ok);
  std::vector<float> numbers;
  add_numbers<Affine>(numbers, model);
  return numbers;
}

std::vector<float> model_of(const Scene& scene, const Clip& clip, double time_s) {
  PoseBuffer pose(scene.skeleton.joint_count());
  EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
  return model_of(scene, pose.span());
}

sinew_library* library_of(const sinew_scene& skeleton, std::initializer_list<const sinew_scene*> files) {
  sinew_library* library = nullptr;
  EXPECT_EQ(sinew_library_create(&skeleton, &library), SINEW_OK);
  for (const sinew_scene* file : files) EXPECT_EQ(sinew_library_add(library, file, SINEW_LEAVE_OUT, nullptr), SINEW_OK);
  return library;
}

TEST(c_clips, a_library_plays_the_clips_of_its_files) {
  const sinew_scene body{named_scene(3)};
  Scene others = body.scene;
  for (Animation& animation : others.animations) animation.name += " again";
  others.animations.erase(others.animations.begin());
  finish_scene(others);
  const sinew_scene more{others};
  sinew_library* library = library_of(body, {&body, &more});
  const std::size_t own = body.scene.clips.size();
  ASSERT_EQ(sinew_library_clip_count(library), own + others.clips.size());
  EXPECT_EQ(sinew_library_find(library, "clip 1 again"), own);
  EXPECT_EQ(sinew_library_find(library, "clip 2 of none"), SINEW_NONE);
  const sinew_string name = sinew_library_clip_name(library, 1);
  EXPECT_EQ(std::string(name.data, name.length), "clip 1");
  EXPECT_EQ(sinew_library_clip_duration_s(library, 1), body.scene.clips[1].duration_s());
  const sinew_layer layer{0.3, static_cast<std::uint32_t>(own), SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
  sinew_frame_input input = sinew_default_input();
  input.layers = &layer;
  input.layer_count = 1;
  Numbers read, expected;
  ASSERT_EQ(engine_play_from_library(&body, library, nullptr, &input, &read), SINEW_OK);
  const sinew_layer alone{0.3, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
  input.layers = &alone;
  ASSERT_EQ(engine_play(&more, nullptr, &input, nullptr, &expected), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(read.all(), expected.all()));
}

TEST(c_clips, names_that_do_not_bind_are_listed_or_refused) {
  const sinew_scene body{walker(1.0f)};
  Scene renamed = body.scene;
  renamed.skeleton.names[1] = "Thigh";
  renamed.skeleton.names[3] = "Shank";
  finish_scene(renamed);
  const sinew_scene other{renamed};
  sinew_library* library = library_of(body, {});
  sinew_messages* unbound = nullptr;
  EXPECT_EQ(sinew_library_add(library, &other, SINEW_REFUSE, &unbound), SINEW_UNBOUND);
  EXPECT_EQ(sinew_library_clip_count(library), 0u);
  ASSERT_EQ(sinew_message_count(unbound), 2u);
  EXPECT_STREQ(sinew_message(unbound, 0), "missing: Thigh");
  EXPECT_STREQ(sinew_message(unbound, 1), "missing: Shank");
  sinew_messages_destroy(unbound);
  EXPECT_EQ(sinew_library_add(library, &other, SINEW_LEAVE_OUT, &unbound), SINEW_OK);
  EXPECT_EQ(sinew_message_count(unbound), 2u);
  sinew_messages_destroy(unbound);
  EXPECT_EQ(sinew_library_add(library, &body, SINEW_REFUSE, &unbound), SINEW_OK);
  EXPECT_EQ(unbound, nullptr) << "all bind";
  EXPECT_EQ(sinew_library_clip_count(library), 2u);
  EXPECT_EQ(sinew_library_find(library, "walk"), SINEW_NONE) << "two have the name";
  renamed.skeleton.names = body.scene.skeleton.names;
  renamed.skeleton.names[1] = renamed.skeleton.names[3];
  finish_scene(renamed);
  const sinew_scene twins{renamed};
  EXPECT_EQ(sinew_library_add(library, &twins, SINEW_REFUSE, &unbound), SINEW_UNBOUND);
  ASSERT_EQ(sinew_message_count(unbound), 1u);
  EXPECT_EQ(sinew_message(unbound, 0), "ambiguous: " + renamed.skeleton.names[3]);
  sinew_messages_destroy(unbound);
  EXPECT_EQ(sinew_library_add(library, &body, 2, nullptr), SINEW_UNSUPPORTED);
  EXPECT_STREQ(sinew_describe(SINEW_UNBOUND), "clips move what the skeleton or the scene does not have");
  sinew_library_destroy(library);
}

TEST(c_clips, mirrored_layers_and_poses_are_those_of_the_cpp_interface) {
  const sinew_scene body{walker(1.0f)};
  Numbers by_frame, by_pose;
  ASSERT_EQ(engine_mirror(&body, 0.7, &by_frame, &by_pose), SINEW_OK);
  Needs needs;
  needs.in.mirror = std::make_shared<const MirrorMap>(make_mirror_map(body.scene));
  const Plan plan = compile_plan(lend(body.scene), needs);
  FrameBuffer frame(plan);
  ClipLayer layer{0, 0.7};
  layer.mirrored = true;
  FrameInput input;
  input.layers = {&layer, 1};
  ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  std::vector<float> expected;
  add_numbers(expected, frame.result().model);
  EXPECT_TRUE(same_bits<float>(by_frame.all(), expected));
  EXPECT_TRUE(same_bits<float>(by_pose.all(), expected));
  EXPECT_FALSE(same_bits<float>(expected, model_of(body.scene, body.scene.clips[0], 0.7)));
}

TEST(c_clips, a_mirror_says_who_is_whose_partner_and_fits_its_scene_alone) {
  const sinew_scene body{walker(1.0f)}, other{arm_scene()};
  sinew_mirror* mirror = nullptr;
  ASSERT_EQ(sinew_mirror_create(&body, &mirror), SINEW_OK);
  sinew_mirror_info info{};
  info.struct_size = sizeof(info);
  ASSERT_EQ(sinew_get_mirror(mirror, &info), SINEW_OK);
  EXPECT_EQ(std::vector(info.partner.data, info.partner.data + info.partner.count),
            (std::vector<std::uint32_t>{0, 2, 1, 4, 3, 6, 5}));
  EXPECT_EQ(info.unpaired.count, 0u);
  EXPECT_EQ(std::abs(info.plane_normal.x), 1.0f);
  sinew_needs needs = sinew_default_needs();
  needs.mirror = mirror;
  sinew_plan* plan = nullptr;
  EXPECT_EQ(sinew_plan_create(&other, &needs, &plan), SINEW_SIZE_MISMATCH);
  const sinew_layer layer{0.5, 0, SINEW_NONE, 1.0f, SINEW_LAYER_MIRRORED};
  sinew_frame_input input = sinew_default_input();
  input.layers = &layer;
  input.layer_count = 1;
  Numbers read;
  EXPECT_EQ(engine_play(&body, nullptr, &input, nullptr, &read), SINEW_NOT_IN_NEEDS) << "a plan without a mirror";
  sinew_mirror_destroy(mirror);
}

TEST(c_clips, retargeted_poses_are_those_of_the_cpp_interface) {
  const sinew_scene source{walker(1.0f)}, target{walker(0.7f)};
  const Scene &from = source.scene, &to = target.scene;
  const SkeletonMap map = make_skeleton_map(from.skeleton, to.skeleton);
  const RetargetTables tables = make_retarget_tables(map, from.skeleton, to.skeleton);
  const FeetMap feet = make_feet_map(map, from.skeleton, to.skeleton);
  ASSERT_EQ(feet.legs.size(), 2u);
  for (const int held : {0, 1}) {
    PoseBuffer pose(7), scratch(7), retargeted(7);
    EXPECT_EQ(run(SampleClipJob{.clip = &from.clips[0], .time_s = 0.8, .pose = pose.span(), .weights = {}}),
              ErrorCode::ok);
    EXPECT_EQ(run(RetargetPoseJob{&tables, pose.span(), scratch.span(), retargeted.span()}), ErrorCode::ok);
    const auto ground = static_cast<float>(find_ground(feet, from.animations[0], from.skeleton));
    if (held) {
      EXPECT_EQ(run(HoldFeetJob{&feet, ground, pose.span(), retargeted.span()}), ErrorCode::ok);
    }
    Numbers read;
    ASSERT_EQ(engine_retarget(&source, &target, 0.8, held, &read), SINEW_OK);
    EXPECT_TRUE(same_bits<float>(read.all(), model_of(to, retargeted.span()))) << held;
  }
}

TEST(c_clips, a_retargeted_clip_joins_a_library_and_the_map_says_what_it_did) {
  const sinew_scene source{walker(1.0f)}, target{walker(0.7f)};
  const Scene &from = source.scene, &to = target.scene;
  sinew_skeleton_map* map = nullptr;
  ASSERT_EQ(sinew_skeleton_map_create(&source, &target, nullptr, &map), SINEW_OK);
  sinew_skeleton_map_info info{};
  info.struct_size = sizeof(info);
  ASSERT_EQ(sinew_get_skeleton_map(map, &info), SINEW_OK);
  EXPECT_EQ(info.pair_count, 7u);
  EXPECT_EQ(info.leg_count, 2u);
  EXPECT_EQ(info.unmapped_source.count + info.unmapped_target.count, 0u);
  sinew_library* library = library_of(target, {});
  for (const std::uint32_t held : {0u, 1u})
    ASSERT_EQ(sinew_library_add_retargeted(library, map, 0, held, SINEW_REFUSE, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_library_add_retargeted(library, map, 1, 0, SINEW_REFUSE, nullptr), SINEW_INDEX_OUT_OF_RANGE);
  const SkeletonMap in_cpp = make_skeleton_map(from.skeleton, to.skeleton);
  EXPECT_EQ(info.height_ratio, in_cpp.height_ratio);
  Animation made = retarget_animation(from.animations[0], in_cpp, from.skeleton, to.skeleton);
  for (const std::size_t clip : {0u, 1u}) {
    if (clip == 1)
      hold_feet(make_feet_map(in_cpp, from.skeleton, to.skeleton), from.animations[0], from.skeleton, to.skeleton,
                made);
    const Clip expected = compile_clip(made, to.skeleton, {}, to.first_weight);
    EXPECT_TRUE(same_bits<float>(model_of(to, library->clips[clip], 0.8), model_of(to, expected, 0.8))) << clip;
  }
  sinew_library_destroy(library);
  sinew_skeleton_map_destroy(map);
}

TEST(c_clips, morph_weights_and_properties_of_equal_names_come_along) {
  Scene moving = face_scene(), resting = face_scene();
  moving.materials.emplace_back().name = "skin";
  PropertyTrack glows{{PropertyKind::roughness, 0}, {Interpolation::linear, {0.0f, 1.0f}, {0.0f, 1.0f}, 1}},
      fades{{PropertyKind::metallic, 0}, {Interpolation::linear, {0.0f, 1.0f}, {0.0f, 1.0f}, 1}};
  moving.animations[0].properties = {glows, fades};
  resting.materials = moving.materials;
  resting.meshes[0].name = "another face";
  resting.animations[0] = {"own", 1.0, {}, {}, {glows}};
  finish_scene(moving);
  finish_scene(resting);
  const sinew_scene source{moving}, target{resting};
  sinew_skeleton_map* map = nullptr;
  ASSERT_EQ(sinew_skeleton_map_create(&source, &target, nullptr, &map), SINEW_OK);
  sinew_library* library = library_of(target, {});
  ASSERT_EQ(sinew_library_add_retargeted(library, map, 0, 0, SINEW_REFUSE, nullptr), SINEW_OK);
  const Sample found = sample(library->clips[0], 0.5);
  EXPECT_EQ(found.weights, (std::vector<float>{0.5f, 1.0f}));
  EXPECT_EQ(found.numbers, (std::vector<float>{0.5f})) << "the target animates the roughness alone";
  sinew_library_destroy(library);
  sinew_skeleton_map_destroy(map);
}

TEST(c_clips, the_pairs_that_an_engine_names_are_all_that_is_mapped) {
  const sinew_scene source{walker(1.0f)}, target{walker(0.7f)};
  const sinew_joint_pair pairs[] = {{0, 0}, {1, 2}};
  sinew_skeleton_map_options options{sizeof(options), pairs, 2, SINEW_LIMBS_OF_REST, 0, nullptr, 0};
  sinew_skeleton_map* map = nullptr;
  ASSERT_EQ(sinew_skeleton_map_create(&source, &target, &options, &map), SINEW_OK);
  sinew_skeleton_map_info info{};
  info.struct_size = sizeof(info);
  ASSERT_EQ(sinew_get_skeleton_map(map, &info), SINEW_OK);
  ASSERT_EQ(info.pair_count, 2u);
  EXPECT_EQ(info.pairs[1].source, 1u);
  EXPECT_EQ(info.pairs[1].target, 2u);
  EXPECT_EQ(info.unmapped_target.count, 5u);
  sinew_skeleton_map_destroy(map);
  const sinew_joint_pair twice[] = {{0, 0}, {1, 0}}, beyond[] = {{0, 7}};
  options.pairs = twice;
  EXPECT_EQ(sinew_skeleton_map_create(&source, &target, &options, &map), SINEW_UNSUPPORTED);
  options = {sizeof(options), beyond, 1, SINEW_LIMBS_OF_REST, 0, nullptr, 0};
  EXPECT_EQ(sinew_skeleton_map_create(&source, &target, &options, &map), SINEW_INDEX_OUT_OF_RANGE);
  options = {sizeof(options), nullptr, 1, SINEW_LIMBS_OF_REST, 0, nullptr, 0};
  EXPECT_EQ(sinew_skeleton_map_create(&source, &target, &options, &map), SINEW_NULL_ARGUMENT);
  options = {sizeof(options), nullptr, 0, 2, 0, nullptr, 0};
  EXPECT_EQ(sinew_skeleton_map_create(&source, &target, &options, &map), SINEW_UNSUPPORTED);
  options = {4, nullptr, 0, 0, 0, nullptr, 0};
  EXPECT_EQ(sinew_skeleton_map_create(&source, &target, &options, &map), SINEW_WRONG_STRUCT_SIZE);
}

TEST(c_clips, joints_of_pairs_and_rules_are_checked_against_their_own_skeleton) {
  Scene larger = walker(0.7f);
  larger.skeleton = chain_skeleton(9);
  larger.animations.clear();
  finish_scene(larger);
  const sinew_scene seven{walker(1.0f)}, nine{larger};
  const auto answer = [](const sinew_scene& source, const sinew_scene& target, sinew_joint_pair pair,
                         std::uint32_t joint_of_rule) {
    const sinew_chain_rule rule{joint_of_rule, SINEW_KEEP};
    const sinew_skeleton_map_options options{sizeof(options), &pair, 1, SINEW_LIMBS_OF_REST, 0, &rule, 1};
    sinew_skeleton_map* map = nullptr;
    const sinew_error error = sinew_skeleton_map_create(&source, &target, &options, &map);
    sinew_skeleton_map_destroy(map);
    return error;
  };
  EXPECT_EQ(answer(seven, nine, {6, 8}, 8), SINEW_OK);
  EXPECT_EQ(answer(seven, nine, {7, 8}, 8), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(answer(seven, nine, {6, 8}, 9), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(answer(nine, seven, {8, 6}, 6), SINEW_OK);
  EXPECT_EQ(answer(nine, seven, {8, 7}, 6), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(answer(nine, seven, {8, 6}, 7), SINEW_INDEX_OUT_OF_RANGE);
}

TEST(c_clips, twist_joints_share_what_a_foot_is_twisted_in_poses_and_clips) {
  Scene turning = walker(1.0f), rolling = walker(0.7f);
  BoneAnimation foot;
  foot.joint = 5;
  foot.rotation = {Interpolation::linear, {0, 1}, {{1, 0, 0, 0}, glm::angleAxis(0.8f, glm::vec3(0, 1, 0))}};
  turning.animations[0].bones.push_back(foot);
  Skeleton& skeleton = rolling.skeleton;
  const Skeleton before = skeleton;
  skeleton = skeleton_of({kNone, 0, 0, 1, 2, 3, 4, 3});
  for (std::size_t j = 0; j < 7; ++j) {
    skeleton.names[j] = before.names[j];
    skeleton.rest[j] = before.rest[j];
  }
  skeleton.names[7] = "LeftLegRoll";
  skeleton.rest[7].translation = 0.5f * skeleton.rest[5].translation;
  for (Scene* scene : {&turning, &rolling}) finish_scene(*scene);
  const sinew_scene source{turning}, target{rolling};
  sinew_skeleton_map* map = nullptr;
  ASSERT_EQ(sinew_skeleton_map_create(&source, &target, nullptr, &map), SINEW_OK);
  sinew_skeleton_map_info info{};
  info.struct_size = sizeof(info);
  ASSERT_EQ(sinew_get_skeleton_map(map, &info), SINEW_OK);
  EXPECT_EQ(info.twist_count, 1u);
  PoseBuffer from(7), scratch(7), to(8);
  const sinew_pose pose{from.span().planes, 7}, room{scratch.span().planes, 7}, out{to.span().planes, 8};
  ASSERT_EQ(sinew_pose_sample(&source, 0, 1.0, &pose), SINEW_OK);
  ASSERT_EQ(sinew_retarget_pose(map, &pose, &room, &out), SINEW_OK);
  const glm::quat half = glm::angleAxis(0.4f, glm::vec3(0, 1, 0));
  EXPECT_LE(rotation_angle_between(to.span().get(7).rotation, half), 1e-5f);
  sinew_library* library = library_of(target, {});
  ASSERT_EQ(sinew_library_add_retargeted(library, map, 0, 0, SINEW_REFUSE, nullptr), SINEW_OK);
  EXPECT_LE(rotation_angle_between(sample(library->clips[0], 1.0).pose[7].rotation, half), 1e-5f);
  sinew_library_destroy(library);
  sinew_skeleton_map_destroy(map);
}

TEST(c_clips, translations_follow_the_rules_that_an_engine_gives) {
  const sinew_scene source{walker(1.0f)}, target{walker(0.7f)};
  const Skeleton &from = source.scene.skeleton, &to = target.scene.skeleton;
  const auto made = [&](const sinew_skeleton_map_options& options) {
    sinew_skeleton_map* map = nullptr;
    EXPECT_EQ(sinew_skeleton_map_create(&source, &target, &options, &map), SINEW_OK);
    std::vector<bool> moves;
    for (const MappedJoint& joint : map->map.joints) moves.push_back(joint.moves);
    sinew_skeleton_map_destroy(map);
    return moves;
  };
  const auto expected = [&](const SkeletonMapOptions& options) {
    std::vector<bool> moves;
    for (const MappedJoint& joint : make_skeleton_map(from, to, options).joints) moves.push_back(joint.moves);
    return moves;
  };
  sinew_skeleton_map_options options{};
  options.struct_size = sizeof(options);
  EXPECT_EQ(made(options), expected({}));
  options.translations = SINEW_KEEP;
  EXPECT_EQ(made(options), std::vector<bool>(7)) << "no joint moves";
  const sinew_chain_rule chains[] = {{2, SINEW_BY_LENGTH}, {3, SINEW_KEEP}};
  options.chains = chains;
  options.chain_count = 2;
  const std::vector<bool> by_chains = made(options);
  EXPECT_EQ(by_chains, expected({.pairs = {},
                                 .limbs = LimbDirections::of_source,
                                 .translations = TranslationRule::keep,
                                 .chains = {{2, TranslationRule::by_length}, {3, TranslationRule::keep}}}));
  EXPECT_TRUE(by_chains[2]);
  EXPECT_FALSE(by_chains[3]);
}

TEST(c_clips, rules_for_translations_that_cannot_be_are_refused) {
  const sinew_scene source{walker(1.0f)}, target{walker(0.7f)};
  sinew_skeleton_map* map = nullptr;
  const auto answer = [&](std::uint32_t translations, const sinew_chain_rule* chains, std::size_t count) {
    const sinew_skeleton_map_options options{sizeof(options), nullptr, 0, 0, translations, chains, count};
    return sinew_skeleton_map_create(&source, &target, &options, &map);
  };
  const sinew_chain_rule unknown[] = {{0, 3}}, beyond[] = {{7, SINEW_KEEP}},
                         twice[] = {{1, SINEW_KEEP}, {1, SINEW_BY_LENGTH}};
  EXPECT_EQ(answer(3, nullptr, 0), SINEW_UNSUPPORTED);
  EXPECT_EQ(answer(0, unknown, 1), SINEW_UNSUPPORTED);
  EXPECT_EQ(answer(0, beyond, 1), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(answer(0, twice, 2), SINEW_UNSUPPORTED);
  EXPECT_EQ(answer(0, nullptr, 1), SINEW_NULL_ARGUMENT);
}

TEST(c_clips, joints_of_poses_are_read_and_written) {
  const sinew_scene body{walker(1.0f)};
  PoseBuffer memory(7);
  const sinew_pose pose{memory.span().planes, 7};
  ASSERT_EQ(sinew_pose_rest(&body, &pose), SINEW_OK);
  sinew_transform joint{};
  ASSERT_EQ(sinew_pose_get(&pose, 3, &joint), SINEW_OK);
  EXPECT_EQ(joint.translation.y, -0.5f);
  EXPECT_EQ(joint.rotation.w, 1.0f);
  joint = {{1, 2, 3}, {0, 0, 1, 0}, {4, 5, 6}};
  ASSERT_EQ(sinew_pose_set(&pose, 3, &joint), SINEW_OK);
  const Transform set = memory.span().get(3);
  EXPECT_EQ(set.translation, glm::vec3(1, 2, 3));
  EXPECT_EQ(set.rotation, glm::quat(0, 0, 0, 1));
  EXPECT_EQ(set.scale, glm::vec3(4, 5, 6));
  joint.scale.y = NAN;
  EXPECT_EQ(sinew_pose_set(&pose, 3, &joint), SINEW_NOT_FINITE);
  EXPECT_EQ(sinew_pose_get(&pose, 7, &joint), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_pose_set(&pose, 7, &joint), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_pose_sample(&body, 1, 0.0, &pose), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_pose_sample(&body, 0, NAN, &pose), SINEW_NOT_FINITE);
  sinew_affine model[6];
  EXPECT_EQ(sinew_pose_to_model(&body, &pose, nullptr, model, 6), SINEW_SIZE_MISMATCH);
}

TEST(c_clips, calls_without_what_they_need_answer_codes) {
  const sinew_scene body{walker(1.0f)};
  sinew_library* library = nullptr;
  sinew_skeleton_map* map = nullptr;
  sinew_plan* plan = nullptr;
  EXPECT_EQ(engine_bad_poses(&body), 0);
  EXPECT_EQ(sinew_library_create(nullptr, &library), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_library_create(&body, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_library_add(nullptr, &body, SINEW_LEAVE_OUT, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_library_clip_count(nullptr), 0u);
  EXPECT_EQ(sinew_library_clip_name(nullptr, 0).length, 0u);
  EXPECT_EQ(sinew_library_clip_duration_s(nullptr, 0), 0.0);
  EXPECT_EQ(sinew_library_find(nullptr, "walk"), SINEW_NONE);
  EXPECT_EQ(sinew_plan_create_from_library(&body, nullptr, nullptr, nullptr, &plan), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_mirror_create(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_get_mirror(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_skeleton_map_create(&body, nullptr, nullptr, &map), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_get_skeleton_map(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_retarget_pose(nullptr, nullptr, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_find_ground(nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_library_add_retargeted(nullptr, nullptr, 0, 0, 0, nullptr), SINEW_NULL_ARGUMENT);
  sinew_library_destroy(nullptr);
  sinew_mirror_destroy(nullptr);
  sinew_skeleton_map_destroy(nullptr);
}

}  // namespace
}  // namespace sinew::test
