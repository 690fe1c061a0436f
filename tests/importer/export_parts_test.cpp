// SPDX-License-Identifier: MIT
// Round trips of scenes with a single part each through a .glb.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "importer/export_glb.h"
#include "importer/import_gltf.h"
#include "tests/importer/rewritten.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

ImportedFile round_trip(const Scene& scene, bool quiet = true) {
  const auto bytes = export_glb(scene);
  if (!bytes) throw std::runtime_error(describe("scene", bytes.error().issue));
  auto file = import_gltf(*bytes, "round-trip.glb");
  if (!file) throw std::runtime_error(describe("round-trip.glb", file.error().issue));
  for (const ImportIssue& warning : file->warnings)
    if (quiet) ADD_FAILURE() << describe("round-trip.glb", warning);
  return *std::move(file);
}

void add_texture(Scene& scene) {
  scene.images.push_back({"dot", 1, 1, {1, 2, 3, 255}, ""});
  scene.textures.push_back({static_cast<std::uint32_t>(scene.images.size() - 1), {}});
}

TEST(export_parts, each_setting_of_a_material_alone) {
  using Change = std::function<void(Material&)>;
  std::vector<Change> changes{[](Material& m) { m.name = "name"; },
                              [](Material& m) {
                                m.base_color = {0.5f, 0.25f, 0.75f, 0.125f};
                              },
                              [](Material& m) { m.metallic = 0.25f; },
                              [](Material& m) { m.roughness = 0.25f; },
                              [](Material& m) {
                                m.normal_texture.texture = 0;
                                m.normal_scale = 0.25f;
                              },
                              [](Material& m) {
                                m.occlusion_texture.texture = 0;
                                m.occlusion_strength = 0.25f;
                              },
                              [](Material& m) {
                                m.emissive = {0.5f, 0.25f, 0.75f};
                              },
                              [](Material& m) { m.emissive_strength = 3.0f; },
                              [](Material& m) { m.alpha_mode = AlphaMode::blend; },
                              [](Material& m) {
                                m.alpha_mode = AlphaMode::mask;
                                m.alpha_cutoff = 0.25f;
                              },
                              [](Material& m) { m.alpha_cutoff = 0.25f; },
                              [](Material& m) { m.double_sided = true; },
                              [](Material& m) { m.unlit = true; },
                              [](Material& m) { m.specular.ior = 2.0f; },
                              [](Material& m) { m.specular.factor = 0.5f; },
                              [](Material& m) {
                                m.specular.color = {0.5f, 0.25f, 2.0f};
                              },
                              [](Material& m) {
                                m.metallic = 0.0f;
                                m.roughness = 0.25f;
                                m.base_color = {0.5f, 0.25f, 1.0f, 0.75f};
                                m.specular = {.ior = 0.0f, .color = {0.5f, 0.25f, 0.75f}, .has_glossiness = true};
                                m.specular.color_texture.texture = m.base_color_texture.texture = 0;
                              },
                              [](Material& m) { m.clearcoat.factor = 0.5f; },
                              [](Material& m) { m.clearcoat.roughness = 0.5f; },
                              [](Material& m) {
                                m.clearcoat.normal_texture.texture = 0;
                                m.clearcoat.normal_scale = 0.5f;
                              },
                              [](Material& m) {
                                m.sheen.color = {0.5f, 0.25f, 0.75f};
                              },
                              [](Material& m) { m.sheen.roughness = 0.5f; },
                              [](Material& m) { m.transmission.factor = 0.5f; },
                              [](Material& m) { m.iridescence.factor = 0.5f; },
                              [](Material& m) { m.iridescence.ior = 1.5f; },
                              [](Material& m) { m.iridescence.thinnest_nm = 50.0f; },
                              [](Material& m) { m.iridescence.thickest_nm = 500.0f; },
                              [](Material& m) { m.anisotropy.strength = 0.5f; },
                              [](Material& m) { m.anisotropy.rotation_rad = 0.5f; },
                              [](Material& m) { m.volume.thickness_m = 0.5f; },
                              [](Material& m) { m.volume.attenuation_distance_m = 0.5f; },
                              [](Material& m) {
                                m.volume.attenuation_color = {0.5f, 1.0f, 0.25f};
                              }};
  const std::function<void(TextureUse&)> uses[] = {[](TextureUse&) {}, [](TextureUse& use) { use.texcoord = 1; },
                                                   [](TextureUse& use) {
                                                     use.offset = {0.5f, 0.25f};
                                                   },
                                                   [](TextureUse& use) { use.rotation_rad = 0.5f; },
                                                   [](TextureUse& use) {
                                                     use.scale = {2.0f, 0.5f};
                                                   }};
  Material any;
  for (std::size_t slot = 0; slot < texture_uses(any).size(); ++slot)
    for (const auto& change : uses)
      changes.push_back([slot, change](Material& m) {
        TextureUse& use = *texture_uses(m)[slot];
        use.texture = 0;
        change(use);
      });
  Scene scene = prop_scene();
  add_texture(scene);
  for (const Change& change : changes) change(scene.materials.emplace_back());
  finish_scene(scene);
  expect_equal(scene, round_trip(scene).scene);
}

TEST(export_parts, each_filter_and_each_wrap_of_a_texture) {
  Scene scene = prop_scene();
  for (const Filter filter : {Filter::nearest, Filter::linear}) {
    for (const Filter mipmap : {Filter::nearest, Filter::linear}) {
      add_texture(scene);
      scene.textures.back().sampler = {Filter::linear, filter, mipmap, true, Wrap::repeat, Wrap::repeat};
    }
    add_texture(scene);
    scene.textures.back().sampler = {filter, Filter::linear, Filter::nearest, false, Wrap::repeat, Wrap::repeat};
    add_texture(scene);
    scene.textures.back().sampler = {Filter::linear, filter, Filter::nearest, false, Wrap::repeat, Wrap::repeat};
  }
  for (const Wrap wrap : {Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
    for (Wrap Sampler::*side : {&Sampler::wrap_u, &Sampler::wrap_v}) {
      add_texture(scene);
      scene.textures.back().sampler.*side = wrap;
    }
  }
  finish_scene(scene);
  ImportedFile after = round_trip(scene);
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    EXPECT_LE(after.scene.textures[i].image, i) << "equal images are one";
    scene.textures[i].image = after.scene.textures[i].image;
  }
  after.scene.images = scene.images;
  expect_equal(scene, after.scene);
}

/// A scene with every property that a clip can move, besides joints and weights.
Scene movable() {
  Scene scene = prop_scene();
  add_texture(scene);
  Material& material = scene.materials.emplace_back();
  for (const TextureSlot slot : {TextureSlot::base_color, TextureSlot::metallic_roughness, TextureSlot::normal,
                                 TextureSlot::occlusion, TextureSlot::emissive})
    texture_in_slot(material, slot).texture = 0;
  Camera camera;
  camera.joint = 0;
  camera.aspect = 1.5f;
  camera.far_m = 10.0f;
  scene.cameras.push_back(camera);
  camera = {};
  camera.perspective = false;
  camera.far_m = 10.0f;
  scene.cameras.push_back(camera);
  Light light;
  light.kind = Light::Kind::spot;
  light.range_m = 5.0f;
  light.joint = 0;
  scene.lights.push_back(light);
  return scene;
}

TEST(export_parts, each_property_that_a_clip_moves_alone) {
  for (int k = 0; k <= static_cast<int>(PropertyKind::texture_scale); ++k) {
    const auto kind = static_cast<PropertyKind>(k);
    const bool flat = kind == PropertyKind::camera_half_width || kind == PropertyKind::camera_half_height;
    const bool textured = kind >= PropertyKind::texture_offset;
    for (int slot = 0; slot < (textured ? 5 : 1); ++slot) {
      SCOPED_TRACE(testing::Message() << "kind " << k << ", slot " << slot);
      Scene scene = movable();
      const std::uint32_t components = component_count(kind);
      WeightTrack track{Interpolation::linear, {0.0f, 0.5f}, {}, components};
      for (std::uint32_t i = 0; i < 2 * components; ++i) track.values.push_back(0.125f * static_cast<float>(i + 1));
      if (is_flag(kind)) track = {Interpolation::step, {0.0f, 0.5f}, {1.0f, 0.0f}, 1};
      scene.animations.push_back(
          {"move", 0.5, {}, {}, {{{kind, flat ? 1u : 0u, static_cast<TextureSlot>(slot)}, track}}});
      finish_scene(scene);
      ASSERT_EQ(check(scene), ErrorCode::ok);
      expect_equal(scene, round_trip(scene).scene);
    }
  }
}

TEST(export_parts, every_clip_moves_its_own_properties) {
  Scene scene = movable();
  for (const float end : {0.5f, 0.75f})
    scene.animations.push_back({"move",
                                0.5,
                                {},
                                {},
                                {{{PropertyKind::light_intensity, 0, TextureSlot::base_color},
                                  {Interpolation::linear, {0.0f, 0.5f}, {0.25f, end}, 1}}}});
  finish_scene(scene);
  expect_equal(scene, round_trip(scene).scene);
}

TEST(export_parts, key_times_that_tracks_share_are_written_once) {
  Scene scene = prop_scene();
  BoneAnimation bone;
  bone.joint = 0;
  bone.translation = {Interpolation::linear, {0.0f, 0.5f}, {glm::vec3(0.0f), glm::vec3(1.0f)}};
  bone.scale = {Interpolation::linear, {0.0f, 0.5f}, {glm::vec3(1.0f), glm::vec3(2.0f)}};
  scene.animations = {{"move", 0.5, {bone}, {}}};
  finish_scene(scene);
  const Json samplers = split_glb(*export_glb(scene)).json["animations"][0]["samplers"];
  EXPECT_EQ(samplers[0]["input"], samplers[1]["input"]);
  EXPECT_NE(samplers[0]["output"], samplers[1]["output"]);
}

TEST(export_parts, weights_of_a_node_are_said_where_they_are_not_those_of_the_mesh) {
  Scene scene = face_scene();
  const auto node_of = [](const Scene& s) { return split_glb(*export_glb(s)).json["nodes"][0]; };
  EXPECT_EQ(node_of(scene)["weights"], (Json{0.25, 0.0}));
  scene.instances[0].rest_weights = scene.meshes[0].default_weights;
  finish_scene(scene);
  EXPECT_FALSE(node_of(scene).contains("weights"));
}

TEST(export_parts, a_clip_that_moves_one_weight_alone) {
  for (const std::uint32_t target : {0u, 1u}) {
    Scene scene = face_scene();
    scene.animations[0].weights = {{0, {Interpolation::linear, {0.0f, 1.0f}, {0.25f, 0.75f}, 1}, target}};
    finish_scene(scene);
    expect_equal(scene, round_trip(scene).scene);
  }
}

TEST(export_parts, several_meshes_on_one_joint_hang_on_nodes_below_it) {
  Scene scene = face_scene();
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = kNone, .rest_weights = {0.5f, 0.75f}});
  scene.animations[0].weights[0].instance = 1;
  finish_scene(scene);
  const Scene after = round_trip(scene).scene;
  ASSERT_EQ(after.skeleton.joint_count(), 2u);
  ASSERT_EQ(after.instances.size(), 2u);
  EXPECT_EQ(after.instances[0].joint, 0u);
  EXPECT_EQ(after.instances[1].joint, 1u);
  EXPECT_EQ(after.skeleton.parents[1], 0u);
  EXPECT_EQ(after.skeleton.rest[1], Transform{});
  EXPECT_EQ(after.instances[1].rest_weights, scene.instances[1].rest_weights);
  ASSERT_EQ(after.animations[0].weights.size(), 1u);
  EXPECT_EQ(after.animations[0].weights[0].instance, 1u);
}

TEST(export_parts, several_cameras_and_lights_on_one_joint_hang_on_nodes_below_it) {
  Scene scene = prop_scene();
  for (int i = 0; i < 3; ++i) {
    scene.cameras.push_back({.name = "camera " + std::to_string(i), .joint = 0});
    scene.lights.push_back({.name = "light " + std::to_string(i), .joint = 0});
  }
  finish_scene(scene);
  const Scene after = round_trip(scene).scene;
  ASSERT_EQ(after.skeleton.joint_count(), 5u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(after.cameras.at(i).name, scene.cameras[i].name);
    EXPECT_EQ(after.lights.at(i).name, scene.lights[i].name);
    for (const std::uint32_t joint : {after.cameras[i].joint, after.lights[i].joint})
      EXPECT_EQ(after.skeleton.parents.at(joint), i == 0 ? kNone : 0u);
  }
}

TEST(export_parts, texture_coordinates_that_morph) {
  Scene scene = face_scene();
  Primitive& face = scene.meshes[0].primitives[0];
  face.texcoords = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
  for (MorphTarget& target : face.morphs.targets) target.texcoords.resize(2);
  face.morphs.targets[0].texcoords[1] = {{0, 3}, {{0.5f, 0.25f}, {0.0f, -0.5f}}};
  finish_scene(scene);
  const Json file = split_glb(*export_glb(scene)).json;
  const Json& targets = file["meshes"][0]["primitives"][0]["targets"];
  EXPECT_TRUE(targets[0].contains("TEXCOORD_1"));
  EXPECT_FALSE(targets[0].contains("TEXCOORD_0"));
  const ImportedFile after = round_trip(scene, false);
  const auto& moved = after.scene.meshes[0].primitives[0].morphs.targets[0].texcoords;
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[1].vertices, (std::vector<std::uint32_t>{0, 3}));
  EXPECT_EQ(moved[1].deltas, face.morphs.targets[0].texcoords[1].deltas);
}

TEST(export_parts, the_root_of_a_skin_and_the_scene_that_is_shown) {
  Scene scene = arm_scene();
  scene.skins.at(0).skeleton_root = 1;
  scene.scenes = {{"first", {0}}, {"second", {0}}};
  scene.default_scene = 1;
  finish_scene(scene);
  expect_equal(scene, round_trip(scene, false).scene);
}

TEST(export_parts, positions_of_a_target_have_bounds_also_where_it_moves_none) {
  Scene scene = face_scene();
  scene.meshes[0].primitives[0].morphs.targets[1].positions = {};
  finish_scene(scene);
  const Json file = split_glb(*export_glb(scene)).json;
  const std::size_t still = file["meshes"][0]["primitives"][0]["targets"][1]["POSITION"];
  EXPECT_EQ(file["accessors"][still].value("min", Json()), (Json{0.0, 0.0, 0.0}));
  EXPECT_EQ(file["accessors"][still].value("max", Json()), (Json{0.0, 0.0, 0.0}));
}

TEST(export_parts, bounds_of_a_target_are_those_of_all_its_vertices) {
  Scene scene = face_scene();
  scene.meshes[0].primitives[0].morphs.targets[1].positions = {{0, 1, 2}, {{1, 2, 3}, {4, 3, 2}, {2, 5, 4}}};
  finish_scene(scene);
  const Json file = split_glb(*export_glb(scene)).json;
  const std::size_t moved = file["meshes"][0]["primitives"][0]["targets"][1]["POSITION"];
  EXPECT_FALSE(file["accessors"][moved].contains("sparse"));
  EXPECT_EQ(file["accessors"][moved]["min"], (Json{0.0, 0.0, 0.0})) << "the last vertex stays";
  EXPECT_EQ(file["accessors"][moved]["max"], (Json{4.0, 5.0, 4.0}));
}

TEST(export_parts, a_primitive_that_shows_nothing_has_as_many_targets_as_the_others) {
  Scene scene = face_scene();
  Primitive nothing;
  nothing.morphs.targets.resize(2);
  scene.meshes[0].primitives.push_back(nothing);
  finish_scene(scene);
  const Json file = split_glb(*export_glb(scene)).json;
  for (const Json& primitive : file["meshes"][0]["primitives"]) EXPECT_EQ(primitive["targets"].size(), 2u);
}

TEST(export_parts, factors_of_emission_are_at_most_one) {
  for (const float largest : {1.0f, 1.25f, 2.0f, 3.0f}) {
    Scene scene = prop_scene();
    Material& material = scene.materials.emplace_back();
    material.emissive = {0.5f, largest, 0.25f};
    material.emissive_strength = 1.5f;
    const Json written = split_glb(*export_glb(scene)).json["materials"].back();
    const double strength = written["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
    EXPECT_LE(written["emissiveFactor"][1], 1.0) << largest;
    EXPECT_EQ(strength * written["emissiveFactor"][1].get<double>(), 1.5 * static_cast<double>(largest));
    EXPECT_EQ(strength * written["emissiveFactor"][0].get<double>(), 0.75);
  }
}

TEST(export_parts, encoded_images_stay_as_they_are_where_a_file_may_have_them) {
  Scene scene = prop_scene();
  for (const char* type : {"image/webp", "image/jpeg", "image/webp", "image/tiff"}) {
    add_texture(scene);
    scene.images.back().mime_type = type;
    scene.images.back().encoded.assign(5, std::byte{7});
  }
  add_texture(scene);
  scene.images.back() = {.name = "missing", .width = 0, .height = 0, .rgba = {}, .missing_reason = "not there"};
  const GlbParts parts = split_glb(*export_glb(scene));
  const Json& file = parts.json;
  std::vector<std::string> types;
  for (const Json& image : file["images"]) types.push_back(image["mimeType"]);
  EXPECT_THAT(types, testing::ElementsAre("image/webp", "image/jpeg", "image/webp", "image/png", "image/png"));
  const auto bytes_of = [&](std::size_t image) { return parts.view(file["images"][image]["bufferView"]); };
  for (const std::size_t kept : {0u, 1u, 2u}) EXPECT_EQ(bytes_of(kept), scene.images[kept].encoded);
  for (const std::size_t png : {3u, 4u})  // one pixel each; width and height follow "IHDR"
    EXPECT_TRUE(bytes_of(png).at(19) == std::byte{1} && bytes_of(png).at(23) == std::byte{1}) << png;
  EXPECT_EQ(file["extensionsRequired"], Json{"EXT_texture_webp"});
  EXPECT_EQ(file["textures"][0]["extensions"]["EXT_texture_webp"]["source"], 0);
  EXPECT_EQ(file["textures"][1]["source"], 1);
}

TEST(export_parts, variants_of_the_second_primitive_alone) {
  Scene scene = face_scene();
  scene.materials.resize(2);
  scene.variants = {"day", "night"};
  Primitive& second = scene.meshes[0].primitives.emplace_back(scene.meshes[0].primitives[0]);
  second.variant_materials = {{0, 1}, {1, 0}};
  finish_scene(scene);
  const Json primitives = split_glb(*export_glb(scene)).json["meshes"][0]["primitives"];
  EXPECT_FALSE(primitives[0].contains("extensions"));
  EXPECT_EQ(primitives[1]["extensions"]["KHR_materials_variants"]["mappings"].size(), 2u);
  expect_equal(scene, round_trip(scene, false).scene);
}

TEST(export_parts, the_copyright_that_is_given) {
  const auto asset_of = [](const ExportOptions& options) {
    return split_glb(*export_glb(face_scene(), options)).json["asset"];
  };
  EXPECT_EQ(asset_of({.copyright = "2026 somebody"})["copyright"], "2026 somebody");
  EXPECT_FALSE(asset_of({}).contains("copyright"));
}

TEST(export_parts, flat_normals_are_made_by_who_reads_the_file) {
  Scene scene = face_scene();
  scene.meshes[0].primitives[0].flat_normals = true;
  const Json file = split_glb(*export_glb(scene)).json;
  const Json& primitive = file["meshes"][0]["primitives"][0];
  EXPECT_FALSE(primitive["attributes"].contains("NORMAL"));
  for (const Json& target : primitive["targets"]) EXPECT_FALSE(target.contains("NORMAL"));
}

}  // namespace
}  // namespace sinew::test
