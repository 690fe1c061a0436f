// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "runtime/model/scene.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Three joints, one skinned triangle with one morph target, one clip.
Scene good_scene() {
  Scene scene;
  scene.skeleton = test::chain_skeleton(3);
  scene.skins.push_back({"skin", {0, 2}, std::vector<Affine>(2), 0});
  Primitive p;
  p.positions.resize(3);
  p.normals.assign(3, {0, 1, 0});
  p.indices = {0, 1, 2};
  p.influences = {{{0, 2, 1, 0}, {2, 1, 2, 2}}, {0, 1, 0, 1}, {1, 1, 0.5f, 0.5f}};
  p.morphs.targets.resize(1);
  p.morphs.targets[0].positions = {{0, 2}, {{1, 0, 0}, {0, 1, 0}}};
  p.material = 0;
  scene.meshes.push_back({"mesh", {p}, {0.5f}, {}});
  scene.materials.emplace_back();
  scene.instances.push_back({1, 0, 0, {0.5f}});
  Animation animation;
  animation.bones.resize(1);
  animation.bones[0].translation = test::track_of<glm::vec3>(Interpolation::linear, {0, 1}, {{0, 0, 0}, {1, 0, 0}});
  animation.weights.push_back({0, {Interpolation::linear, {0, 1}, {0, 1}, 1}});
  scene.animations.push_back(animation);
  finish_scene(scene);
  return scene;
}

TEST(asset_checks, a_good_scene_and_an_empty_one_pass) {
  EXPECT_EQ(check(good_scene()), ErrorCode::ok);
  Scene header_only = good_scene();
  header_only.images.push_back({"", 2, 2, {}, ""});
  EXPECT_EQ(check(header_only), ErrorCode::ok);
  Scene empty;
  finish_scene(empty);
  EXPECT_EQ(check(empty), ErrorCode::ok);
}

TEST(asset_checks, every_broken_rule_is_found) {
  const struct {
    const char* what;
    std::function<void(Scene&)> damage;
    ErrorCode expected;
  } cases[] = {
      {"rest too short", [](Scene& s) { s.skeleton.rest.pop_back(); }, ErrorCode::size_mismatch},
      {"rest not finite", [](Scene& s) { s.skeleton.rest[1].scale.y = kNan; }, ErrorCode::not_finite},
      {"child before parent", [](Scene& s) { s.skeleton.parents[0] = 1; }, ErrorCode::parents_not_first},
      {"own parent", [](Scene& s) { s.skeleton.parents[1] = 1; }, ErrorCode::parents_not_first},
      {"levels out of order",
       [](Scene& s) {
         s.skeleton.level_begin = {0, 2, 3};
       },
       ErrorCode::parents_not_first},
      {"levels incomplete", [](Scene& s) { s.skeleton.level_begin.pop_back(); }, ErrorCode::size_mismatch},
      {"fixed matrix index", [](Scene& s) { s.skeleton.fixed_matrix_of[0] = 0; }, ErrorCode::index_out_of_range},
      {"skin joint index", [](Scene& s) { s.skins[0].joints[0] = 3; }, ErrorCode::index_out_of_range},
      {"inverse bind missing", [](Scene& s) { s.skins[0].inverse_bind.pop_back(); }, ErrorCode::size_mismatch},
      {"inverse bind not finite", [](Scene& s) { s.skins[0].inverse_bind[1].row[2].w = kNan; }, ErrorCode::not_finite},
      {"G36 vertex joint index", [](Scene& s) { s.meshes[0].primitives[0].influences.joints[1] = 2; },
       ErrorCode::index_out_of_range},
      {"group gap", [](Scene& s) { s.meshes[0].primitives[0].influences.groups[1].first_vertex = 1; },
       ErrorCode::size_mismatch},
      {"group beyond weights", [](Scene& s) { s.meshes[0].primitives[0].influences.groups[1].influence_count = 3; },
       ErrorCode::index_out_of_range},
      {"vertices not covered", [](Scene& s) { s.meshes[0].primitives[0].influences.groups.pop_back(); },
       ErrorCode::size_mismatch},
      {"G41 negative weight", [](Scene& s) { s.meshes[0].primitives[0].influences.weights[0] = -1; },
       ErrorCode::unsupported},
      {"vertex index", [](Scene& s) { s.meshes[0].primitives[0].indices[2] = 3; }, ErrorCode::index_out_of_range},
      {"half a triangle", [](Scene& s) { s.meshes[0].primitives[0].indices.pop_back(); }, ErrorCode::size_mismatch},
      {"normals too short", [](Scene& s) { s.meshes[0].primitives[0].normals.pop_back(); }, ErrorCode::size_mismatch},
      {"position not finite", [](Scene& s) { s.meshes[0].primitives[0].positions[1].x = kNan; }, ErrorCode::not_finite},
      {"centers too short", [](Scene& s) { s.meshes[0].primitives[0].centers_of_rotation.resize(1); },
       ErrorCode::size_mismatch},
      {"center not finite", [](Scene& s) { s.meshes[0].primitives[0].centers_of_rotation.assign(3, glm::vec3(kNan)); },
       ErrorCode::not_finite},
      {"material index", [](Scene& s) { s.meshes[0].primitives[0].material = 1; }, ErrorCode::index_out_of_range},
      {"target count", [](Scene& s) { s.meshes[0].primitives[0].morphs.targets.emplace_back(); },
       ErrorCode::size_mismatch},
      {"delta vertex", [](Scene& s) { s.meshes[0].primitives[0].morphs.targets[0].positions.vertices[1] = 3; },
       ErrorCode::index_out_of_range},
      {"delta order",
       [](Scene& s) {
         s.meshes[0].primitives[0].morphs.targets[0].positions.vertices = {2, 0};
       },
       ErrorCode::unsupported},
      {"delta missing", [](Scene& s) { s.meshes[0].primitives[0].morphs.targets[0].positions.deltas.pop_back(); },
       ErrorCode::size_mismatch},
      {"instance joint", [](Scene& s) { s.instances[0].joint = 3; }, ErrorCode::index_out_of_range},
      {"instance mesh", [](Scene& s) { s.instances[0].mesh = 1; }, ErrorCode::index_out_of_range},
      {"instance skin", [](Scene& s) { s.instances[0].skin = 1; }, ErrorCode::index_out_of_range},
      {"instance weights", [](Scene& s) { s.instances[0].rest_weights.clear(); }, ErrorCode::size_mismatch},
      {"weight not finite", [](Scene& s) { s.instances[0].rest_weights[0] = kNan; }, ErrorCode::not_finite},
      {"animated joint", [](Scene& s) { s.animations[0].bones[0].joint = 3; }, ErrorCode::index_out_of_range},
      {"decreasing times",
       [](Scene& s) {
         s.animations[0].bones[0].translation.times_s = {1, 0};
       },
       ErrorCode::times_not_increasing},
      {"animated instance", [](Scene& s) { s.animations[0].weights[0].instance = 1; }, ErrorCode::index_out_of_range},
      {"animated targets", [](Scene& s) { s.animations[0].weights[0].weights.target_count = 2; },
       ErrorCode::size_mismatch},
      {"clip missing", [](Scene& s) { s.clips.clear(); }, ErrorCode::size_mismatch},
      {"weight offsets", [](Scene& s) { s.first_weight.push_back(1); }, ErrorCode::size_mismatch},
      {"texture index", [](Scene& s) { s.materials[0].normal_texture.texture = 0; }, ErrorCode::index_out_of_range},
      {"image index",
       [](Scene& s) {
         s.textures.push_back({0, {}});
       },
       ErrorCode::index_out_of_range},
      {"half of the pixels",
       [](Scene& s) {
         s.images.push_back({"", 2, 2, std::vector<std::uint8_t>(8), ""});
       },
       ErrorCode::size_mismatch},
      {"camera joint", [](Scene& s) { s.cameras.emplace_back().joint = 3; }, ErrorCode::index_out_of_range},
      {"light joint", [](Scene& s) { s.lights.emplace_back().joint = 3; }, ErrorCode::index_out_of_range},
      {"scene root",
       [](Scene& s) {
         s.scenes.push_back({"", {3}});
       },
       ErrorCode::index_out_of_range},
      {"default scene", [](Scene& s) { s.default_scene = 0; }, ErrorCode::index_out_of_range},
  };
  for (const auto& c : cases) {
    Scene scene = good_scene();
    c.damage(scene);
    EXPECT_EQ(check(scene), c.expected) << c.what;
  }
}

TEST(finish_scene, G34_G43_weights_are_laid_out_per_instance_and_clips_follow_animations) {
  Scene scene = good_scene();
  scene.instances.push_back({0, 0, kNone, {0.25f}});
  finish_scene(scene);
  EXPECT_EQ(scene.first_weight, (std::vector<std::uint32_t>{0, 1, 2}));
  ASSERT_EQ(scene.clips.size(), 1u);
  EXPECT_EQ(scene.clips[0].weight_count(), 2u);
  EXPECT_EQ(check(scene), ErrorCode::ok);
}

}  // namespace
}  // namespace sinew
