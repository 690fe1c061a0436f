// SPDX-License-Identifier: MIT
// Plans that leave out joints, compared with plans of all joints.
#include "runtime/plan/needs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/animation/truth_pose.h"
#include "runtime/base/same_bits.h"
#include "runtime/lod/clip_bounds.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/run_plan.h"
#include "runtime/threads/job_thread.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

SkeletonLod some_detail(const Scene& scene, std::uint64_t seed) {
  FixedRandom random(seed + 77);
  SkeletonLod detail;
  for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j) {
    detail.kept.push_back(random.below(4) == 0);
    detail.held.push_back(random.transform(0.8, 1.25));
  }
  return detail;
}

std::vector<float> some_mask(const Scene& scene, std::uint64_t seed) {
  FixedRandom random(seed + 5);
  std::vector<float> mask;
  for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j)
    mask.push_back(static_cast<float>(random.in(0.0, 1.0)));
  return mask;
}

/// The scene in which the left-out joints have their held transforms as rest pose, and no tracks.
Scene held_scene(Scene scene, const PlanAssets& assets, const SkeletonLod& detail) {
  for (std::size_t j = 0; j < assets.joint_map.size(); ++j)
    if (!assets.joint_map[j].is_kept && scene.skeleton.fixed_matrix_of[j] == kNone)
      scene.skeleton.rest[j] = detail.held[j];
  for (Animation& animation : scene.animations)
    std::erase_if(animation.bones, [&](const BoneAnimation& bone) { return !assets.joint_map[bone.joint].is_kept; });
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

double largest_distance(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, static_cast<double>(glm::length(a[i] - b[i])));
  return largest;
}

Needs rich_needs(const Scene& scene, std::uint64_t seed) {
  Needs needs;
  needs.in.max_layers = 3;
  needs.in.additive = true;
  needs.out.bounds = true;
  needs.in.masks = {some_mask(scene, seed)};
  return needs;
}

const std::vector<ClipLayer> kPlayed[] = {{{0, 0.7}},
                                          {{0, 0.3, 0.5f}, {1, 1.1, 0.25f}},
                                          {{1, 0.4, 1.0f, 0}, {0, 1.3, 0.6f, kNone, LayerKind::add_to_start}},
                                          {}};

TEST(skeleton_lod, N27_joints_that_are_kept_have_the_bits_of_the_full_plan) {
  for (std::uint32_t seed = 0; seed < 16; ++seed) {
    RandomSceneOptions options;
    options.joints = 12 + 5 * seed;
    options.correctives = seed % 3;
    const Scene scene = random_scene(seed, options);
    Needs needs = rich_needs(scene, seed);
    const Plan full = compile_plan(lend(scene), needs);
    needs.out.skeleton_lod = some_detail(scene, seed);
    const Plan lean = compile_plan(lend(scene), needs);
    const PlanAssets& kept = lean.compiled()->assets;
    ASSERT_TRUE(kept.leaves_out() && !full.compiled()->assets.leaves_out());
    FrameBuffer all(full), some(lean);
    for (const auto& layers : kPlayed) {
      ASSERT_EQ(run_plan(full, {.layers = layers, .weights = {}, .root = {}}, all), ErrorCode::ok);
      ASSERT_EQ(run_plan(lean, {.layers = layers, .weights = {}, .root = {}}, some), ErrorCode::ok);
      ASSERT_EQ(some.result().model.size(), kept.joint_count());
      for (std::uint32_t j = 0; j < kept.joint_map.size(); ++j) {
        const JointMapping& mapped = kept.joint_map[j];
        ASSERT_TRUE(!mapped.is_kept || same_bits(some.result().model[mapped.pose_index], all.result().model[j]))
            << "seed " << seed << " joint " << j;
      }
      EXPECT_TRUE(same_bits<float>(some.result().weights, all.result().weights))
          << "correctives see the joints that drive them";
    }
  }
}

TEST(skeleton_lod, joints_left_out_and_their_vertices_stand_as_if_nothing_ever_moved_them) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    RandomSceneOptions options;
    options.centers = true;
    options.mirrored_joints = seed % 2;
    const Scene scene = random_scene(seed, options);
    for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::center_of_rotation}) {
      Needs needs;
      needs.skin.kind = skinning;
      needs.out.bounds = true;
      needs.out.skeleton_lod = some_detail(scene, seed);
      const Plan lean = compile_plan(lend(scene), needs);
      const Scene held = held_scene(random_scene(seed, options), lean.compiled()->assets, needs.out.skeleton_lod);
      needs.out.skeleton_lod = {};
      const Plan full = compile_plan(lend(held), needs);
      FrameBuffer expected(full), found(lean);
      const ClipLayer layer{0, 0.1 * seed};
      ASSERT_EQ(run_plan(full, {.layers = {&layer, 1}, .weights = {}, .root = {}}, expected), ErrorCode::ok);
      ASSERT_EQ(run_plan(lean, {.layers = {&layer, 1}, .weights = {}, .root = {}}, found), ErrorCode::ok);
      for (std::uint32_t j = 0; j < scene.skeleton.joint_count(); ++j) {
        const Affine world = world_of(lean, found.result().model, j), truth = expected.result().model[j];
        for (int r = 0; r < 3; ++r)
          EXPECT_LT(glm::length(world.row[r] - truth.row[r]), 1e-5f * (1.0f + glm::length(truth.row[r]))) << j;
      }
      for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const InstanceResult &a = found.result().instances[i], &b = expected.result().instances[i];
        EXPECT_EQ(a.mirrored, b.mirrored);
        EXPECT_LT(glm::length(a.bounds.upper - b.bounds.upper) + glm::length(a.bounds.lower - b.bounds.lower), 2e-4f);
      }
      for (std::size_t p = 0; p < lean.primitives().size(); ++p) {
        const DeformedPrimitive &a = found.result().primitives[p], &b = expected.result().primitives[p];
        EXPECT_LT(largest_distance(a.positions, b.positions), 1e-4) << "seed " << seed;
        EXPECT_LT(largest_distance(a.normals, b.normals), 2e-3) << "seed " << seed;
      }
    }
  }
}

/// Adds joints below an existing one; the clip moves all of them.
void add_moved_joints(Scene& scene, std::uint32_t parent, std::uint32_t count) {
  const auto first = static_cast<std::uint32_t>(scene.skeleton.joint_count());
  for (std::uint32_t i = 0; i < count; ++i) {
    Skeleton& s = scene.skeleton;
    s.parents.push_back(i % 2 == 0 ? parent : first + i - 1);
    s.rest.push_back({glm::vec3(0.01f * static_cast<float>(i)), quat_identity<float>(), glm::vec3(1)});
    s.fixed_matrix_of.push_back(kNone);
    s.names.push_back("more");
    s.node_of_joint.push_back(first + i);
    s.joint_of_node.push_back(first + i);
    BoneAnimation bone;
    bone.joint = first + i;
    bone.translation = {Interpolation::linear, {0.0f, 1.0f}, {glm::vec3(0), glm::vec3(1)}};
    for (Animation& animation : scene.animations) animation.bones.push_back(bone);
  }
  scene.skeleton.level_begin.clear();  // clears the levels: plans do not need them, and they are no longer in order
  scene.clips.clear();
  finish_scene(scene);
}

SkeletonLod without(const Scene& scene, std::uint32_t first) {
  SkeletonLod detail;
  for (std::uint32_t j = 0; j < scene.skeleton.joint_count(); ++j) detail.kept.push_back(j < first);
  return detail;
}

TEST(skeleton_lod, P01_joints_left_out_cost_exactly_nothing) {
  const Scene scene = random_scene(8);
  const auto joints = static_cast<std::uint32_t>(scene.skeleton.joint_count());
  Needs needs = rich_needs(scene, 1);
  const Plan plain = compile_plan(lend(scene), needs);
  FrameBuffer frame(plain);
  for (const std::uint32_t count : {1u, 40u, 1000u}) {
    Scene more = random_scene(8);
    add_moved_joints(more, joints - 1, count);
    needs.in.masks = {some_mask(more, 1)};
    needs.out.skeleton_lod = {};
    const Plan full = compile_plan(lend(more), needs);
    needs.out.skeleton_lod = without(more, joints);
    const Plan lean = compile_plan(lend(more), needs);
    EXPECT_GT(full.frame_bytes(), lean.frame_bytes());
    EXPECT_EQ(plain.frame_bytes(), lean.frame_bytes());
    FrameBuffer with(full), same(lean);
    for (const auto& layers : kPlayed) {
      ASSERT_EQ(run_plan(plain, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      ASSERT_EQ(run_plan(lean, {.layers = layers, .weights = {}, .root = {}}, same), ErrorCode::ok);
      ASSERT_EQ(run_plan(full, {.layers = layers, .weights = {}, .root = {}}, with), ErrorCode::ok);
      EXPECT_EQ(same.result().work, frame.result().work);
      EXPECT_EQ(with.result().work.joints_composed, frame.result().work.joints_composed + count);
      EXPECT_TRUE(same_bits<Affine>(same.result().model, frame.result().model));
      for (std::size_t p = 0; p < plain.primitives().size(); ++p)
        EXPECT_TRUE(
            same_bits<glm::vec3>(same.result().primitives[p].positions, frame.result().primitives[p].positions));
    }
  }
}

TEST(skeleton_lod, roots_joints_above_others_and_joints_that_drive_correctives_stay) {
  RandomSceneOptions options;
  options.correctives = 2;
  const Scene scene = random_scene(2, options);
  Needs needs;
  needs.out.skeleton_lod.kept.assign(scene.skeleton.joint_count(), false);
  const std::vector<JointMapping> map = map_joints(scene, needs.out.skeleton_lod);
  for (std::uint32_t j = 0; j < scene.skeleton.joint_count(); ++j) {
    const std::uint32_t parent = scene.skeleton.parents[j];
    EXPECT_TRUE(parent != kNone || map[j].is_kept);
    EXPECT_TRUE(parent == kNone || !map[j].is_kept || map[parent].is_kept);
  }
  for (const PoseCorrective& corrective : scene.correctives)
    for (const PoseDriver& driver : corrective.samples.drivers) EXPECT_TRUE(map[driver.joint].is_kept);
}

TEST(skeleton_lod, a_plan_that_leaves_nothing_out_copies_nothing) {
  const Scene scene = random_scene(2);
  Needs needs;
  needs.out.skeleton_lod.kept.assign(scene.skeleton.joint_count(), true);
  for (const Plan& plan : {compile_plan(lend(scene), {}), compile_plan(lend(scene), needs)}) {
    const PlanAssets& assets = plan.compiled()->assets;
    EXPECT_EQ(assets.skeleton, &scene.skeleton);
    EXPECT_EQ(&assets.clips[1].layout(), &scene.clips[1].layout());
    EXPECT_EQ(assets.skins[0], &scene.skins[0]);
    EXPECT_EQ(assets.copies, nullptr);
  }
}

TEST(skeleton_lod, a_character_changes_detail_in_one_block_of_memory_without_allocating) {
  const Scene scene = random_scene(6);
  Needs needs;
  const Plan full = compile_plan(lend(scene), needs);
  needs.out.skeleton_lod = some_detail(scene, 6);
  const Plan lean = compile_plan(lend(scene), needs);
  ASSERT_LT(lean.frame_bytes(), full.frame_bytes());
  alignas(64) static std::byte block[1 << 20];
  ASSERT_LE(full.frame_bytes(), sizeof block);
  FrameBuffer fresh(full), lean_fresh(lean);
  const ClipLayer layer{1, 0.8};
  const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
  ASSERT_EQ(run_plan(full, input, fresh), ErrorCode::ok);
  ASSERT_EQ(run_plan(lean, input, lean_fresh), ErrorCode::ok);
  const AllocationCounter counter;
  FrameBuffer frame(full, std::span<std::byte>(block));
  for (const bool is_lean : {false, true, false, true}) {
    const Plan& plan = is_lean ? lean : full;
    const std::uint64_t last = frame.result().frame;
    frame = FrameBuffer(plan, std::span<std::byte>(block));
    frame.count_from(last);
    EXPECT_EQ(run_plan(is_lean ? full : lean, input, frame), ErrorCode::wrong_plan);
    ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
    EXPECT_EQ(frame.result().frame, last + 1);
    EXPECT_TRUE(same_bits<Affine>(frame.result().model, (is_lean ? lean_fresh : fresh).result().model));
  }
  EXPECT_EQ(counter.count(), 0u);
}

TEST(skeleton_lod, on_a_job_thread_levels_are_characters_of_which_one_is_awake) {
  const Scene scene = random_scene(6);
  Needs needs;
  const Plan full = compile_plan(lend(scene), needs);
  needs.out.skeleton_lod = some_detail(scene, 6);
  const Plan lean = compile_plan(lend(scene), needs);
  const Plan* levels[] = {&full, &lean};
  JobThread jobs;
  for (const Plan* level : levels) jobs.add_character(*level);
  for (int number = 0; number < 12; ++number) {
    const std::uint32_t awake = number / 3 % 2;
    const ClipLayer layer{0, 0.05 * number};
    FrameInput inputs[2];
    inputs[awake].layers = {&layer, 1};
    inputs[1 - awake].asleep = true;
    jobs.wait(*jobs.submit(inputs));
    FrameBuffer alone(*levels[awake]);
    ASSERT_EQ(run_plan(*levels[awake], inputs[awake], alone), ErrorCode::ok);
    EXPECT_TRUE(same_bits<Affine>(jobs.latest(awake)->model, alone.result().model));
    EXPECT_EQ(jobs.latest(1 - awake)->work, WorkCounters{});
  }
}

TEST(skeleton_lod, frame_buffers_of_another_detail_are_refused) {
  const Scene scene = random_scene(6);
  Needs needs;
  needs.out.skeleton_lod = some_detail(scene, 6);
  const Plan lean = compile_plan(lend(scene), needs);
  needs.out.skeleton_lod.held[3].translation.x += 1.0f;
  const Plan other = compile_plan(lend(scene), needs);
  FrameBuffer frame(lean);
  EXPECT_EQ(run_plan(other, {}, frame), ErrorCode::wrong_plan);
}

TEST(skeleton_lod, G54_boxes_of_clips_hold_characters_that_leave_joints_out) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    RandomSceneOptions options;
    options.targets = seed % 2 * 3;
    const Scene scene = random_scene(seed, options);
    Needs needs;
    needs.out.bounds = true;
    needs.out.skeleton_lod = some_detail(scene, seed);
    const std::vector<Aabb> reach = clip_bounds(scene, needs, 0);
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    for (int n = 0; n <= 100; ++n) {
      const ClipLayer layer{0, 0.021 * n};
      ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      for (std::size_t i = 0; i < reach.size(); ++i) {
        const Aabb& box = frame.result().instances[i].bounds;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(reach[i].lower, box.lower)) &&
                    glm::all(glm::greaterThanEqual(reach[i].upper, box.upper)))
            << seed;
      }
    }
  }
}

TEST(skeleton_lod, the_plan_says_what_is_left_out) {
  const Scene scene = arm_scene();
  Needs needs;
  needs.out.skeleton_lod.kept = {true, true, false};
  const Plan plan = compile_plan(lend(scene), needs);
  const std::vector<PlanStage> stages = plan.stages();
  const auto stage =
      std::find_if(stages.begin(), stages.end(), [](const PlanStage& s) { return s.stage == "local_to_model"; });
  EXPECT_EQ(stage->count, 2u);
  EXPECT_NE(stage->reason.find("1 of 3 joints are left out as asked, they follow the joints above"), std::string::npos)
      << stage->reason;
}

TEST(skeleton_lod, G48_a_mesh_on_a_joint_that_is_left_out_keeps_its_winding) {
  for (const bool mirrored : {false, true}) {
    Scene scene;
    scene.skeleton = skeleton_of({kNone, 0});
    if (mirrored) scene.skeleton.rest[1].scale = {1, -1, 1};
    Mesh& mesh = scene.meshes.emplace_back();
    Primitive& primitive = mesh.primitives.emplace_back();
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    primitive.indices = {0, 1, 2};
    scene.instances.push_back({.joint = 1, .mesh = 0});
    finish_scene(scene);
    Needs needs;
    needs.out.skeleton_lod.kept = {true, false};
    needs.out.skeleton_lod.held = scene.skeleton.rest;
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
    EXPECT_EQ(frame.result().instances[0].mirrored, mirrored);
    EXPECT_EQ(frame.result().work.windings_tested, 0u) << "nothing can change it";
  }
}

}  // namespace
}  // namespace sinew::test
