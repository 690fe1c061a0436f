// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include "runtime/model/scene.h"

namespace sinew::viewer {

/// One joint that moves 10 m along x in 2 s, and back to 4 m in the third second; optionally with a triangle of 1 m on
/// it.
inline Scene flyer(bool with_mesh) {
  Scene scene;
  auto& skeleton = scene.skeleton;
  skeleton.parents = {kNone};
  skeleton.rest.resize(1);
  skeleton.rest[0].translation = {0, 3, 0};
  skeleton.fixed_matrix_of = {kNone};
  skeleton.names = {"flyer"};
  skeleton.node_of_joint = skeleton.joint_of_node = {0};
  skeleton.level_begin = {0, 1};
  auto& animation = scene.animations.emplace_back();
  animation.duration_s = 3.0;
  auto& bone = animation.bones.emplace_back();
  bone.translation.times_s = {0.0f, 2.0f, 3.0f};
  bone.translation.values = {{0, 0, 0}, {10, 0, 0}, {4, 0, 0}};
  if (with_mesh) {
    auto& primitive = scene.meshes.emplace_back().primitives.emplace_back();
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    primitive.normals.assign(3, {0, 0, 1});
    primitive.indices = {0, 1, 2};
    for (const auto& p : primitive.positions) primitive.bounds.add(p);
    scene.instances.emplace_back();
  }
  finish_scene(scene);
  EXPECT_EQ(check(scene), ErrorCode::ok);
  return scene;
}

}  // namespace sinew::viewer
