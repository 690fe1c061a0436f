// SPDX-License-Identifier: MIT
#include "importer/export_glb.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "importer/import_gltf.h"
#include "importer/topology/gather_vertices.h"
#include "samples/showcase/showcase.h"
#include "tests/importer/rewritten.h"
#include "tests/support/corpus.h"
#include "tests/support/scene_equality.h"

namespace sinew {
namespace {

using test::Json;
using test::split_glb;

ImportedFile round_trip(const Scene& scene) {
  const auto bytes = export_glb(scene);
  if (!bytes) throw std::runtime_error(describe("scene", bytes.error().issue));
  auto file = import_gltf(*bytes, "round-trip.glb");
  if (!file) throw std::runtime_error(describe("round-trip.glb", file.error().issue));
  return *std::move(file);
}

/// A scene made in code, with its vertices in the order that the importer gave them after a round trip.
Scene in_order_of(const Scene& imported, Scene made) {
  for (std::size_t m = 0; m < made.meshes.size(); ++m)
    for (std::size_t p = 0; p < made.meshes[m].primitives.size(); ++p) {
      Primitive& primitive = made.meshes[m].primitives[p];
      const std::vector<std::uint32_t>& place_in_file = imported.meshes.at(m).primitives.at(p).source_vertex;
      std::vector<std::uint32_t> vertex_at(primitive.vertex_count()), order;
      for (std::uint32_t v = 0; v < vertex_at.size(); ++v)
        vertex_at[primitive.source_vertex.empty() ? v : primitive.source_vertex[v]] = v;
      for (const std::uint32_t place : place_in_file) order.push_back(vertex_at.at(place));
      if (!order.empty()) permute_vertices(primitive, order);
    }
  return made;
}

constexpr std::byte kCache[1] = {};  // the content does not matter: with a cache, the showcase includes the flag

class ExportedShowcase : public testing::TestWithParam<std::size_t> {};

TEST_P(ExportedShowcase, comes_back_bit_equal) {
  const auto scenes = showcase::showcase(kCache);
  const Scene& before = scenes[GetParam()].scene;
  const ImportedFile after = round_trip(before);
  for (const auto& warning : after.warnings) ADD_FAILURE() << describe("round-trip.glb", warning);
  test::expect_equal(in_order_of(after.scene, before), after.scene);
}

TEST_P(ExportedShowcase, second_trip_writes_the_same_bytes) {
  const auto scenes = showcase::showcase(kCache);
  const auto once = export_glb(round_trip(scenes[GetParam()].scene).scene);
  const auto twice = export_glb(round_trip(round_trip(scenes[GetParam()].scene).scene).scene);
  ASSERT_TRUE(once && twice);
  EXPECT_TRUE(*once == *twice);
}

INSTANTIATE_TEST_SUITE_P(scenes, ExportedShowcase, testing::Range<std::size_t>(0, 4));

/// A joint with every property of a node, and a material with all its parts.
Scene rich_scene() {
  auto scenes = showcase::showcase();
  Scene scene = std::move(scenes[1].scene);
  Image image{"checker", 2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 128, 9, 8, 7, 6}, ""};
  scene.images.push_back(image);
  scene.textures.push_back(
      {0, {Filter::nearest, Filter::linear, Filter::nearest, true, Wrap::clamp_to_edge, Wrap::mirrored_repeat}});
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives)
      primitive.texcoords.assign(2, std::vector<glm::vec2>(primitive.vertex_count(), {0.5f, 0.25f}));
  Material& material = scene.materials[0];
  material.base_color_texture.texture = 0;
  material.base_color_texture.texcoord = 1;
  material.base_color_texture.offset = {0.25f, 0.5f};
  material.base_color_texture.rotation_rad = 0.125f;
  material.base_color_texture.scale = {2.0f, 3.0f};
  material.alpha_mode = AlphaMode::mask;
  material.alpha_cutoff = 0.25f;
  material.double_sided = true;
  material.emissive = {1.0f, 0.5f, 0.25f};
  material.emissive_strength = 2.0f;
  material.specular = {1.25f, 0.5f, {0, 1}, {2.0f, 0.5f, 1.0f}, {0, 0, {0.5f, 0.25f}, 0.75f}};
  material.clearcoat = {0.75f, {0, 1}, 0.25f, {0, 0, {0.0f, 0.5f}}, {0, 1}, -2.0f};
  material.sheen = {{0.5f, 0.25f, 1.0f}, {0, 1}, 0.625f, {0, 0, {0.0f, 0.0f}, 0.0f, {2.0f, 1.0f}}};
  material.transmission = {0.375f, {0, 1}};
  Camera camera;
  camera.name = "eye";
  camera.joint = 0;
  camera.fov_y_rad = 0.5f;
  camera.aspect = 1.5f;
  camera.near_m = 0.25f;
  camera.far_m = 64.0f;
  scene.cameras.push_back(camera);
  Light light;
  light.name = "sun";
  light.kind = Light::Kind::spot;
  light.joint = 1;
  light.intensity = 4.0f;
  light.range_m = 8.0f;
  light.inner_cone_rad = 0.25f;
  light.outer_cone_rad = 0.5f;
  scene.lights.push_back(light);
  finish_scene(scene);
  return scene;
}

TEST(export_glb, positions_have_bounds_those_of_morph_targets_too) {
  Scene scene = std::move(showcase::showcase()[1].scene);
  Primitive& primitive = scene.meshes[0].primitives[0];
  primitive.morphs.targets.resize(1);
  primitive.morphs.targets[0].positions = {{0, 2}, {glm::vec3(1, -2, 0), glm::vec3(0.5f, 0, -3)}};
  finish_scene(scene);
  const auto bytes = export_glb(scene);
  ASSERT_TRUE(bytes);
  const Json file = split_glb(*bytes).json;
  const Json& written = file["meshes"][0]["primitives"][0];
  const Json& moved = file["accessors"][written["targets"][0]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(moved["min"], Json::array({0.0, -2.0, -3.0}));
  EXPECT_EQ(moved["max"], Json::array({1.0, 0.0, 0.0}));
  EXPECT_TRUE(file["accessors"][written["attributes"]["POSITION"].get<std::size_t>()].contains("max"));
}

TEST(export_glb, keeps_materials_images_cameras_and_lights) {
  const Scene before = rich_scene();
  const ImportedFile after = round_trip(before);
  test::expect_equal(in_order_of(after.scene, before), after.scene);
}

TEST(export_glb, keeps_animated_properties_visibility_copies_and_variants) {
  Scene before = rich_scene();
  before.hidden_joints = {1};
  before.variants = {"day", "night"};
  before.materials.push_back({});
  before.meshes[0].primitives[0].variant_materials = {{1, static_cast<std::uint32_t>(before.materials.size() - 1)}};
  ASSERT_EQ(before.instances[0].skin, kNone);
  before.instances[0].copies = {{{1, 2, 3}, glm::quat(0, 1, 0, 0), {1, -1, 2}},
                                {{4, 5, 6}, glm::quat(1, 0, 0, 0), {1, 1, 1}}};
  const auto track = [](Interpolation interpolation, std::uint32_t components) {
    WeightTrack out{interpolation, {0.0f, 0.5f}, {}, components};
    for (std::uint32_t i = 0; i < 2 * components; ++i)
      out.values.push_back(interpolation == Interpolation::step ? static_cast<float>(i % 2)
                                                                : 0.25f * static_cast<float>(i));
    return out;
  };
  const auto linear = Interpolation::linear;
  before.animations[0].properties = {{{PropertyKind::node_visible, 0}, track(Interpolation::step, 1)},
                                     {{PropertyKind::node_visible, 1}, track(Interpolation::step, 1)},
                                     {{PropertyKind::camera_fov_y, 0}, track(linear, 1)},
                                     {{PropertyKind::light_color, 0}, track(linear, 3)},
                                     {{PropertyKind::base_color, 0}, track(linear, 4)},
                                     {{PropertyKind::emissive_strength, 0}, track(linear, 1)},
                                     {{PropertyKind::emissive_strength, 1}, track(linear, 1)},
                                     {{PropertyKind::texture_scale, 0, TextureSlot::base_color}, track(linear, 2)}};
  finish_scene(before);
  ASSERT_EQ(check(before), ErrorCode::ok);
  const ImportedFile after = round_trip(before);
  for (const auto& warning : after.warnings) ADD_FAILURE() << describe("round-trip.glb", warning);
  test::expect_equal(in_order_of(after.scene, before), after.scene);
}

TEST(export_glb, has_bounds_of_positions_and_times_alone) {
  const auto bytes = export_glb(showcase::showcase()[0].scene);
  ASSERT_TRUE(bytes);
  const Json root = split_glb(*bytes).json;
  std::set<std::size_t> bounded;
  for (const Json& mesh : root["meshes"])
    for (const Json& primitive : mesh["primitives"]) {
      bounded.insert(primitive["attributes"]["POSITION"].get<std::size_t>());
      for (const Json& target : primitive.value("targets", Json::array()))
        if (target.contains("POSITION")) bounded.insert(target["POSITION"].get<std::size_t>());
    }
  for (const Json& animation : root["animations"])
    for (const Json& sampler : animation["samplers"]) bounded.insert(sampler["input"].get<std::size_t>());
  for (std::size_t a = 0; a < root["accessors"].size(); ++a)
    EXPECT_EQ(root["accessors"][a].contains("min"), bounded.contains(a)) << a;
}

TEST(export_glb, an_animation_without_tracks_keeps_its_place) {
  Scene scene = std::move(showcase::showcase()[1].scene);
  scene.animations.insert(scene.animations.begin(), Animation{"nothing", 0.0, {}, {}, {}});
  finish_scene(scene);
  const ImportedFile after = round_trip(scene);
  ASSERT_EQ(after.scene.animations.size(), scene.animations.size());
  EXPECT_EQ(after.scene.animations[0].name, "nothing");
  EXPECT_TRUE(after.scene.animations[0].bones.empty() && after.scene.animations[0].weights.empty());
  ASSERT_GT(after.scene.animations.size(), 1u);
  EXPECT_EQ(after.scene.animations[1].name, scene.animations[1].name);
}

TEST(export_glb, refuses_squad_which_gltf_cannot_say) {
  auto scenes = showcase::showcase();
  scenes[0].scene.animations[0].bones[0].rotation.interpolation = Interpolation::squad;
  const auto bytes = export_glb(scenes[0].scene);
  ASSERT_FALSE(bytes.has_value());
  EXPECT_EQ(bytes.error().issue.rule, "squad-in-gltf");
  EXPECT_EQ(bytes.error().issue.json_pointer, "/animations/0");
}

/// Import options that `sinew convert` uses.
ImportOptions as_converted() {
  ImportOptions options;
  options.keep_encoded_images = true;
  return options;
}

/// Vertices keep the numbers of their file, except those that were split because their tangents differ.
void expect_same_vertex_numbers(const Scene& before, const Scene& after) {
  for (std::size_t m = 0; m < before.meshes.size(); ++m)
    for (std::size_t p = 0; p < before.meshes[m].primitives.size(); ++p) {
      const Primitive& primitive = before.meshes[m].primitives[p];
      if (primitive.tangents.empty()) {
        EXPECT_EQ(primitive.source_vertex, after.meshes[m].primitives[p].source_vertex);
      }
    }
}

TEST(export_corpus, every_model_comes_back_bit_equal) {
  std::size_t equal = 0;
  for (const auto& path : test::files_for_tests("models", {".gltf", ".glb"})) {
    SCOPED_TRACE(path.string());
    auto before = import_gltf(path, as_converted());
    if (!before) continue;  // import_corpus_test checks refusals
    for (Image& image : before->scene.images)
      if (image.rgba.empty()) {
        image.width = image.height = 1;
        image.rgba = {255, 0, 255, 255};
      }  // a missing image is written as one pixel
    const ImportedFile after = round_trip(before->scene);
    test::expect_equal(before->scene, after.scene);
    expect_same_vertex_numbers(before->scene, after.scene);
    ++equal;
  }
  EXPECT_GT(equal, 0u);
}

TEST(export_glb, says_when_the_file_cannot_be_written) {
  const auto scenes = showcase::showcase();
  const auto written = export_glb(scenes[0].scene, "/nonexistent-folder/out.glb");
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().issue.rule, "write-file");
}

TEST(export_glb, G24_writes_few_displacements_sparse) {
  const auto scenes = showcase::showcase();
  const auto bytes = export_glb(scenes[2].scene);
  ASSERT_TRUE(bytes.has_value());
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  EXPECT_NE(text.find("\"sparse\""), std::string_view::npos);
}

TEST(export_glb, G24_targets_that_move_nothing_take_no_bytes) {
  auto scenes = showcase::showcase();
  Scene& scene = scenes[0].scene;
  const auto bare = export_glb(scene);
  Mesh& mesh = scene.meshes[0];
  mesh.default_weights.resize(100, 0.0f);
  for (Primitive& primitive : mesh.primitives) primitive.morphs.targets.resize(100);
  for (MeshInstance& instance : scene.instances)
    if (instance.mesh == 0) instance.rest_weights.resize(100, 0.0f);
  finish_scene(scene);
  const auto bytes = export_glb(scene);
  ASSERT_TRUE(bare && bytes);
  EXPECT_LT(bytes->size() - bare->size(), 100 * mesh.primitives.size() * 160u) << "an entry of JSON for each";
  test::expect_equal(scene, round_trip(scene).scene);
}

TEST(export_glb, a_primitive_without_elements_comes_back_without_any) {
  for (const Topology topology : {Topology::points, Topology::lines, Topology::triangles}) {
    auto scenes = showcase::showcase();
    Scene& scene = scenes[0].scene;
    Primitive& primitive = scene.meshes[0].primitives[0];
    primitive.topology = topology;
    primitive.indices.clear();
    finish_scene(scene);
    const Scene after = round_trip(scene).scene;
    ASSERT_FALSE(after.meshes.empty());
    const Primitive& written = after.meshes[0].primitives[0];
    EXPECT_TRUE(written.indices.empty()) << "one index would be a point";
    EXPECT_EQ(written.positions.empty(), topology == Topology::points) << "vertices are kept where nothing shows them";
  }
}

TEST(export_glb, writes_what_gltf_demands_of_skins_and_cameras) {
  auto scenes = showcase::showcase();
  Scene& scene = scenes[0].scene;
  scene.skins.emplace_back();
  Camera flat;
  flat.perspective = false;
  flat.near_m = 1.0f;
  scene.cameras.push_back(flat);
  const auto after = round_trip(scene).scene;
  EXPECT_EQ(after.skins.back().joints.size(), 1u);
  const auto bytes = export_glb(scene);
  ASSERT_TRUE(bytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  EXPECT_NE(text.find("\"zfar\":10001.0"), std::string_view::npos);
}

}  // namespace
}  // namespace sinew
