// SPDX-License-Identifier: MIT
#include <algorithm>

#include "importer/read/property_pointer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "importer/export_glb.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kTarget = "/animations/0/channels/0/target";

Json pointing_at(const std::string& text) {
  return {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", text}}}}}};
}

/// A file with one object of each kind that an animation pointer can target.
TinyGltf everything() {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["targets"] = Json::array({{{"POSITION", 0}}, {{"POSITION", 0}}});
  primitive["material"] = 0;
  file.root["images"] = Json::array({{{"uri", "missing.png"}}});
  file.root["textures"] = Json::array({{{"source", 0}}});
  const Json moved = {{"index", 0}, {"extensions", {{"KHR_texture_transform", Json::object()}}}};
  file.root["materials"] =
      Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", moved}, {"metallicRoughnessTexture", moved}}},
                    {"normalTexture", moved},
                    {"occlusionTexture", moved},
                    {"emissiveTexture", moved},
                    {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2}}}}}},
                   Json::object()});
  file.root["cameras"] = Json::array(
      {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}, {"zfar", 10}, {"aspectRatio", 2}}}},
       {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}},
       {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
  file.root["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({{{"type", "spot"}, {"spot", Json::object()}, {"range", 5}}, {{"type", "point"}}});
  file.root["nodes"] = Json::array(
      {{{"mesh", 0},
        {"camera", 0},
        {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}, {"KHR_node_visibility", {{"visible", false}}}}}},
       {{"mesh", 0}, {"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
       {{"mesh", 0}, {"weights", {0.5, 0.5}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}}});
  return file;
}

/// That file with one animated pointer of two keys. Flags are bytes, other values floats.
TinyGltf animated(const std::string& text, std::size_t components, const char* interpolation = "LINEAR") {
  TinyGltf file = everything();
  const bool flag = text.ends_with("visible");
  const std::size_t input = file.times({0, 1});
  static constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  std::vector<float> values;
  for (std::size_t i = 0; i < 2 * components; ++i) values.push_back(static_cast<float>(i + 1));
  const std::size_t output = flag ? file.add(std::vector<std::uint8_t>{1, 0}, "SCALAR", 5121, 1)
                                  : file.add(values, kTypes[components], 5126, components);
  file.animate("pointer", input, output, interpolation);
  file.root["animations"][0]["channels"][0]["target"] = pointing_at(text);
  return file;
}

struct PointerCase {
  const char* pointer;
  PropertyKind kind;
  std::size_t components;
  std::uint32_t index = 0;
  TextureSlot slot = TextureSlot::base_color;
};

constexpr PointerCase kCases[] = {
    {"/cameras/0/perspective/yfov", PropertyKind::camera_fov_y, 1},
    {"/cameras/0/perspective/aspectRatio", PropertyKind::camera_aspect, 1},
    {"/cameras/0/perspective/znear", PropertyKind::camera_near, 1},
    {"/cameras/0/perspective/zfar", PropertyKind::camera_far, 1},
    {"/cameras/1/orthographic/xmag", PropertyKind::camera_half_width, 1, 1},
    {"/cameras/1/orthographic/ymag", PropertyKind::camera_half_height, 1, 1},
    {"/cameras/1/orthographic/znear", PropertyKind::camera_near, 1, 1},
    {"/cameras/1/orthographic/zfar", PropertyKind::camera_far, 1, 1},
    {"/extensions/KHR_lights_punctual/lights/0/color", PropertyKind::light_color, 3},
    {"/extensions/KHR_lights_punctual/lights/0/intensity", PropertyKind::light_intensity, 1},
    {"/extensions/KHR_lights_punctual/lights/0/range", PropertyKind::light_range, 1},
    {"/extensions/KHR_lights_punctual/lights/0/spot/innerConeAngle", PropertyKind::light_inner_cone, 1},
    {"/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", PropertyKind::light_outer_cone, 1},
    {"/extensions/KHR_lights_punctual/lights/1/color", PropertyKind::light_color, 3, 2},
    {"/materials/0/pbrMetallicRoughness/baseColorFactor", PropertyKind::base_color, 4},
    {"/materials/1/pbrMetallicRoughness/baseColorFactor", PropertyKind::base_color, 4, 1},
    {"/materials/0/pbrMetallicRoughness/metallicFactor", PropertyKind::metallic, 1},
    {"/materials/0/pbrMetallicRoughness/roughnessFactor", PropertyKind::roughness, 1},
    {"/materials/0/normalTexture/scale", PropertyKind::normal_scale, 1},
    {"/materials/0/occlusionTexture/strength", PropertyKind::occlusion_strength, 1},
    {"/materials/0/emissiveFactor", PropertyKind::emissive, 3},
    {"/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", PropertyKind::emissive_strength, 1},
    {"/materials/0/alphaCutoff", PropertyKind::alpha_cutoff, 1},
    {"/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset",
     PropertyKind::texture_offset, 2},
    {"/materials/0/pbrMetallicRoughness/metallicRoughnessTexture/extensions/KHR_texture_transform/rotation",
     PropertyKind::texture_rotation, 1, 0, TextureSlot::metallic_roughness},
    {"/materials/0/normalTexture/extensions/KHR_texture_transform/scale", PropertyKind::texture_scale, 2, 0,
     TextureSlot::normal},
    {"/materials/0/occlusionTexture/extensions/KHR_texture_transform/offset", PropertyKind::texture_offset, 2, 0,
     TextureSlot::occlusion},
    {"/materials/0/emissiveTexture/extensions/KHR_texture_transform/offset", PropertyKind::texture_offset, 2, 0,
     TextureSlot::emissive},
    {"/nodes/0/extensions/KHR_node_visibility/visible", PropertyKind::node_visible, 1}};

TEST(property_pointer, G58_every_property_of_the_object_model_that_the_runtime_has_is_read) {
  for (const PointerCase& c : kCases) {
    SCOPED_TRACE(c.pointer);
    const auto result = animated(c.pointer, c.components, "STEP").import();
    ASSERT_EQ(outcome(result), "ok");
    ASSERT_FALSE(result->scene.animations[0].properties.empty());
    const PropertyTrack& track = result->scene.animations[0].properties.front();
    EXPECT_EQ(track.target, (PropertyTarget{c.kind, c.index, c.slot}));
    EXPECT_EQ(track.values.target_count, c.components);
    EXPECT_EQ(track.values.values.size(), 2 * c.components);
    EXPECT_EQ(result->scene.clips[0].duration_s(), 1.0);
    EXPECT_FALSE(warns(result, "animation-pointer", kTarget));
  }
}

TEST(property_pointer, G58_a_written_file_points_at_the_same_properties) {
  for (const PointerCase& c : kCases) {
    SCOPED_TRACE(c.pointer);
    const auto first = animated(c.pointer, c.components, "STEP").import();
    ASSERT_EQ(outcome(first), "ok");
    const auto bytes = export_glb(first->scene);
    ASSERT_TRUE(bytes);
    const auto again = import_gltf(*bytes, "again.glb");
    ASSERT_EQ(outcome(again), "ok");
    const auto &before = first->scene.animations[0].properties, &after = again->scene.animations[0].properties;
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].target, after[i].target);
  }
}

TEST(property_pointer, G58_a_light_or_camera_on_several_nodes_moves_on_all_of_them) {
  const auto light = animated("/extensions/KHR_lights_punctual/lights/0/intensity", 1).import();
  ASSERT_EQ(outcome(light), "ok");
  ASSERT_THAT(light->scene.lights, SizeIs(3));
  EXPECT_THAT(light->scene.animations[0].properties, SizeIs(2));
  const auto camera = animated("/cameras/0/perspective/yfov", 1).import();
  ASSERT_THAT(camera->scene.cameras, SizeIs(4)) << "three, and the first once more";
  ASSERT_THAT(camera->scene.animations[0].properties, SizeIs(2));
  EXPECT_EQ(camera->scene.animations[0].properties[1].target.index, 3u);
}

TEST(property_pointer, G58_undefined_properties_without_default_are_ignored_and_named) {
  for (const char* text :
       {"/cameras/2/perspective/zfar", "/cameras/2/perspective/aspectRatio", "/cameras/0/orthographic/xmag",
        "/extensions/KHR_lights_punctual/lights/1/range",
        "/extensions/KHR_lights_punctual/lights/1/spot/innerConeAngle", "/materials/1/normalTexture/scale",
        "/materials/1/occlusionTexture/strength",
        "/materials/1/extensions/KHR_materials_emissive_strength/emissiveStrength",
        "/materials/1/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/rotation",
        "/nodes/1/extensions/KHR_node_visibility/visible"}) {
    const auto result = animated(text, 1).import();
    EXPECT_TRUE(warns(result, "animation-pointer", kTarget)) << text;
    EXPECT_THAT(result->scene.animations[0].properties, IsEmpty()) << text;
  }
}

/// A property cannot be animated without its own object. Other missing objects do not matter.
TEST(property_pointer, G58_a_property_needs_its_own_object_and_no_other) {
  const std::string material = "/materials/0/";
  for (const auto& [text, owner] : {std::pair(material + "normalTexture/scale", "normalTexture"),
                                    {material + "occlusionTexture/strength", "occlusionTexture"}})
    for (const char* removed : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
      TinyGltf file = animated(text, 1);
      file.root["materials"][0].erase(removed);
      const auto result = file.import();
      ASSERT_EQ(outcome(result), "ok") << text;
      EXPECT_EQ(result->scene.animations[0].properties.empty(), std::string(owner) == removed) << text << removed;
    }
}

TEST(property_pointer, G58_a_texture_that_nothing_places_has_no_place_to_animate) {
  const std::string transform = "/extensions/KHR_texture_transform";
  std::vector<std::pair<PointerCase, std::string>> textures;
  for (const PointerCase& c : kCases)
    if (const std::string text = c.pointer; text.find(transform) != text.npos)
      textures.emplace_back(c, text.substr(0, text.find(transform)));
  ASSERT_THAT(textures, SizeIs(5));
  for (const auto& [c, own] : textures)
    for (const bool is_placed : {true, false}) {  // on this texture alone, or on all others
      TinyGltf file = animated(c.pointer, c.components);
      for (const auto& [any, texture] : textures)
        if ((texture == own) != is_placed) file.root[Json::json_pointer(texture)].erase("extensions");
      const auto result = file.import();
      EXPECT_EQ(result->scene.animations[0].properties.empty(), !is_placed) << own;
      EXPECT_EQ(warns(result, "animation-pointer", kTarget), !is_placed) << own;
    }
}

TEST(property_pointer, G58_properties_that_the_runtime_does_not_have_are_ignored_and_named) {
  for (const char* text :
       {"/materials/0/extensions/KHR_materials_clearcoat/clearcoatFactor", "/materials/0/alphaMode", "/scene",
        "/materials/00/alphaCutoff", "/materials/0/alphaCutoff/", "/cameras/0/perspective", "/images/0/uri",
        "/nodes/0/translation/0", "/meshes/0/translation", "/nodes/0/weights/x", "/nodes/0/weights/", "/materials//"}) {
    const auto result = animated(text, 1).import();
    ASSERT_TRUE(warns(result, "animation-pointer", kTarget)) << text;
    const auto named = [&](const ImportIssue& issue) { return issue.detail.find(text) != std::string::npos; };
    EXPECT_TRUE(std::any_of(result->warnings.begin(), result->warnings.end(), named)) << text;
  }
  EXPECT_EQ(survived(animated("/materials/9/alphaCutoff", 1).import()), std::string("reference at ") + kTarget);
}

TEST(property_pointer, G58_a_light_that_no_node_shows_is_moved_by_nothing) {
  TinyGltf file = animated("/extensions/KHR_lights_punctual/lights/1/intensity", 1);
  file.root["nodes"][2].erase("extensions");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_TRUE(warns(result, "animation-pointer", kTarget));
  EXPECT_THAT(result->scene.lights, SizeIs(2));
  EXPECT_THAT(result->scene.animations[0].properties, IsEmpty());
  EXPECT_EQ(result->scene.animations[0].duration_s, 0.0) << "a channel that is ignored lasts no time";
}

TEST(property_pointer, a_camera_has_no_pointer_to_what_the_other_kind_of_camera_has) {
  Scene scene;
  scene.cameras.resize(2);
  scene.cameras[1].perspective = false;
  const auto pointer_to = [&](PropertyKind kind, std::uint32_t camera) {
    return property_pointer({kind, camera, TextureSlot::base_color}, scene);
  };
  EXPECT_EQ(pointer_to(PropertyKind::camera_fov_y, 0), "/cameras/0/perspective/yfov");
  EXPECT_EQ(pointer_to(PropertyKind::camera_half_width, 0), "/cameras/0/");
  EXPECT_EQ(pointer_to(PropertyKind::camera_fov_y, 1), "/cameras/1/");
  EXPECT_EQ(pointer_to(PropertyKind::camera_half_width, 1), "/cameras/1/orthographic/xmag");
}

TEST(property_pointer, G58_flags_take_steps) {
  const std::string text = "/nodes/0/extensions/KHR_node_visibility/visible";
  const auto step = animated(text, 1, "STEP").import();
  ASSERT_EQ(outcome(step), "ok");
  EXPECT_THAT(step->scene.hidden_joints, ElementsAre(0));
  EXPECT_FALSE(warns(step, "animation-flag", "/animations/0/samplers/0/interpolation"));
  EXPECT_THAT(step->scene.animations[0].properties[0].values.values, ElementsAre(1, 0));
  const auto linear = animated(text, 1).import();
  EXPECT_TRUE(warns(linear, "animation-flag", "/animations/0/samplers/0/interpolation"));
  EXPECT_EQ(linear->scene.animations[0].properties[0].values.interpolation, Interpolation::step);
  const auto cubic = animated(text, 1, "CUBICSPLINE").import();
  EXPECT_TRUE(warns(cubic, "animation-flag", "/animations/0/samplers/0/interpolation"));
  EXPECT_THAT(cubic->scene.animations[0].properties, IsEmpty());
  TinyGltf floats = animated(text, 1, "STEP");
  floats.root["animations"][0]["samplers"][0]["output"] = floats.scalars({1, 0});
  EXPECT_EQ(survived(floats.import()), "animation-output at /animations/0/samplers/0/output");
  TinyGltf any = animated(text, 1, "STEP");
  any.root["animations"][0]["samplers"][0]["output"] = any.add(std::vector<std::uint8_t>{7, 0}, "SCALAR", 5121, 1);
  EXPECT_THAT(any.import()->scene.animations[0].properties[0].values.values, ElementsAre(1, 0));
}

TEST(property_pointer, G58_integers_are_decoded_before_they_are_interpolated) {
  TinyGltf file = animated("/materials/0/alphaCutoff", 1);
  file.root["animations"][0]["samplers"][0]["output"] =
      file.add(std::vector<std::uint8_t>{0, 255}, "SCALAR", 5121, 1, true);
  EXPECT_THAT(file.import()->scene.animations[0].properties[0].values.values, ElementsAre(0, 1));
  file.root["animations"][0]["samplers"][0]["output"] = file.add(std::vector<std::uint8_t>{0, 255}, "SCALAR", 5121, 1);
  EXPECT_THAT(file.import()->scene.animations[0].properties[0].values.values, ElementsAre(0, 255));
}

TEST(property_pointer, G58_values_have_the_shape_of_their_property) {
  EXPECT_EQ(survived(animated("/materials/0/alphaCutoff", 2).import()),
            "animation-output at /animations/0/samplers/0/output");
  EXPECT_EQ(survived(animated("/materials/0/emissiveFactor", 4).import()),
            "animation-output at /animations/0/samplers/0/output");
}

/// `first` animated, and a second channel with the target `second` on the same sampler.
TinyGltf twice(const std::string& first, const Json& second, std::size_t components) {
  TinyGltf file = animated(first, components);
  file.root["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", second}});
  return file;
}

TEST(property_pointer, G58_no_property_is_moved_twice) {
  const std::string place = "/animations/0/channels/1/target";
  const Json scale = {{"node", 0}, {"path", "scale"}};
  EXPECT_TRUE(warns(twice("/nodes/0/scale", scale, 3).import(), "animation-duplicate", place));
  EXPECT_TRUE(warns(twice("/materials/0/alphaCutoff", pointing_at("/materials/0/alphaCutoff"), 1).import(),
                    "animation-duplicate", place));
  EXPECT_TRUE(
      warns(twice("/nodes/0/weights/0", pointing_at("/nodes/0/weights/0"), 1).import(), "animation-duplicate", place));
  EXPECT_TRUE(
      warns(twice("/nodes/0/weights/1", pointing_at("/nodes/0/weights"), 1).import(), "animation-duplicate", place));
  EXPECT_TRUE(
      warns(twice("/nodes/0/weights/1", {{"node", 0}, {"path", "weights"}}, 1).import(), "animation-duplicate", place));
  EXPECT_TRUE(
      warns(twice("/nodes/0/weights/0", pointing_at("/nodes/0/weights"), 1).import(), "animation-duplicate", place))
      << "the first of them as well";
  EXPECT_TRUE(
      warns(twice("/meshes/0/weights/1", pointing_at("/meshes/0/weights"), 1).import(), "animation-duplicate", place));
  const auto apart = twice("/nodes/0/weights/0", pointing_at("/nodes/0/weights/1"), 1).import();
  EXPECT_FALSE(warns(apart, "animation-duplicate", place));
  EXPECT_THAT(apart->scene.animations[0].weights, SizeIs(2));
}

TEST(property_pointer, G58_one_weight_of_several_moves_alone) {
  TinyGltf file = animated("/nodes/2/weights/1", 1);
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& tracks = result->scene.animations[0].weights;
  ASSERT_THAT(tracks, SizeIs(1));
  EXPECT_EQ(tracks[0].instance, 2u);
  EXPECT_EQ(tracks[0].first_target, 1u);
  EXPECT_EQ(tracks[0].weights.target_count, 1u);
  EXPECT_TRUE(warns(animated("/nodes/2/weights/2", 1).import(), "animation-pointer", kTarget)) << "there are two";
}

TEST(property_pointer, G58_default_weights_of_a_mesh_move_the_nodes_without_their_own) {
  const auto result = animated("/meshes/0/weights/0", 1).import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.animations[0].weights, SizeIs(2)) << "node 2 has weights";
  EXPECT_EQ(result->scene.animations[0].weights[0].instance, 0u);
  EXPECT_EQ(result->scene.animations[0].weights[1].instance, 1u);
  EXPECT_THAT(
      animated("/meshes/0/weights/0", 1).import({.animate_default_weights = false})->scene.animations[0].weights,
      IsEmpty());
  const auto own = twice("/meshes/0/weights/0", pointing_at("/nodes/1/weights/0"), 1).import();
  ASSERT_THAT(own->scene.animations[0].weights, SizeIs(2));
  EXPECT_FALSE(warns(own, "animation-duplicate", "/animations/0/channels/1/target")) << "the node's own go first";
}

TEST(property_pointer, G58_default_weights_of_one_mesh_move_no_node_of_another) {
  TinyGltf file = animated("/meshes/1/weights/0", 1);
  file.root["meshes"].push_back(file.root["meshes"][0]);
  file.root["nodes"].push_back({{"mesh", 1}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.animations[0].weights, SizeIs(1));
  EXPECT_EQ(result->scene.animations[0].weights[0].instance, 3u);
}

TEST(property_pointer, G58_weights_that_another_node_moves_are_free) {
  TinyGltf file = animated("/nodes/1/weights/0", 1);
  Json& animation = file.root["animations"][0];
  animation["samplers"].push_back(
      {{"input", animation["samplers"][0]["input"]}, {"output", file.scalars({1, 2, 3, 4})}});
  animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.animations[0].weights, SizeIs(2));
  EXPECT_EQ(result->scene.animations[0].weights[0].instance, 0u);
  EXPECT_EQ(result->scene.animations[0].weights[1].instance, 1u);
}

TEST(property_pointer, G58_a_default_weight_moves_nodes_that_move_only_others) {
  const auto result = twice("/meshes/0/weights/0", pointing_at("/nodes/1/weights/1"), 1).import();
  ASSERT_EQ(outcome(result), "ok");
  std::vector<std::pair<std::uint32_t, std::uint32_t>> moved;
  for (const WeightAnimation& track : result->scene.animations[0].weights)
    moved.emplace_back(track.instance, track.first_target);
  EXPECT_THAT(moved, ElementsAre(std::pair(0u, 0u), std::pair(1u, 0u), std::pair(1u, 1u)));
}

TEST(property_pointer, one_track_on_very_many_nodes_does_not_take_memory_without_bound) {
  TinyGltf file = animated("/meshes/0/weights/0", 1);
  std::vector<float> times(30000), values(30000, 0.5f);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<float>(i);
  file.root["animations"][0]["samplers"][0]["input"] = file.times(times);
  file.root["animations"][0]["samplers"][0]["output"] = file.scalars(values);
  for (int i = 0; i < 3000; ++i) file.root["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(outcome(file.import()), "memory-budget at ");
}

}  // namespace
}  // namespace sinew::test
