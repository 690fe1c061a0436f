// SPDX-License-Identifier: MIT
#include "importer/read/material_layers.h"

#include <gmock/gmock.h>
#include <array>

#include <gtest/gtest.h>

namespace sinew {
namespace {

using gltf::Json;
using testing::IsEmpty;

/// The layers read from a material's extensions, and the warnings as "rule at location".
struct LayerReading {
  Material material;
  std::vector<std::string> warnings;
};

LayerReading read_layers(const char* extensions, std::size_t texture_count = 8) {
  IssueLog log;
  LayerReading out;
  read_material_layers(Json::parse(extensions), "/materials/0", texture_count, out.material, log);
  for (const auto& warning : log.take_warnings()) out.warnings.push_back(warning.rule + " at " + warning.json_pointer);
  return out;
}

void expect_use(const TextureUse& use, std::uint32_t texture, std::uint32_t texcoord) {
  EXPECT_EQ(use.texture, texture);
  EXPECT_EQ(use.texcoord, texcoord);
}

TEST(material_layers, of_a_plain_material_change_nothing) {
  const auto [m, warnings] = read_layers("{}");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_FALSE(m.specular.has_effect());
  EXPECT_EQ(m.specular.ior, 1.5f);
  EXPECT_EQ(m.specular.factor, 1.0f);
  EXPECT_EQ(m.specular.color, glm::vec3(1.0f));
  EXPECT_EQ(m.clearcoat.factor, 0.0f);
  EXPECT_EQ(m.clearcoat.roughness, 0.0f);
  EXPECT_EQ(m.sheen.color, glm::vec3(0.0f));
  EXPECT_EQ(m.transmission.factor, 0.0f);
  for (const TextureUse* use : texture_uses(m)) EXPECT_FALSE(use->used());
}

TEST(material_layers, keep_every_value_of_specular_and_ior) {
  const auto [m, warnings] = read_layers(R"({"KHR_materials_ior": {"ior": 1.75}, "KHR_materials_specular":
      {"specularFactor": 0.25, "specularTexture": {"index": 1, "texCoord": 1},
       "specularColorFactor": [0.5, 2, 0], "specularColorTexture": {"index": 2}}})");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_TRUE(m.specular.has_effect());
  EXPECT_EQ(m.specular.ior, 1.75f);
  EXPECT_EQ(m.specular.factor, 0.25f);
  EXPECT_EQ(m.specular.color, glm::vec3(0.5f, 2.0f, 0.0f));
  expect_use(m.specular.texture, 1, 1);
  expect_use(m.specular.color_texture, 2, 0);
}

TEST(material_layers, keep_every_value_of_clearcoat_and_its_normal_map) {
  const auto [m, warnings] = read_layers(R"({"KHR_materials_clearcoat":
      {"clearcoatFactor": 0.5, "clearcoatTexture": {"index": 1}, "clearcoatRoughnessFactor": 0.25,
       "clearcoatRoughnessTexture": {"index": 2, "texCoord": 1},
       "clearcoatNormalTexture": {"index": 3, "scale": -2, "extensions": {"KHR_texture_transform":
           {"offset": [0.5, 1], "rotation": 1.5, "scale": [2, 3], "texCoord": 1}}}}})");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.clearcoat.factor, 0.5f);
  EXPECT_EQ(m.clearcoat.roughness, 0.25f);
  EXPECT_EQ(m.clearcoat.normal_scale, -2.0f);
  expect_use(m.clearcoat.texture, 1, 0);
  expect_use(m.clearcoat.roughness_texture, 2, 1);
  expect_use(m.clearcoat.normal_texture, 3, 1);
  EXPECT_EQ(m.clearcoat.normal_texture.offset, glm::vec2(0.5f, 1.0f));
  EXPECT_EQ(m.clearcoat.normal_texture.rotation_rad, 1.5f);
  EXPECT_EQ(m.clearcoat.normal_texture.scale, glm::vec2(2.0f, 3.0f));
}

TEST(material_layers, keep_every_value_of_sheen_and_transmission) {
  const auto [m, warnings] = read_layers(R"({"KHR_materials_sheen":
      {"sheenColorFactor": [0.25, 0.5, 1], "sheenColorTexture": {"index": 4, "texCoord": 1},
       "sheenRoughnessFactor": 0.75, "sheenRoughnessTexture": {"index": 5}},
      "KHR_materials_transmission": {"transmissionFactor": 0.5, "transmissionTexture": {"index": 6, "texCoord": 1}}})");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.sheen.color, glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(m.sheen.roughness, 0.75f);
  expect_use(m.sheen.color_texture, 4, 1);
  expect_use(m.sheen.roughness_texture, 5, 0);
  EXPECT_EQ(m.transmission.factor, 0.5f);
  expect_use(m.transmission.texture, 6, 1);
}

TEST(material_layers, keep_every_value_of_iridescence_anisotropy_and_volume) {
  const auto [m, warnings] = read_layers(R"({"KHR_materials_iridescence": {"iridescenceFactor": 0.5,
        "iridescenceTexture": {"index": 1}, "iridescenceIor": 1.75, "iridescenceThicknessMinimum": 50,
        "iridescenceThicknessMaximum": 300, "iridescenceThicknessTexture": {"index": 2, "texCoord": 1}},
      "KHR_materials_anisotropy": {"anisotropyStrength": 0.25, "anisotropyRotation": 1.5,
        "anisotropyTexture": {"index": 3}},
      "KHR_materials_volume": {"thicknessFactor": 0.125, "thicknessTexture": {"index": 4, "texCoord": 1},
        "attenuationDistance": 2, "attenuationColor": [0.5, 1, 0.25]}})");
  EXPECT_THAT(warnings, IsEmpty());
  const Iridescence& i = m.iridescence;
  EXPECT_THAT((std::array{i.factor, i.ior, i.thinnest_nm, i.thickest_nm}),
              testing::ElementsAre(0.5f, 1.75f, 50.0f, 300.0f));
  EXPECT_THAT((std::array{m.anisotropy.strength, m.anisotropy.rotation_rad}), testing::ElementsAre(0.25f, 1.5f));
  EXPECT_THAT((std::array{m.volume.thickness_m, m.volume.attenuation_distance_m}), testing::ElementsAre(0.125f, 2.0f));
  EXPECT_EQ(m.volume.attenuation_color, glm::vec3(0.5f, 1.0f, 0.25f));
  expect_use(i.texture, 1, 0);
  expect_use(i.thickness_texture, 2, 1);
  expect_use(m.anisotropy.texture, 3, 0);
  expect_use(m.volume.texture, 4, 1);
}

TEST(material_layers, outside_their_range_take_the_default_and_are_named) {
  const auto [m, warnings] = read_layers(R"({"KHR_materials_ior": {"ior": 0.5},
      "KHR_materials_specular": {"specularFactor": 2, "specularColorFactor": [1, -1, 1], "specularTexture": {"index": 8}},
      "KHR_materials_clearcoat": {"clearcoatFactor": -1, "clearcoatRoughnessFactor": 1.5},
      "KHR_materials_sheen": {"sheenColorFactor": [2, 0, 0], "sheenRoughnessFactor": "rough"},
      "KHR_materials_transmission": {"transmissionFactor": 1.25},
      "KHR_materials_iridescence": {"iridescenceIor": 0.5, "iridescenceThicknessMaximum": -1},
      "KHR_materials_anisotropy": {"anisotropyStrength": 2}, "KHR_materials_volume": {"thicknessFactor": -1}})");
  EXPECT_EQ(m.specular.ior, 1.5f);
  EXPECT_FALSE(m.specular.has_effect());
  EXPECT_EQ(m.clearcoat.factor, 0.0f);
  EXPECT_EQ(m.sheen.color, glm::vec3(0.0f));
  const std::string at = "extension-value at /materials/0/extensions/KHR_materials_";
  EXPECT_THAT(warnings, testing::UnorderedElementsAre(
                            at + "ior/ior", at + "specular/specularFactor", at + "specular/specularColorFactor",
                            at + "specular/specularTexture/index", at + "clearcoat/clearcoatFactor",
                            at + "clearcoat/clearcoatRoughnessFactor", at + "sheen/sheenColorFactor",
                            at + "sheen/sheenRoughnessFactor", at + "transmission/transmissionFactor",
                            at + "iridescence/iridescenceIor", at + "iridescence/iridescenceThicknessMaximum",
                            at + "anisotropy/anisotropyStrength", at + "volume/thicknessFactor"));
}

TEST(material_layers, index_of_refraction_0_and_1_are_kept) {
  for (const char* ior : {"0", "1", "1.0", "3"}) {
    const auto [m, warnings] = read_layers((R"({"KHR_materials_ior": {"ior": )" + std::string(ior) + "}}").c_str());
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(m.specular.ior, std::stof(ior));
  }
}

}  // namespace
}  // namespace sinew
