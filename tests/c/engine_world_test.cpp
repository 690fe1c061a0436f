// SPDX-License-Identifier: MIT
// Root motion, sockets, clip files, bounds, levels of detail and tasks: the C interface gives the bits of the C++ one.
// C code in engine_world.c makes the calls.
#include "tests/c/engine_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/clip/clip_file.h"
#include "runtime/clip/decompile_clip.h"
#include "runtime/lod/clip_bounds.h"
#include "runtime/lod/interpolated_input.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/root_motion.h"
#include "tests/c/numbers.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

template <class A, class B>
bool same_bytes(const A& a, const B& b) {
  static_assert(sizeof(A) == sizeof(B));
  return std::memcmp(&a, &b, sizeof(A)) == 0;
}

TEST(c_world, root_motion_is_that_of_the_cpp_interface) {
  const sinew_scene scene{random_scene(3)};
  const Animation& animation = scene.scene.animations[1];
  std::size_t moved = 0;
  for (const BoneAnimation& bone : animation.bones)
    for (std::uint32_t mode = SINEW_PLAY_LOOP; mode <= SINEW_PLAY_ONCE; ++mode) {
      sinew_root_parts parts = sinew_default_root_parts();
      parts.turn = mode % 4;
      parts.y = mode % 2;
      const RootMotionParts in_cpp{true, mode % 2 != 0, true, static_cast<RootTurn>(mode % 4)};
      sinew_dual_quat world;
      sinew_affine root;
      ASSERT_EQ(engine_walk(&scene, 1, bone.joint, &parts, mode, 0.37, 12, &world, &root), SINEW_OK);

      const Transform& rest = scene.scene.skeleton.rest[bone.joint];
      PlaybackClock clock(animation.duration_s, static_cast<PlayMode>(mode));
      DualQuatd expected;
      for (int i = 0; i < 12; ++i)
        expected = normalised(expected * root_motion(bone, rest, in_cpp, clock.advance(0.37)));
      EXPECT_TRUE(same_bytes(world, expected));
      const DualQuatd place = root_place(bone, rest, in_cpp, clock.time_s());
      const DualQuatd above = normalised(expected * dual_quat_conjugate(place));
      EXPECT_TRUE(same_bytes(root, affine_cast<float>(affine_from_dual_quat(above))));
      moved += !same_bytes(world, sinew_dual_quat_identity());
    }
  EXPECT_GT(moved, 4u);
}

TEST(c_world, root_motion_joins_the_animations_of_a_joint) {
  Scene parted = random_scene(3);
  std::vector<BoneAnimation>& bones = parted.animations[1].bones;
  const auto whole = std::find_if(bones.begin(), bones.end(),
                                  [](const auto& b) { return !b.translation.empty() && !b.rotation.empty(); });
  ASSERT_NE(whole, bones.end());
  const BoneAnimation bone = *whole;
  *whole = {.joint = bone.joint, .translation = {Interpolation::step, {0.0f}, {glm::vec3(9.0f)}}};
  bones.push_back({.joint = bone.joint, .translation = bone.translation});
  bones.push_back({.joint = bone.joint, .rotation = bone.rotation});
  const sinew_scene scene{parted};
  sinew_root_parts parts = sinew_default_root_parts();
  parts.turn = SINEW_ROOT_TURN_FULL;
  sinew_dual_quat place, motion;
  ASSERT_EQ(sinew_root_place(&scene, 1, bone.joint, &parts, 0.6, &place), SINEW_OK);
  const Transform& rest = parted.skeleton.rest[bone.joint];
  const RootMotionParts in_cpp{.turn = RootTurn::full};
  EXPECT_TRUE(same_bytes(place, root_place(bone, rest, in_cpp, 0.6)));
  sinew_clock clock;
  ASSERT_EQ(sinew_clock_init(&clock, parted.animations[1].duration_s, SINEW_PLAY_LOOP, 1.0), SINEW_OK);
  PlaybackClock clock_in_cpp(parted.animations[1].duration_s, PlayMode::loop);
  sinew_step step;
  ASSERT_EQ(sinew_clock_advance(&clock, 0.4, &step), SINEW_OK);
  ASSERT_EQ(sinew_root_motion(&scene, 1, bone.joint, &parts, &step, &motion), SINEW_OK);
  EXPECT_TRUE(same_bytes(motion, root_motion(bone, rest, in_cpp, clock_in_cpp.advance(0.4))));
}

TEST(c_world, root_motion_of_a_library_is_that_of_its_clips_bound_to_the_scene) {
  const sinew_scene scene{random_scene(3)};
  sinew_library* library = nullptr;
  ASSERT_EQ(sinew_library_create(&scene, &library), SINEW_OK);
  ASSERT_EQ(sinew_library_add(library, &scene, SINEW_REFUSE, nullptr), SINEW_OK);
  const BoundClips clips = clips_for(library->clips, scene.scene);
  sinew_root_parts parts = sinew_default_root_parts();
  parts.turn = SINEW_ROOT_TURN_FULL;
  const RootMotionParts in_cpp{.turn = RootTurn::full};
  for (std::uint32_t joint = 0; joint < scene.scene.skeleton.joint_count(); ++joint) {
    sinew_root_track* track = nullptr;
    ASSERT_EQ(sinew_root_track_create(&scene, library, 1, joint, &parts, &track), SINEW_OK);
    const BoneAnimation bone = decompile_joint(clips.clips[1], joint);
    const Transform& rest = scene.scene.skeleton.rest[joint];
    sinew_dual_quat place, motion;
    ASSERT_EQ(sinew_root_track_place(track, 0.6, &place), SINEW_OK);
    EXPECT_TRUE(same_bytes(place, root_place(bone, rest, in_cpp, 0.6)));
    PlaybackClock clock(clips.clips[1].duration_s());
    const PlaybackStep step = clock.advance(5.3);
    sinew_step in_c{};
    static_assert(sizeof in_c >= sizeof step);
    std::memcpy(&in_c, &step, sizeof step);
    ASSERT_EQ(sinew_root_track_motion(track, &in_c, &motion), SINEW_OK);
    EXPECT_TRUE(same_bytes(motion, root_motion(bone, rest, in_cpp, step)));
    sinew_root_track_destroy(track);
  }
  sinew_library_destroy(library);
}

TEST(c_world, a_joint_that_the_clip_leaves_alone_carries_nothing) {
  const sinew_scene scene{arm_scene()};
  sinew_dual_quat world;
  sinew_affine root;
  const std::uint32_t holder = sinew_find_joint(&scene, "holder");
  ASSERT_EQ(engine_walk(&scene, 0, holder, nullptr, SINEW_PLAY_LOOP, 0.4, 5, &world, &root), SINEW_OK);
  EXPECT_NEAR(world.real[3], 1.0, 1e-15);
  for (const double d : world.dual) EXPECT_NEAR(d, 0.0, 1e-14);
}

TEST(c_world, sockets_and_skeleton_lod_are_those_of_the_cpp_interface) {
  std::size_t levels_that_leave_out = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    for (const double tolerance_m : {0.0, 0.05, 10.0}) {
      const sinew_scene scene{random_scene(seed)};
      const sinew_layer layer{0.7, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
      sinew_frame_input input = sinew_default_input();
      input.layers = &layer;
      input.layer_count = 1;
      const sinew_affine offset{{{0, 1, 0, 0.5f}, {-1, 0, 0, 2}, {0, 0, 1, -3}}};
      Numbers read;
      ASSERT_EQ(engine_play_lod(&scene, tolerance_m, &input, &offset, &read), SINEW_OK);

      const CompiledSkeletonLod lod = compile_skeleton_lod(scene.scene, tolerance_m);
      Needs needs;
      needs.out.skeleton_lod = lod.detail;
      const Plan plan = compile_plan(lend(scene.scene), needs);
      FrameBuffer frame(plan);
      const ClipLayer in_cpp{0, 0.7};
      ASSERT_EQ(run_plan(plan, {.layers = {&in_cpp, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      Affine from_joint;
      std::memcpy(static_cast<void*>(&from_joint), &offset, sizeof(offset));
      std::vector<float> expected;
      for (std::uint32_t j = 0; j < scene.scene.skeleton.joint_count(); ++j) {
        const Affine socket = world_of(plan, frame.result().model, j) * from_joint;
        add_numbers(expected, std::span(&socket, 1));
      }
      expected.insert(expected.end(), {static_cast<float>(lod.left_out), static_cast<float>(lod.worst_joint),
                                       static_cast<float>(lod.measured_m)});
      for (const bool kept : lod.detail.kept) expected.push_back(kept);
      EXPECT_TRUE(same_bits<float>(read.all(), expected)) << seed << " " << tolerance_m;
      levels_that_leave_out += lod.left_out > 0;
    }
  EXPECT_GE(levels_that_leave_out, 6u);
}

TEST(c_world, clips_that_are_saved_and_loaded_play_the_same_bits) {
  sinew_scene scene{random_scene(2)};
  const sinew_layer layers[] = {{0.4, 0, SINEW_NONE, 0.5f, 0}, {0.9, 1, SINEW_NONE, 0.5f, 0}};
  sinew_frame_input input = sinew_default_input();
  input.layers = layers;
  input.layer_count = 2;
  Numbers before, after;
  ASSERT_EQ(engine_play(&scene, nullptr, &input, nullptr, &before), SINEW_OK);
  const Clip* clips[] = {&scene.scene.clips[0], &scene.scene.clips[1]};
  const std::size_t expected_bytes = save_clips(clips).size();
  std::size_t bytes = 0;
  ASSERT_EQ(engine_save_and_load(&scene, &bytes), SINEW_OK);
  EXPECT_EQ(bytes, expected_bytes);
  ASSERT_EQ(engine_play(&scene, nullptr, &input, nullptr, &after), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(before.all(), after.all()));
}

TEST(c_world, clips_are_saved_from_and_loaded_to_the_place_that_is_named) {
  Scene before = random_scene(2);
  for (const std::size_t c : {0u, 1u}) before.animations[c].name = c == 0 ? "walk" : "run";
  before.clips.clear();
  finish_scene(before);
  for (const std::uint32_t from : {0u, 1u})
    for (const std::uint32_t to : {0u, 1u}) {
      sinew_scene scene{before};
      sinew_clip_block* block = nullptr;
      ASSERT_EQ(sinew_clips_save(&scene, from, 1, &block), SINEW_OK);
      const sinew_flags bytes = sinew_clip_block_bytes(block);
      ASSERT_EQ(sinew_clips_load(&scene, to, bytes.data, bytes.count, nullptr), SINEW_OK);
      EXPECT_EQ(scene.scene.clips[to].name(), before.clips[from].name());
      EXPECT_EQ(scene.scene.clips[1 - to].name(), before.clips[1 - to].name()) << "the other one stays";
      sinew_clip_block_destroy(block);
    }
}

TEST(c_world, clips_that_do_not_fit_are_refused_and_the_scene_stays) {
  sinew_scene scene{random_scene(2)}, arm{arm_scene()};
  sinew_clip_block* block = nullptr;
  ASSERT_EQ(sinew_clips_save(&scene, 0, 2, &block), SINEW_OK);
  const sinew_flags bytes = sinew_clip_block_bytes(block);
  EXPECT_EQ(sinew_clips_load(&arm, 0, bytes.data, bytes.count, nullptr), SINEW_INDEX_OUT_OF_RANGE) << "two for one";
  EXPECT_EQ(sinew_clips_load(&scene, 1, bytes.data, bytes.count, nullptr), SINEW_INDEX_OUT_OF_RANGE);
  sinew_clip_block* one = nullptr;
  ASSERT_EQ(sinew_clips_save(&scene, 1, 1, &one), SINEW_OK);
  const sinew_flags one_bytes = sinew_clip_block_bytes(one);
  EXPECT_EQ(sinew_clips_load(&arm, 0, one_bytes.data, one_bytes.count, nullptr), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_clip_duration_s(&arm, 0), 1.0);

  std::vector<unsigned char> bad(bytes.data, bytes.data + bytes.count);
  bad[bad.size() / 2] ^= 1;
  sinew_messages* messages = nullptr;
  EXPECT_EQ(sinew_clips_load(&scene, 0, bad.data(), bad.size(), &messages), SINEW_BAD_FILE);
  ASSERT_EQ(sinew_message_count(messages), 1u);
  EXPECT_TRUE(std::string(sinew_message(messages, 0)).starts_with("clip-checksum at byte "))
      << sinew_message(messages, 0);
  sinew_messages_destroy(messages);

  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, nullptr, &plan), SINEW_OK);
  EXPECT_EQ(sinew_clips_load(&scene, 0, bytes.data, bytes.count, nullptr), SINEW_BUSY)
      << "the plan refers to the clips";
  sinew_plan_destroy(plan);
  EXPECT_EQ(sinew_clips_load(&scene, 0, bytes.data, bytes.count, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_clips_save(&scene, 1, 2, &block), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_FALSE(sinew_looks_like_clips(bad.data() + 1, bad.size() - 1));
  sinew_clip_block_destroy(one);
  sinew_clip_block_destroy(block);
}

TEST(c_world, bounds_of_clips_are_those_of_the_cpp_interface) {
  std::size_t known = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const sinew_scene scene{random_scene(seed)};
    sinew_needs needs = sinew_default_needs();
    needs.skinning = static_cast<std::uint32_t>(seed % 2);
    Needs in_cpp;
    in_cpp.skin.kind = static_cast<Skinning>(seed % 2);
    for (const std::uint32_t clip : {0u, 1u, SINEW_NONE}) {
      std::vector<sinew_box> boxes(scene.scene.instances.size() + 1);
      std::size_t count = 99;
      ASSERT_EQ(sinew_clip_bounds(&scene, &needs, clip, boxes.data(), boxes.size(), &count), SINEW_OK);
      const std::vector<Aabb> expected = clip_bounds(scene.scene, in_cpp, clip);
      ASSERT_EQ(count, expected.size());
      for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(same_bytes(boxes[i], expected[i]));
      known += count;
    }
    std::size_t count = 0;
    sinew_box box;
    EXPECT_EQ(sinew_clip_bounds(&scene, nullptr, 0, &box, 1, &count), SINEW_SIZE_MISMATCH);
    EXPECT_EQ(sinew_clip_bounds(&scene, nullptr, 7, &box, 1, &count), SINEW_INDEX_OUT_OF_RANGE);
  }
  EXPECT_GT(known, 8u);
}

/// Model matrices of frames with held or interpolated input, from the C++ interface.
std::vector<float> played_in_cpp(const Scene& scene, UpdateLevel level, std::uint32_t phase, bool interpolated,
                                 double dt_s, std::uint64_t frames) {
  Needs needs;
  needs.in.between_updates = true;
  const Plan plan = compile_plan(lend(scene), interpolated ? needs : Needs{});
  FrameBuffer buffer(plan);
  HeldInput held(plan);
  InterpolatedInput between(compile_plan(lend(scene), needs));
  std::vector<float> all;
  for (std::uint64_t frame = 0; frame < frames; ++frame) {
    const ClipLayer layer{0, dt_s * static_cast<double>(frame)};
    const ClipLayer ahead{0, dt_s * static_cast<double>(frame + frames_to_update(level, frame, phase))};
    FrameInput now;
    now.layers = {&layer, 1};
    now.root.row[1].w = 0.25f * static_cast<float>(frame);
    const FrameInput input =
        interpolated ? between.next(now, {&ahead, 1}, level, frame, phase) : held.next(now, level, frame, phase);
    EXPECT_EQ(run_plan(plan, input, buffer), ErrorCode::ok);
    add_numbers(all, buffer.result().model);
  }
  return all;
}

TEST(c_world, frames_of_update_levels_have_the_bits_of_the_cpp_interface) {
  const sinew_scene scene{random_scene(4)};
  std::vector<float> every;
  for (const bool interpolated : {false, true})
    for (std::uint32_t level = SINEW_UPDATE_EVERY; level <= SINEW_UPDATE_EVERY_FOURTH; ++level) {
      Numbers read;
      ASSERT_EQ(engine_play_level(&scene, level, 1, interpolated, 0.05, 14, &read), SINEW_OK);
      const auto expected = played_in_cpp(scene.scene, static_cast<UpdateLevel>(level), 1, interpolated, 0.05, 14);
      EXPECT_TRUE(same_bits<float>(read.all(), expected)) << level << (interpolated ? " interpolated" : " held");
      if (level == SINEW_UPDATE_EVERY) every = expected;
      EXPECT_EQ(same_bits<float>(read.all(), every), level == SINEW_UPDATE_EVERY);
    }
}

TEST(c_world, levels_are_chosen_as_in_cpp) {
  for (double size = 0.0; size < 0.5; size += 0.01)
    for (std::uint32_t before = 0; before <= 2; ++before)
      for (const double frame_s : {0.0, 0.016, 0.04, 0.2}) {
        std::uint32_t level = 99;
        ASSERT_EQ(sinew_choose_update_level(size, before, frame_s, nullptr, &level), SINEW_OK);
        EXPECT_EQ(level, static_cast<std::uint32_t>(
                             limited_level(update_level(size, static_cast<UpdateLevel>(before)), frame_s)));
      }
  sinew_update_rates rates = sinew_default_update_rates();
  rates.fourth_below = 0.5;
  std::uint32_t level = 0;
  ASSERT_EQ(sinew_choose_update_level(0.3, 0, 0.0, &rates, &level), SINEW_OK);
  EXPECT_EQ(level, static_cast<std::uint32_t>(SINEW_UPDATE_EVERY_FOURTH));
  EXPECT_EQ(sinew_screen_size(1.0, 10.0, 1.0), screen_size(1.0, 10.0, 1.0));
}

TEST(c_world, tasks_of_the_engine_have_the_bits_of_frames_that_run_alone) {
  const sinew_scene scene{random_scene(8)};
  const sinew_layer layer{0.6, 1, SINEW_NONE, 1.0f, 0};
  sinew_frame_input inputs[5];
  for (int i = 0; i < 5; ++i) {
    inputs[i] = sinew_default_input();
    inputs[i].root.row[2][3] = static_cast<float>(i);
    inputs[i].layers = &layer;
    inputs[i].layer_count = i % 2 == 0;
  }
  for (const std::uint32_t buffers : {2u, 3u}) {
    sinew_jobs_options options = sinew_default_jobs_options();
    options.own_thread = 0;
    options.frame_buffers = buffers;
    options.inline_below_bytes = 0;
    options.part_bytes = 1;
    Numbers read, expected;
    ASSERT_EQ(engine_run_tasks(&scene, &options, inputs, 5, scene.scene.skins.size(), &read), SINEW_OK);
    for (const sinew_frame_input& input : inputs)
      ASSERT_EQ(engine_play(&scene, nullptr, &input, nullptr, &expected), SINEW_OK);
    EXPECT_TRUE(same_bits<float>(read.all(), expected.all())) << buffers;
  }
}

}  // namespace
}  // namespace sinew::test
