// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "runtime/model/scene.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

glm::quat about_x(float half_angle_rad) { return {std::cos(half_angle_rad), std::sin(half_angle_rad), 0.0f, 0.0f}; }

/// A valid scene: three joints, a skinned triangle with a morph target, a corrective, and a mesh that is shown twice.
/// One clip moves joints, with a rotation track of each interpolation, and a material.
Scene good_scene() {
  Scene scene;
  scene.skeleton = test::chain_skeleton(3);
  scene.skeleton.fixed_matrices.emplace_back();
  scene.skins.push_back({"skin", {0, 2}, std::vector<Affine>(2), 0});
  Primitive p;
  p.positions.resize(3);
  p.normals.assign(3, {0, 1, 0});
  p.indices = {0, 1, 2};
  p.influences = {{{0, 2, 1, 0}, {2, 1, 2, 2}}, {0, 1, 0, 1}, {1, 1, 0.5f, 0.5f}};
  p.morphs.targets.resize(1);
  p.morphs.targets[0].positions = {{0, 2}, {{1, 0, 0}, {0, 1, 0}}};
  p.material = 0;
  p.variant_materials = {{0, 0}, {1, 0}};
  scene.variants = {"worn", "new"};
  scene.meshes.push_back({"mesh", {p}, {0.5f}, {}});
  scene.meshes.push_back({"mesh of copies", {}, {}, {}});
  scene.materials.emplace_back();
  scene.instances.push_back({1, 0, 0, {0.5f}});
  scene.instances.push_back({0, 1, kNone, {}, std::vector<Transform>(2)});
  PoseSamples samples;
  samples.drivers.push_back({1});
  samples.rotations = {about_x(0.0f), about_x(0.5f)};
  samples.weights = {0};
  samples.values = {0, 1};
  scene.correctives.push_back(solve_corrective(samples).value());
  Animation animation;
  animation.bones.resize(3);
  animation.bones[0].translation = test::track_of<glm::vec3>(Interpolation::linear, {0, 1}, {{0, 0, 0}, {1, 0, 0}});
  for (std::uint32_t j = 0; j < 3; ++j) animation.bones[j].joint = j;
  animation.bones[0].rotation =
      test::track_of<glm::quat>(Interpolation::linear, {0, 1}, {about_x(0.0f), about_x(0.5f)});
  animation.bones[1].rotation = test::track_of<glm::quat>(Interpolation::squad, {0, 1}, {about_x(0.0f), about_x(0.5f)});
  const glm::quat still(0, 0, 0, 0);
  animation.bones[2].rotation = test::track_of<glm::quat>(
      Interpolation::cubic_spline, {0, 1}, {still, about_x(0.0f), still, still, about_x(0.5f) * 2.0f, still});
  animation.weights.push_back({0, {Interpolation::linear, {0, 1}, {0, 1}, 1}});
  for (const PropertyKind kind : {PropertyKind::base_color, PropertyKind::texture_offset})
    animation.properties.push_back(
        {{kind, 0},
         {Interpolation::step, {0}, std::vector<float>(component_count(kind), 0.5f), component_count(kind)}});
  scene.animations.push_back(animation);
  finish_scene(scene);
  return scene;
}

Primitive& triangle(Scene& scene) { return scene.meshes[0].primitives[0]; }

/// Gives each vertex of the triangle three influences, in one group.
void use_three_influences(Scene& scene, std::initializer_list<float> weights) {
  scene.skins[0].joints = {0, 1, 2};
  scene.skins[0].inverse_bind.resize(3);
  triangle(scene).influences = {{{0, 3, 3, 0}}, {0, 1, 2, 2, 1, 0, 1, 0, 2}, {}};
  for (int v = 0; v < 3; ++v)
    triangle(scene).influences.weights.insert(triangle(scene).influences.weights.end(), weights);
}

TEST(asset_checks, a_good_scene_and_an_empty_one_pass) {
  EXPECT_EQ(check(good_scene()), ErrorCode::ok);
  Scene header_only = good_scene();
  header_only.images.push_back({"", 2, 2, {}, ""});
  EXPECT_EQ(check(header_only), ErrorCode::ok);
  Scene empty;
  finish_scene(empty);
  EXPECT_EQ(check(empty), ErrorCode::ok);
  for (const std::initializer_list<float> weights : {std::initializer_list<float>{0.5f, 0.25f, 0.25f}, {1, 0, 0}}) {
    Scene three = good_scene();
    use_three_influences(three, weights);
    EXPECT_EQ(check(three), ErrorCode::ok);
  }
}

TEST(asset_checks, finish_scene_bounds_primitives_that_have_no_box) {
  Scene scene = good_scene();
  triangle(scene).positions[1] = {1, 2, 3};
  triangle(scene).bounds = {};
  finish_scene(scene);
  EXPECT_EQ(triangle(scene).bounds.upper, glm::vec3(1, 2, 3));
  EXPECT_EQ(triangle(scene).bounds.lower, glm::vec3(0, 0, 0));
  EXPECT_EQ(check(scene), ErrorCode::ok);
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
      {"root that is its own parent", [](Scene& s) { s.skeleton.parents[0] = 0; }, ErrorCode::parents_not_first},
      {"levels out of order",
       [](Scene& s) {
         s.skeleton.level_begin = {0, 2, 3};
       },
       ErrorCode::parents_not_first},
      {"levels incomplete", [](Scene& s) { s.skeleton.level_begin.pop_back(); }, ErrorCode::size_mismatch},
      {"fixed matrix index", [](Scene& s) { s.skeleton.fixed_matrix_of[0] = 1; }, ErrorCode::index_out_of_range},
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
      {"instance mesh", [](Scene& s) { s.instances[0].mesh = 2; }, ErrorCode::index_out_of_range},
      {"instance skin", [](Scene& s) { s.instances[0].skin = 1; }, ErrorCode::index_out_of_range},
      {"instance weights", [](Scene& s) { s.instances[0].rest_weights.clear(); }, ErrorCode::size_mismatch},
      {"weight not finite", [](Scene& s) { s.instances[0].rest_weights[0] = kNan; }, ErrorCode::not_finite},
      {"animated joint", [](Scene& s) { s.animations[0].bones[0].joint = 3; }, ErrorCode::index_out_of_range},
      {"decreasing times",
       [](Scene& s) {
         s.animations[0].bones[0].translation.times_s = {1, 0};
       },
       ErrorCode::times_not_increasing},
      {"animated instance", [](Scene& s) { s.animations[0].weights[0].instance = 2; }, ErrorCode::index_out_of_range},
      {"animated targets", [](Scene& s) { s.animations[0].weights[0].weights.target_count = 2; },
       ErrorCode::size_mismatch},
      {"clip of other weights",
       [](Scene& s) {
         Scene other = good_scene();
         other.instances.push_back({0, 0, kNone, {0.25f}});
         finish_scene(other);
         s.clips = std::move(other.clips);
       },
       ErrorCode::size_mismatch},
      {"clip missing", [](Scene& s) { s.clips.clear(); }, ErrorCode::size_mismatch},
      {"weight offsets", [](Scene& s) { s.first_weight.push_back(1); }, ErrorCode::size_mismatch},
      {"last weight offset",
       [](Scene& s) {
         s.animations.clear();  // their clips would have another weight count
         s.clips.clear();
         ++s.first_weight.back();
       },
       ErrorCode::size_mismatch},
      {"texture index", [](Scene& s) { s.materials[0].normal_texture.texture = 0; }, ErrorCode::index_out_of_range},
      {"texture of a layer", [](Scene& s) { s.materials[0].clearcoat.normal_texture.texture = 0; },
       ErrorCode::index_out_of_range},
      {"index of refraction", [](Scene& s) { s.materials[0].specular.ior = kNan; }, ErrorCode::not_finite},
      {"sheen", [](Scene& s) { s.materials[0].sheen.roughness = kNan; }, ErrorCode::not_finite},
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

TEST(asset_checks, what_jobs_rely_on_is_found_where_it_is_broken) {
  const struct {
    const char* what;
    std::function<void(Scene&)> damage;
    ErrorCode expected;
  } cases[] = {
      {"rest rotation of length 2", [](Scene& s) { s.skeleton.rest[1].rotation = about_x(0.5f) * 2.0f; },
       ErrorCode::not_normalised},
      {"rest rotation of length 0", [](Scene& s) { s.skeleton.rest[1].rotation = about_x(0.5f) * 0.0f; },
       ErrorCode::not_normalised},
      {"a level that ends past the joints",
       [](Scene& s) {
         s.skeleton.level_begin = {0, 1, 100'000, 3};
       },
       ErrorCode::parents_not_first},
      {"fixed matrix not finite", [](Scene& s) { s.skeleton.fixed_matrices[0].row[0].x = kInfinity; },
       ErrorCode::not_finite},
      {"nodes and joints that are not inverse",
       [](Scene& s) {
         s.skeleton.joint_of_node = {0, 0, 1};
       },
       ErrorCode::index_out_of_range},
      {"hidden joint", [](Scene& s) { s.hidden_joints = {3}; }, ErrorCode::index_out_of_range},
      {"skeleton root", [](Scene& s) { s.skins[0].skeleton_root = 3; }, ErrorCode::index_out_of_range},
      {"linear key of length 0",
       [](Scene& s) {
         s.animations[0].bones[0].rotation.values[1] = {0, 0, 0, 0};
       },
       ErrorCode::not_normalised},
      {"linear key of length 2", [](Scene& s) { s.animations[0].bones[0].rotation.values[1] = about_x(0.5f) * 2.0f; },
       ErrorCode::not_normalised},
      {"step key of length 0",
       [](Scene& s) {
         s.animations[0].bones[0].rotation.interpolation = Interpolation::step;
         s.animations[0].bones[0].rotation.values[0] = {0, 0, 0, 0};
       },
       ErrorCode::not_normalised},
      {"squad key of length 0",
       [](Scene& s) {
         s.animations[0].bones[1].rotation.values[0] = {0, 0, 0, 0};
       },
       ErrorCode::not_normalised},
      {"cubic value of length 0",
       [](Scene& s) {
         s.animations[0].bones[2].rotation.values[4] = {0, 0, 0, 0};
       },
       ErrorCode::not_normalised},
      {"cubic value whose square float cannot hold",
       [](Scene& s) { s.animations[0].bones[2].rotation.values[4] = about_x(0.5f) * 1e30f; },
       ErrorCode::not_normalised},
      {"key not finite", [](Scene& s) { s.animations[0].bones[2].rotation.values[0].x = kNan; }, ErrorCode::not_finite},
      {"key time not finite", [](Scene& s) { s.animations[0].bones[0].rotation.times_s[1] = kInfinity; },
       ErrorCode::not_finite},
      {"squad for a translation",
       [](Scene& s) { s.animations[0].bones[0].translation.interpolation = Interpolation::squad; },
       ErrorCode::unsupported},
      {"no interpolation",
       [](Scene& s) { s.animations[0].bones[0].rotation.interpolation = static_cast<Interpolation>(4); },
       ErrorCode::unsupported},
      {"values for other keys", [](Scene& s) { s.animations[0].bones[0].rotation.values.pop_back(); },
       ErrorCode::size_mismatch},
      {"cubic track of one key",
       [](Scene& s) {
         s.animations[0].bones[2].rotation.times_s.resize(1);
         s.animations[0].bones[2].rotation.values.resize(3);
       },
       ErrorCode::too_few_keys},
      {"duration", [](Scene& s) { s.animations[0].duration_s = -1.0; }, ErrorCode::not_finite},
      {"influences without groups", [](Scene& s) { triangle(s).influences.groups.clear(); }, ErrorCode::size_mismatch},
      {"group of no influence", [](Scene& s) { triangle(s).influences.groups[0].influence_count = 0; },
       ErrorCode::size_mismatch},
      {"groups that share influences", [](Scene& s) { triangle(s).influences.groups[1].first_influence = 1; },
       ErrorCode::size_mismatch},
      {"influences of no group",
       [](Scene& s) {
         triangle(s).influences.joints.push_back(0);
         triangle(s).influences.weights.push_back(1.0f);
       },
       ErrorCode::size_mismatch},
      {"weights that rise",
       [](Scene& s) {
         use_three_influences(s, {0.25f, 0.5f, 0.25f});
       },
       ErrorCode::unsupported},
      {"weights that rise at the end",
       [](Scene& s) {
         use_three_influences(s, {0.5f, 0.2f, 0.3f});
       },
       ErrorCode::unsupported},
      {"weights below 1",
       [](Scene& s) {
         use_three_influences(s, {0.5f, 0.25f, 0.125f});
       },
       ErrorCode::not_normalised},
      {"weights above 1",
       [](Scene& s) {
         use_three_influences(s, {0.5f, 0.5f, 0.5f});
       },
       ErrorCode::not_normalised},
      {"weights of nothing",
       [](Scene& s) {
         use_three_influences(s, {0, 0, 0});
       },
       ErrorCode::not_normalised},
      {"one weight below 1", [](Scene& s) { triangle(s).influences.weights[1] = 0.5f; }, ErrorCode::not_normalised},
      {"weight of NaN", [](Scene& s) { triangle(s).influences.weights[2] = kNan; }, ErrorCode::not_finite},
      {"normal not finite", [](Scene& s) { triangle(s).normals[2].z = kInfinity; }, ErrorCode::not_finite},
      {"position outside of the bounds", [](Scene& s) { triangle(s).positions[2].y = 1.0f; },
       ErrorCode::index_out_of_range},
      {"bounds not finite", [](Scene& s) { triangle(s).bounds.upper.x = kInfinity; }, ErrorCode::not_finite},
      {"topology", [](Scene& s) { triangle(s).topology = static_cast<Topology>(3); }, ErrorCode::unsupported},
      {"texcoords too short",
       [](Scene& s) {
         triangle(s).texcoords = {{{0, 0}}};
       },
       ErrorCode::size_mismatch},
      {"variants that do not rise", [](Scene& s) { triangle(s).variant_materials[1].variant = 0; },
       ErrorCode::unsupported},
      {"variant", [](Scene& s) { triangle(s).variant_materials[1].variant = 2; }, ErrorCode::index_out_of_range},
      {"material of a variant", [](Scene& s) { triangle(s).variant_materials[0].material = 1; },
       ErrorCode::index_out_of_range},
      {"delta twice",
       [](Scene& s) {
         triangle(s).morphs.targets[0].positions.vertices = {2, 2};
       },
       ErrorCode::unsupported},
      {"delta not finite", [](Scene& s) { triangle(s).morphs.targets[0].positions.deltas[0].y = kNan; },
       ErrorCode::not_finite},
      {"default weight not finite", [](Scene& s) { s.meshes[0].default_weights[0] = kNan; }, ErrorCode::not_finite},
      {"skin with fewer joints than the mesh names",
       [](Scene& s) {
         s.skins[0].joints.pop_back();
         s.skins[0].inverse_bind.pop_back();
       },
       ErrorCode::index_out_of_range},
      {"copy not finite", [](Scene& s) { s.instances[1].copies[1].translation.x = kNan; }, ErrorCode::not_finite},
      {"copy of length 0",
       [](Scene& s) {
         s.instances[1].copies[1].rotation = {0, 0, 0, 0};
       },
       ErrorCode::not_normalised},
      {"copies of a skinned mesh", [](Scene& s) { s.instances[0].copies.resize(1); }, ErrorCode::unsupported},
      {"animated targets past the last", [](Scene& s) { s.animations[0].weights[0].first_target = 1; },
       ErrorCode::size_mismatch},
      {"weights that do not begin at 0",
       [](Scene& s) {
         s.first_weight = {1, 2, 2};
       },
       ErrorCode::size_mismatch},
      {"weights of another order",
       [](Scene& s) {
         s.first_weight = {0, 0, 1};
       },
       ErrorCode::size_mismatch},
      {"clip of fewer joints",
       [](Scene& s) {
         Scene other;
         other.skeleton = test::chain_skeleton(2);
         other.animations.emplace_back();
         finish_scene(other);
         s.clips = std::move(other.clips);
       },
       ErrorCode::size_mismatch},
      {"clip of fewer properties",
       [](Scene& s) {
         s.properties = {};
         s.animations[0].properties.clear();
       },
       ErrorCode::size_mismatch},
      {"property that the table lacks",
       [](Scene& s) { s.animations[0].properties[0].target.kind = PropertyKind::metallic; }, ErrorCode::size_mismatch},
      {"property of no material", [](Scene& s) { s.properties.entries[0].target.index = 1; },
       ErrorCode::index_out_of_range},
      {"property of no kind", [](Scene& s) { s.properties.entries[1].target.kind = static_cast<PropertyKind>(99); },
       ErrorCode::index_out_of_range},
      {"property of no texture", [](Scene& s) { s.properties.entries[1].target.slot = static_cast<TextureSlot>(5); },
       ErrorCode::index_out_of_range},
      {"property elsewhere", [](Scene& s) { s.properties.entries[1].first = 5; }, ErrorCode::size_mismatch},
      {"property of more numbers", [](Scene& s) { s.properties.entries[1].count = 3; }, ErrorCode::size_mismatch},
      {"rest numbers of properties missing", [](Scene& s) { s.properties.rest.pop_back(); }, ErrorCode::size_mismatch},
      {"rest number of a property", [](Scene& s) { s.properties.rest[0] = kNan; }, ErrorCode::not_finite},
      {"properties out of order",
       [](Scene& s) {
         std::swap(s.properties.entries[0].target, s.properties.entries[1].target);
         s.properties.entries[0].count = 2;
         s.properties.entries[1].first = 2;
         s.properties.entries[1].count = 4;
       },
       ErrorCode::unsupported},
      {"driver joint", [](Scene& s) { s.correctives[0].samples.drivers[0].joint = 3; }, ErrorCode::index_out_of_range},
      {"driver axis", [](Scene& s) { s.correctives[0].samples.drivers[0].axis = glm::vec3(0.0f); },
       ErrorCode::not_finite},
      {"corrected weight", [](Scene& s) { s.correctives[0].samples.weights[0] = 1; }, ErrorCode::index_out_of_range},
      {"sample without rotation",
       [](Scene& s) {
         s.correctives[0].samples.rotations[1] = {0, 0, 0, 0};
       },
       ErrorCode::not_finite},
      {"coefficient", [](Scene& s) { s.correctives[0].coefficients[0] = std::numeric_limits<double>::quiet_NaN(); },
       ErrorCode::not_finite},
      {"coefficients too few", [](Scene& s) { s.correctives[0].coefficients.pop_back(); }, ErrorCode::size_mismatch},
      {"range not finite", [](Scene& s) { s.correctives[0].upper[0] = kNan; }, ErrorCode::not_finite},
      {"range upside down", [](Scene& s) { std::swap(s.correctives[0].lower[0], s.correctives[0].upper[0]); },
       ErrorCode::unsupported},
      {"colour not finite", [](Scene& s) { s.materials[0].base_color.w = kNan; }, ErrorCode::not_finite},
      {"texture offset not finite", [](Scene& s) { s.materials[0].normal_texture.offset.x = kInfinity; },
       ErrorCode::not_finite},
      {"camera not finite", [](Scene& s) { s.cameras.emplace_back().far_m = kNan; }, ErrorCode::not_finite},
      {"light not finite", [](Scene& s) { s.lights.emplace_back().intensity = kInfinity; }, ErrorCode::not_finite},
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
  EXPECT_EQ(scene.first_weight, (std::vector<std::uint32_t>{0, 1, 1, 2}));
  ASSERT_EQ(scene.clips.size(), 1u);
  EXPECT_EQ(scene.clips[0].weight_count(), 2u);
  EXPECT_EQ(check(scene), ErrorCode::ok);
}

}  // namespace
}  // namespace sinew
