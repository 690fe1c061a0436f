// SPDX-License-Identifier: MIT
// The last index of each list is valid, and the index after it is refused.
#include <gtest/gtest.h>

#include <vector>

#include "runtime/sinew.h"
#include "tests/c/c_frame.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

/// Two joints with names, two clips, two skins, two meshes of two primitives each.
Scene scene_of_two() {
  Scene scene = arm_scene();
  scene.meshes[0].primitives.push_back(scene.meshes[0].primitives[0]);
  for (Primitive& primitive : scene.meshes[0].primitives)
    primitive.texcoords = {{4, {0.5f, 0.25f}}, {4, {0.25f, 0.5f}}};
  scene.meshes.push_back(scene.meshes[0]);
  scene.skins.push_back(scene.skins[0]);
  scene.instances.push_back({.joint = 1, .mesh = 1, .skin = 1, .rest_weights = {}});
  scene.animations.push_back(scene.animations[0]);
  scene.animations[1].name = "again";
  finish_scene(scene);
  EXPECT_EQ(check(scene), ErrorCode::ok);
  return scene;
}

sinew_needs needs_with_palettes() {
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_PALETTES;
  return needs;
}

class CLastIndex : public CFrame {
 protected:
  CLastIndex() : CLastIndex(needs_with_palettes()) {}
  explicit CLastIndex(const sinew_needs& needs) : CFrame(scene_of_two(), &needs) {}
};

TEST_F(CLastIndex, of_lists_of_a_scene) {
  EXPECT_EQ(sinew_joint_name(&scene_, 2).length, 5u);
  EXPECT_EQ(sinew_joint_name(&scene_, 3).length, 0u);
  EXPECT_EQ(sinew_joint_parent(&scene_, 2), 0u);
  EXPECT_EQ(sinew_joint_parent(&scene_, 3), SINEW_NONE);
  EXPECT_EQ(sinew_clip_name(&scene_, 1).length, 5u);
  EXPECT_EQ(sinew_clip_name(&scene_, 2).length, 0u);
  EXPECT_EQ(sinew_clip_duration_s(&scene_, 1), 1.0);
  EXPECT_EQ(sinew_clip_duration_s(&scene_, 2), 0.0);
  EXPECT_EQ(sinew_skin_joints(&scene_, 1).count, 2u);
  EXPECT_EQ(sinew_skin_joints(&scene_, 2).count, 0u);
  EXPECT_EQ(sinew_mesh_name(&scene_, 1).length, 3u);
  EXPECT_EQ(sinew_mesh_name(&scene_, 2).length, 0u);
  EXPECT_EQ(sinew_primitive_count(&scene_, 1), 2u);
  EXPECT_EQ(sinew_primitive_count(&scene_, 2), 0u);
  EXPECT_EQ(sinew_primitive_texcoords(&scene_, 1, 1, 1).count, 4u);
  EXPECT_EQ(sinew_primitive_texcoords(&scene_, 1, 1, 2).count, 0u);
  EXPECT_EQ(sinew_primitive_texcoords(&scene_, 1, 2, 1).count, 0u);
  EXPECT_EQ(sinew_primitive_texcoords(&scene_, 2, 1, 1).count, 0u);
  EXPECT_EQ(sinew_vertex_influences(&scene_, 1, 1, 3).count, 2u);
  EXPECT_EQ(sinew_vertex_influences(&scene_, 1, 1, 4).count, 0u);
  EXPECT_EQ(sinew_vertex_influences(&scene_, 1, 2, 3).count, 0u);
  EXPECT_EQ(sinew_vertex_influences(&scene_, 2, 1, 3).count, 0u);
  sinew_instance instance{.struct_size = sizeof(instance)};
  EXPECT_EQ(sinew_get_instance(&scene_, 1, &instance), SINEW_OK);
  EXPECT_EQ(sinew_get_instance(&scene_, 2, &instance), SINEW_INDEX_OUT_OF_RANGE);
  sinew_primitive primitive{.struct_size = sizeof(primitive)};
  EXPECT_EQ(sinew_get_primitive(&scene_, 1, 1, &primitive), SINEW_OK);
  EXPECT_EQ(sinew_get_primitive(&scene_, 1, 2, &primitive), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_get_primitive(&scene_, 2, 1, &primitive), SINEW_INDEX_OUT_OF_RANGE);
}

TEST_F(CLastIndex, of_morph_targets) {
  const sinew_scene face{face_scene()};
  EXPECT_EQ(sinew_target_count(&face, 0), 2u);
  EXPECT_EQ(sinew_target_count(&face, 1), 0u);
  EXPECT_EQ(sinew_target_name(&face, 0, 1).length, 6u);
  EXPECT_EQ(sinew_target_name(&face, 0, 2).length, 0u);
  EXPECT_EQ(sinew_target_name(&face, 1, 1).length, 0u);
}

TEST_F(CLastIndex, of_results_and_stages) {
  const auto stages = static_cast<std::uint32_t>(sinew_stage_count(plan_));
  sinew_stage stage{.struct_size = sizeof(stage)};
  EXPECT_EQ(sinew_get_stage(plan_, stages - 1, &stage), SINEW_OK);
  EXPECT_EQ(sinew_get_stage(plan_, stages, &stage), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_get_palette(result_, 1).count, 2u);
  EXPECT_EQ(sinew_get_palette(result_, 2).count, 0u);
  sinew_instance_result instance{.struct_size = sizeof(instance)};
  EXPECT_EQ(sinew_get_instance_result(result_, 1, &instance), SINEW_OK);
  EXPECT_EQ(sinew_get_instance_result(result_, 2, &instance), SINEW_INDEX_OUT_OF_RANGE);
  sinew_shape shape{.struct_size = sizeof(shape)};
  EXPECT_EQ(sinew_get_shape(result_, 3, &shape), SINEW_OK);
  EXPECT_EQ(sinew_get_shape(result_, 4, &shape), SINEW_INDEX_OUT_OF_RANGE);
  const sinew_vertex_buffer nowhere{.struct_size = sizeof(nowhere)};
  EXPECT_EQ(sinew_write_shape(result_, 3, &nowhere), SINEW_OK);
  EXPECT_EQ(sinew_write_shape(result_, 4, &nowhere), SINEW_INDEX_OUT_OF_RANGE);
  sinew_affine matrix;
  EXPECT_EQ(sinew_world_of(plan_, result_, 2, nullptr, &matrix), SINEW_OK);
  EXPECT_EQ(sinew_world_of(plan_, result_, 3, nullptr, &matrix), SINEW_INDEX_OUT_OF_RANGE);
}

TEST_F(CLastIndex, of_clips_and_joints_that_calls_name) {
  sinew_clip_block* block = nullptr;
  EXPECT_EQ(sinew_clips_save(&scene_, 1, 2, &block), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_clips_save(&scene_, 2, 1, &block), SINEW_INDEX_OUT_OF_RANGE);
  ASSERT_EQ(sinew_clips_save(&scene_, 1, 1, &block), SINEW_OK);
  sinew_clip_block_destroy(block);
  sinew_box boxes[2];
  std::size_t count = 0;
  EXPECT_EQ(sinew_clip_bounds(&scene_, nullptr, 1, boxes, 2, &count), SINEW_OK);
  EXPECT_EQ(count, 2u);
  EXPECT_EQ(sinew_clip_bounds(&scene_, nullptr, 2, boxes, 2, &count), SINEW_INDEX_OUT_OF_RANGE);
  sinew_skeleton_lod* lod = nullptr;
  const std::uint32_t behind = 2, last = 1;
  EXPECT_EQ(sinew_skeleton_lod_create(&scene_, 0.1, &behind, 1, nullptr, &lod), SINEW_INDEX_OUT_OF_RANGE);
  ASSERT_EQ(sinew_skeleton_lod_create(&scene_, 0.1, &last, 1, nullptr, &lod), SINEW_OK);
  sinew_skeleton_lod_destroy(lod);
  sinew_dual_quat motion;
  EXPECT_EQ(sinew_root_place(&scene_, 1, 2, nullptr, 0.5, &motion), SINEW_OK);
  EXPECT_EQ(sinew_root_place(&scene_, 2, 2, nullptr, 0.5, &motion), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_root_place(&scene_, 1, 3, nullptr, 0.5, &motion), SINEW_INDEX_OUT_OF_RANGE);
  sinew_library* library = nullptr;
  ASSERT_EQ(sinew_library_create(&scene_, &library), SINEW_OK);
  ASSERT_EQ(sinew_library_add(library, &scene_, SINEW_REFUSE, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_library_clip_count(library), 2u);
  EXPECT_EQ(sinew_library_clip_name(library, 1).length, 5u);
  EXPECT_EQ(sinew_library_clip_name(library, 2).length, 0u);
  EXPECT_EQ(sinew_library_clip_duration_s(library, 1), 1.0);
  EXPECT_EQ(sinew_library_clip_duration_s(library, 2), 0.0);
  sinew_library_destroy(library);
}

TEST_F(CLastIndex, of_joints_of_poses) {
  alignas(SINEW_POSE_ALIGNMENT) static float planes[1024];
  ASSERT_LE(sinew_pose_floats(3), 1024u);
  const sinew_pose pose{planes, 3};
  sinew_transform transform;
  EXPECT_EQ(sinew_pose_sample(&scene_, 1, 0.5, &pose), SINEW_OK);
  EXPECT_EQ(sinew_pose_sample(&scene_, 2, 0.5, &pose), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_pose_get(&pose, 2, &transform), SINEW_OK);
  EXPECT_EQ(sinew_pose_get(&pose, 3, &transform), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_pose_set(&pose, 2, &transform), SINEW_OK);
  EXPECT_EQ(sinew_pose_set(&pose, 3, &transform), SINEW_INDEX_OUT_OF_RANGE);
}

}  // namespace
}  // namespace sinew::test
