// SPDX-License-Identifier: MIT
// Parts of a scene that a frame does not need change neither its work nor its bits nor its memory.
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

/// A joint of the last level but one that no clip moves; kNone if clips move all of them.
std::uint32_t unmoved_parent(const Scene& scene) {
  const std::vector<std::uint32_t>& begin = scene.skeleton.level_begin;
  const Plan plan = compile_plan(lend(scene), {});
  const std::span<const std::uint32_t> moved = plan.moved_joints();
  for (std::uint32_t j = begin[begin.size() - 3]; j < begin[begin.size() - 2]; ++j)
    if (!std::binary_search(moved.begin(), moved.end(), j)) return j;
  return kNone;
}

/// Adds nodes that no clip moves, at the end of the deepest level.
void add_static_nodes(Scene& scene, std::uint32_t parent, std::uint32_t count) {
  Skeleton& skeleton = scene.skeleton;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto joint = static_cast<std::uint32_t>(skeleton.joint_count());
    skeleton.parents.push_back(parent);
    skeleton.rest.push_back({{0.5f, static_cast<float>(i), 0.25f}, glm::quat(1, 0, 0, 0), glm::vec3(1)});
    skeleton.fixed_matrix_of.push_back(kNone);
    skeleton.names.emplace_back("static");
    skeleton.node_of_joint.push_back(joint);
    skeleton.joint_of_node.push_back(joint);
  }
  skeleton.level_begin.back() += count;
  scene.clips.clear();
  finish_scene(scene);
}

/// A random scene in which only every third joint has tracks; the root has none.
Scene sparsely_moved_scene(std::uint32_t seed) {
  Scene scene = random_scene(seed);
  for (Animation& animation : scene.animations)
    std::erase_if(animation.bones, [](const BoneAnimation& bone) { return bone.joint % 3 != 2; });
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

/// Adds morph targets with weight zero to the first primitive.
void add_targets(Scene& scene, std::uint32_t count) {
  Primitive& primitive = scene.meshes[0].primitives[0];
  MorphTarget target;
  target.positions = {{0, 1}, {{0, 0, 1}, {0, 0, 2}}};
  target.normals = {{1}, {{0, 1, 0}}};
  primitive.morphs.targets.insert(primitive.morphs.targets.end(), count, target);
  scene.meshes[0].default_weights.resize(primitive.morphs.targets.size(), 0.0f);
  for (MeshInstance& instance : scene.instances)
    if (instance.mesh == 0) instance.rest_weights.resize(primitive.morphs.targets.size(), 0.0f);
  scene.clips.clear();
  finish_scene(scene);
}

/// A face whose weights stay at their rest values, one of which is not zero.
Scene resting_face() {
  Scene scene = face_scene();
  scene.animations.clear();
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

/// Work of all frames of a clip but the first.
WorkCounters work_of_frames(const Scene& scene, FrameBuffer& frame, const Plan& plan) {
  EXPECT_EQ(check(scene), ErrorCode::ok);
  WorkCounters work;
  for (int number = 0; number < 4; ++number) {
    const ClipLayer layer{0, 0.1 + 0.2 * number};
    EXPECT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    if (number > 1) {
      EXPECT_EQ(frame.result().work, work);
    }
    work = frame.result().work;
  }
  return work;
}

TEST(added_effects, P01_nodes_that_no_clip_moves_add_no_work_to_frames) {
  std::size_t scenes = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const auto make = [&] { return seed == 0 ? arm_scene() : sparsely_moved_scene(seed); };
    const Scene scene = make();
    const std::uint32_t parent = unmoved_parent(scene);
    if (parent == kNone) continue;
    ++scenes;
    const Plan plan = compile_plan(lend(scene), {});
    FrameBuffer frame(plan);
    const WorkCounters work = work_of_frames(scene, frame, plan);
    ASSERT_GT(work.joints_composed, 0u);
    if (seed == 0) {
      EXPECT_EQ(work.joints_composed, 1u) << "only \"lower\" moves";
    }
    for (const std::uint32_t count : {1u, 50u, 1000u}) {
      Scene more = make();
      add_static_nodes(more, parent, count);
      const Plan other = compile_plan(lend(more), {});
      FrameBuffer same(other);
      EXPECT_EQ(work_of_frames(more, same, other), work) << count << " static nodes";
      EXPECT_TRUE(same_bits<Affine>(same.result().model.first(frame.result().model.size()), frame.result().model));
      for (std::size_t p = 0; p < plan.primitives().size(); ++p)
        EXPECT_TRUE(
            same_bits<glm::vec3>(same.result().primitives[p].positions, frame.result().primitives[p].positions));
    }
  }
  EXPECT_GT(scenes, 4u);
}

TEST(added_effects, P10_targets_of_weight_zero_add_no_work_to_frames) {
  const Scene resting = resting_face();
  Scene many = resting_face();
  add_targets(many, 500);
  const Plan few_plan = compile_plan(lend(resting), {}), many_plan = compile_plan(lend(many), {});
  FrameBuffer few_frame(few_plan), many_frame(many_plan);
  ASSERT_EQ(run_plan(few_plan, {}, few_frame), ErrorCode::ok);
  ASSERT_EQ(run_plan(many_plan, {}, many_frame), ErrorCode::ok);
  ASSERT_GT(few_frame.result().work.morph_deltas, 0u);
  EXPECT_EQ(few_frame.result().work, many_frame.result().work);
  const DeformedPrimitive &a = few_frame.result().primitives[0], &b = many_frame.result().primitives[0];
  EXPECT_TRUE(same_bits<glm::vec3>(a.positions, b.positions) && same_bits<glm::vec3>(a.normals, b.normals));
}

TEST(added_effects, take_no_memory_of_frames_while_nothing_calls_for_them) {
  const Scene scene = arm_scene();
  Scene more = arm_scene();
  const Scene face = face_scene();
  for (int i = 0; i < 100; ++i) {
    more.animations.push_back(scene.animations[0]);
    more.meshes.push_back(face.meshes[0]);
    more.materials.emplace_back();
    more.lights.emplace_back();
    more.cameras.emplace_back();
    more.variants.emplace_back("variant");
  }
  more.clips.clear();
  finish_scene(more);
  EXPECT_EQ(compile_plan(lend(more), {}).frame_bytes(), compile_plan(lend(scene), {}).frame_bytes());

  const std::size_t vertices = scene.meshes[0].primitives[0].vertex_count(), least = 64;
  const auto bytes = [&](void (*change)(Needs&)) {
    Needs needs;
    needs.in.max_layers = 1;
    change(needs);
    return compile_plan(lend(scene), needs).frame_bytes();
  };
  const std::size_t all = bytes([](Needs&) {});
  EXPECT_LE(bytes([](Needs& n) { n.out.normals = false; }) + vertices * sizeof(glm::vec3), all);
  EXPECT_EQ(bytes([](Needs& n) { n.out.tangents = false; }), all) << "the arm has none";
  EXPECT_EQ(bytes([](Needs& n) { n.out.properties = false; }), all) << "no clip moves any";
  EXPECT_EQ(bytes([](Needs& n) { n.out.bounds = true; }), all) << "boxes lie in the results";
  EXPECT_GE(bytes([](Needs& n) { n.in.additive = true; }), all + least);
  EXPECT_GE(bytes([](Needs& n) { n.in.max_layers = 2; }), all + least);
  EXPECT_GE(bytes([](Needs& n) { n.out.stage_times = true; }), all + least);
  EXPECT_GE(bytes([](Needs& n) { n.skin.kind = Skinning::dual_quaternion; }), all + least);
  EXPECT_LT(bytes([](Needs& n) { n.out.positions = n.out.normals = n.out.tangents = n.out.joints = false; }), all);
}

}  // namespace
}  // namespace sinew::test
