// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "tests/importer/tiny_gltf.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kAttributes = "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes";

/// A triangle with three instances.
TinyGltf instanced() {
  TinyGltf file;
  file.add_triangle();
  const Json attributes = {{"TRANSLATION", file.vec3({0, 0, 0, 1, 2, 3, -1, 0, 0})},
                           {"ROTATION", file.add(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 32767, 0, 0, 0, 0, 0},
                                                 "VEC4", 5122, 4, true)},
                           {"SCALE", file.vec3({1, 1, 1, 2, 2, 2, -1, 1, 1})},
                           {"_ID", file.scalars({4, 5, 6})}};
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
  file.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  return file;
}

TEST(extensions, instances_of_a_node_are_copies_of_its_mesh) {
  const auto result = instanced().import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.instances, SizeIs(1));
  const auto& copies = result->scene.instances[0].copies;
  ASSERT_THAT(copies, SizeIs(3));
  EXPECT_EQ(copies[1], (Transform{{1, 2, 3}, glm::quat(0, 0, 0, 1), {2, 2, 2}}));
  EXPECT_EQ(copies[2].rotation, glm::quat(1, 0, 0, 0));
  EXPECT_EQ(copies[2].scale, glm::vec3(-1, 1, 1));
  EXPECT_TRUE(warns(result, "rotation-zero", std::string(kAttributes) + "/ROTATION"));
}

TEST(extensions, attributes_of_instances_have_one_shape) {
  const auto with = [](const char* name, auto make) {
    TinyGltf file = instanced();
    file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"][name] = make(file);
    return outcome(file.import());
  };
  const std::string place = std::string(" at ") + kAttributes;
  EXPECT_EQ(with("TRANSLATION",
                 [](TinyGltf& f) {
                   return f.vec3({0, 0, 0});
                 }),
            "instancing-attributes" + place + "/TRANSLATION");
  EXPECT_EQ(with("TRANSLATION",
                 [](TinyGltf& f) {
                   return f.scalars({0, 0, 0});
                 }),
            "instancing-attributes" + place + "/TRANSLATION");
  EXPECT_EQ(with("SCALE", [](TinyGltf& f) { return f.add(std::vector<std::int16_t>(9), "VEC3", 5122, 3, true); }),
            "instancing-attributes" + place + "/SCALE");
  EXPECT_EQ(with("ROTATION", [](TinyGltf& f) { return f.add(std::vector<std::int16_t>(12), "VEC4", 5122, 4); }),
            "instancing-attributes" + place + "/ROTATION")
      << "integers that are not normalised";
  EXPECT_EQ(with("ROTATION", [](TinyGltf& f) { return f.add(std::vector<std::uint16_t>(12), "VEC4", 5123, 4, true); }),
            "instancing-attributes" + place + "/ROTATION");
  EXPECT_EQ(with("COLOR_0", [](TinyGltf& f) { return f.vec3(std::vector<float>(9)); }),
            "instancing-attributes" + place + "/COLOR_0");
  EXPECT_EQ(with("SCALE", [](TinyGltf&) { return 99; }), "reference" + place + "/SCALE");
  EXPECT_EQ(with("SCALE",
                 [](TinyGltf& f) {
                   return f.vec3({1, 1, 1, 1, 1, std::numeric_limits<float>::infinity(), 1, 1, 1});
                 }),
            "not-finite" + place + "/SCALE");
}

TEST(extensions, a_skinned_mesh_is_not_instanced) {
  TinyGltf file;
  file.add_skinned_triangle(std::vector<std::uint8_t>(12, 0), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const std::size_t translation = file.vec3({0, 0, 0, 1, 2, 3});
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = translation;
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "instancing-skin", "/nodes/0/extensions/EXT_mesh_gpu_instancing"));
  EXPECT_THAT(result->scene.instances[0].copies, IsEmpty());
}

TEST(extensions, G68_instances_without_bytes_are_within_the_budget) {
  TinyGltf file = instanced();
  file.root["accessors"].push_back({{"componentType", 5126}, {"count", 1u << 30}, {"type", "VEC3"}});
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"SCALE", file.root["accessors"].size() - 1}};
  EXPECT_EQ(outcome(file.import()), "memory-budget at ");
}

TEST(extensions, hidden_nodes_are_known) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object(),
                                    {{"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}},
                                    {{"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}},
                                    {{"extensions", {{"KHR_node_visibility", {{"visible", 0}}}}}}});
  file.root["extensionsRequired"] = {"KHR_node_visibility"};
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->scene.hidden_joints, ElementsAre(1));
  EXPECT_TRUE(warns(result, "extension-value", "/nodes/3/extensions/KHR_node_visibility/visible"));
}

TEST(extensions, variants_name_other_materials) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["material"] = 0;
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = Json::array({{{"material", 2}, {"variants", {2, 0}}},
                                                                               {{"material", 1}, {"variants", {2}}},
                                                                               {{"material", 9}, {"variants", {1}}},
                                                                               {{"material", 1}, {"variants", {3}}},
                                                                               5});
  file.root["materials"] = Json::array({Json::object(), Json::object(), Json::object()});
  file.root["extensions"]["KHR_materials_variants"]["variants"] =
      Json::array({{{"name", "red"}}, {{"name", "blue"}}, {{"name", "old"}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->scene.variants, ElementsAre("red", "blue", "old"));
  const Primitive& shown = result->scene.meshes[0].primitives[0];
  EXPECT_THAT(shown.variant_materials, ElementsAre(VariantMaterial{0, 2}, VariantMaterial{2, 2}));
  EXPECT_EQ(material_of(shown, 0), 2u);
  EXPECT_EQ(material_of(shown, 1), 0u);
  EXPECT_EQ(material_of(shown, kNone), 0u);
  for (const char* m : {"2", "3", "4"})
    EXPECT_TRUE(warns(result, "extension-value",
                      std::string("/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/") + m))
        << m;
}

TEST(extensions, the_first_variant_with_a_normal_map_has_its_tangents_made) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
  primitive["attributes"]["TEXCOORD_0"] = file.add(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 2);
  primitive["material"] = 0;
  const Json mapped = Json::array({{{"material", 0}, {"variants", {0}}}, {{"material", 1}, {"variants", {1}}}});
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = mapped;
  file.root["materials"] = Json::array({Json::object(), {{"normalTexture", {{"index", 0}}}}});
  file.root["textures"] = Json::array({Json::object()});
  file.root["extensions"]["KHR_materials_variants"]["variants"] = Json::array({{{"name", "a"}}, {{"name", "b"}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->scene.meshes[0].primitives[0].tangents, SizeIs(3));
}

TEST(extensions, G57_what_only_refines_surfaces_is_read_past) {
  for (const char* name :
       {"KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_transmission", "KHR_materials_volume",
        "KHR_materials_ior", "KHR_materials_specular", "KHR_materials_iridescence", "KHR_materials_anisotropy",
        "KHR_materials_dispersion", "KHR_materials_variants", "KHR_materials_unlit"}) {
    TinyGltf file;
    file.root["extensionsUsed"] = file.root["extensionsRequired"] = {name};
    file.root["materials"] = Json::array({{{"extensions", {{name, {{"anyFactor", 0.5}}}}}}});
    const auto result = file.import();
    EXPECT_EQ(outcome(result), "ok") << name;
    EXPECT_THAT(result->facts.extensions_required, ElementsAre(name));
  }
}

TEST(extensions, T10_numbers_of_the_document_are_rounded_once) {
  FixedRandom random(3);
  for (int i = 0; i < 50; ++i) {
    const auto x =
        static_cast<float>(random.in(-1.0, 1.0)) * std::pow(10.0f, static_cast<float>(random.in(-20.0, 20.0)));
    char text[64];
    std::snprintf(text, sizeof text, "%.9g", static_cast<double>(x));
    const std::string json = std::string(R"({"asset":{"version":"2.0"},"nodes":[{"translation":[)") + text + ",0,0]}]}";
    const auto result = import_gltf(bytes_of(json), "x");
    ASSERT_EQ(outcome(result), "ok");
    EXPECT_EQ(result->scene.skeleton.rest[0].translation.x, x) << text;
  }
}

}  // namespace
}  // namespace sinew::test
