// SPDX-License-Identifier: MIT
#include "importer/read/materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "importer/read/textures.h"

namespace sinew {
namespace {

using gltf::Json;
using testing::IsEmpty;
using testing::SizeIs;

/// Reads one material; holds its warnings as "rule at place".
struct Reading {
  Material material;
  std::vector<std::string> warnings;
};

Reading read_one(const gltf::Material& source, std::size_t texture_count = 0) {
  gltf::Document document;
  document.materials = {source};
  document.textures.resize(texture_count);
  IssueLog log;
  Reading out;
  out.material = read_materials(document, log).at(0);
  for (const auto& warning : log.take_warnings()) out.warnings.push_back(warning.rule + " at " + warning.json_pointer);
  return out;
}

template <class Info>
void name_texture(Info& info, int index, int texcoord) {
  info.index = index;
  info.texCoord = texcoord;
}

TEST(read_materials, keep_every_value_of_a_full_material) {
  gltf::Material source;
  source.name = "steel";
  auto& surface = source.pbrMetallicRoughness;
  surface.baseColorFactor = {0.1, 0.2, 0.3, 0.4};
  surface.metallicFactor = 0.5;
  surface.roughnessFactor = 0.6;
  source.normalTexture.scale = -2.0;
  source.occlusionTexture.strength = 0.7;
  source.alphaCutoff = 0.25;
  source.alphaMode = "MASK";
  source.doubleSided = true;
  source.emissiveFactor = {0.25, 0.5, 1.0};
  name_texture(surface.baseColorTexture, 0, 1);
  name_texture(surface.metallicRoughnessTexture, 1, 2);
  name_texture(source.normalTexture, 2, 3);
  name_texture(source.occlusionTexture, 3, 4);
  name_texture(source.emissiveTexture, 4, 5);
  const auto [m, warnings] = read_one(source, 5);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.name, "steel");
  EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallic, 0.5f);
  EXPECT_EQ(m.roughness, 0.6f);
  EXPECT_EQ(m.normal_scale, -2.0f);
  EXPECT_EQ(m.occlusion_strength, 0.7f);
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.25f);
  EXPECT_TRUE(m.double_sided);
  EXPECT_FALSE(m.unlit);
  EXPECT_EQ(m.emissive, glm::vec3(0.25f, 0.5f, 1.0f));
  const TextureUse* uses[] = {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
                              &m.occlusion_texture, &m.emissive_texture};
  for (std::uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(uses[i]->texture, i);
    EXPECT_EQ(uses[i]->texcoord, i + 1);
  }
}

TEST(read_materials, of_an_empty_material_are_the_defaults_of_the_specification) {
  const auto [m, warnings] = read_one({});
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.base_color, glm::vec4(1));
  EXPECT_EQ(m.metallic, 1.0f);
  EXPECT_EQ(m.roughness, 1.0f);
  EXPECT_EQ(m.emissive, glm::vec3(0));
  EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(m.alpha_cutoff, 0.5f);
  EXPECT_FALSE(m.base_color_texture.used());
}

TEST(read_materials, clamp_factors_and_say_so) {
  gltf::Material source;
  source.pbrMetallicRoughness.baseColorFactor = {2, 0, 0, 1};
  source.pbrMetallicRoughness.metallicFactor = -1;
  source.pbrMetallicRoughness.roughnessFactor = 1.5;
  source.occlusionTexture.strength = 3;
  source.alphaCutoff = -1;
  source.emissiveFactor = {0, 0, 7};
  source.alphaMode = "GLASS";
  const auto [m, warnings] = read_one(source);
  EXPECT_EQ(m.base_color.r, 1.0f);
  EXPECT_EQ(m.metallic, 0.0f);
  EXPECT_EQ(m.roughness, 1.0f);
  EXPECT_EQ(m.occlusion_strength, 1.0f);
  EXPECT_EQ(m.alpha_cutoff, 0.0f);
  EXPECT_EQ(m.emissive.b, 1.0f);
  EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
  EXPECT_THAT(warnings, testing::UnorderedElementsAre(
                            "material-values at /materials/0/pbrMetallicRoughness/baseColorFactor",
                            "material-values at /materials/0/pbrMetallicRoughness/metallicFactor",
                            "material-values at /materials/0/pbrMetallicRoughness/roughnessFactor",
                            "material-values at /materials/0/occlusionTexture/strength",
                            "material-values at /materials/0/alphaCutoff", "material-values at /materials/0/alphaMode",
                            "material-values at /materials/0/emissiveFactor"));
}

TEST(read_materials, G60_texture_transform_has_its_own_texcoord_and_keeps_defaults) {
  gltf::Material source;
  name_texture(source.pbrMetallicRoughness.baseColorTexture, 0, 0);
  source.extensions_of(TextureSlot::base_color) = Json::parse(R"({"KHR_texture_transform":
      {"offset": [0.5, -1], "rotation": 1.5, "scale": [2, 3], "texCoord": 1}})");
  name_texture(source.normalTexture, 0, 2);
  source.extensions_of(TextureSlot::normal) = Json::parse(R"({"KHR_texture_transform": {"rotation": -0.5}})");
  const auto [m, warnings] = read_one(source, 1);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.base_color_texture.offset, glm::vec2(0.5f, -1.0f));
  EXPECT_EQ(m.base_color_texture.rotation_rad, 1.5f);
  EXPECT_EQ(m.base_color_texture.scale, glm::vec2(2, 3));
  EXPECT_EQ(m.base_color_texture.texcoord, 1u);
  EXPECT_EQ(m.normal_texture.offset, glm::vec2(0));
  EXPECT_EQ(m.normal_texture.rotation_rad, -0.5f);
  EXPECT_EQ(m.normal_texture.scale, glm::vec2(1));
  EXPECT_EQ(m.normal_texture.texcoord, 2u);
}

TEST(read_materials, take_wrong_extension_fields_as_absent) {
  gltf::Material source;
  source.extensions = Json::parse(R"({"KHR_materials_emissive_strength": {"emissiveStrength": "much"},
                                      "KHR_materials_unlit": 3})");
  source.emissiveFactor = {1, 1, 1};
  name_texture(source.pbrMetallicRoughness.baseColorTexture, 0, 0);
  source.extensions_of(TextureSlot::base_color) = Json::parse(R"({"KHR_texture_transform":
      {"offset": [1], "rotation": null, "scale": [1, "x"], "texCoord": -1}})");
  const auto [m, warnings] = read_one(source, 1);
  EXPECT_EQ(m.emissive, glm::vec3(1));
  EXPECT_FALSE(m.unlit);
  EXPECT_EQ(m.base_color_texture.offset, glm::vec2(0));
  EXPECT_EQ(m.base_color_texture.texcoord, 0u);
  const std::string texture =
      "extension-value at /materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/";
  EXPECT_THAT(warnings,
              testing::UnorderedElementsAre(
                  texture + "offset", texture + "rotation", texture + "scale", texture + "texCoord",
                  "extension-value at /materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength"))
      << "that an extension is no object is told by the shape of the document";
}

TEST(read_materials, multiply_emission_by_its_strength) {
  gltf::Material source;
  source.emissiveFactor = {0.5, 1, 0};
  source.extensions =
      Json::parse(R"({"KHR_materials_emissive_strength": {"emissiveStrength": 8}, "KHR_materials_unlit": {}})");
  const auto [m, warnings] = read_one(source);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.emissive, glm::vec3(0.5f, 1, 0));
  EXPECT_EQ(m.emissive_strength, 8.0f);
  EXPECT_TRUE(m.unlit);
}

TEST(read_materials, keep_every_value_of_specular_glossiness) {
  gltf::Material source;
  source.extensions = Json::parse(R"({"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.25, 0.125, 0.75],
      "specularFactor": [0.5, 0.25, 1], "glossinessFactor": 0.75, "diffuseTexture": {"index": 1, "texCoord": 2},
      "specularGlossinessTexture": {"index": 0, "texCoord": 1}}})");
  const auto [m, warnings] = read_one(source, 2);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.metallic, 0.0f);
  EXPECT_EQ(m.roughness, 0.25f);
  EXPECT_EQ(m.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 0.75f));
  EXPECT_EQ(m.base_color_texture.texture, 1u);
  EXPECT_EQ(m.base_color_texture.texcoord, 2u);
  EXPECT_EQ(m.specular.ior, 0.0f) << "the colour is all of the reflectance";
  EXPECT_EQ(m.specular.color, glm::vec3(0.5f, 0.25f, 1.0f));
  EXPECT_EQ(m.specular.color_texture.texture, 0u);
  EXPECT_EQ(m.specular.color_texture.texcoord, 1u);
  EXPECT_TRUE(m.specular.has_glossiness);
}

TEST(read_materials, without_a_texture_specular_glossiness_is_a_plain_specular_colour) {
  gltf::Material source;
  source.extensions = Json::parse(R"({"KHR_materials_pbrSpecularGlossiness": {}})");
  const auto [m, warnings] = read_one(source);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.roughness, 0.0f);
  EXPECT_EQ(m.specular.color, glm::vec3(1.0f));
  EXPECT_FALSE(m.specular.has_glossiness);
}

TEST(read_materials, prefer_the_files_own_metallic_roughness_version) {
  gltf::Material source;
  source.pbrMetallicRoughness.roughnessFactor = 0.5;
  source.extensions = Json::parse(R"({"KHR_materials_pbrSpecularGlossiness": {"glossinessFactor": 0.1}})");
  const auto [m, warnings] = read_one(source);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(m.roughness, 0.5f);
}

TEST(read_materials, each_part_of_metallic_roughness_is_a_version_of_the_files_own) {
  const std::function<void(tinygltf::PbrMetallicRoughness&)> parts[] = {
      [](auto& own) {
        own.baseColorFactor = {1, 1, 0.5, 1};
      },
      [](auto& own) { own.metallicFactor = 0.5; }, [](auto& own) { own.roughnessFactor = 0.5; },
      [](auto& own) { own.baseColorTexture.index = 0; }, [](auto& own) { own.metallicRoughnessTexture.index = 0; }};
  for (const auto& change : parts) {
    gltf::Material source;
    change(source.pbrMetallicRoughness);
    source.extensions = Json::parse(R"({"KHR_materials_pbrSpecularGlossiness": {"glossinessFactor": 0.125}})");
    const auto [m, warnings] = read_one(source, 1);
    EXPECT_THAT(warnings, IsEmpty()) << &change - parts;
    EXPECT_NE(m.roughness, 0.875f) << &change - parts;
  }
}

TEST(read_materials, refuse_a_specular_glossiness_texture_that_is_not_there) {
  gltf::Material source;
  source.extensions = Json::parse(R"({"KHR_materials_pbrSpecularGlossiness": {"diffuseTexture": {"index": 9}}})");
  const auto [m, warnings] = read_one(source, 2);
  EXPECT_FALSE(m.base_color_texture.used());
  EXPECT_THAT(
      warnings,
      testing::Contains(
          "extension-value at /materials/0/extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture/index"));
}

tinygltf::Sampler sampler(int magnify, int minify, int wrap_s, int wrap_t) {
  tinygltf::Sampler out;
  out.magFilter = magnify;
  out.minFilter = minify;
  out.wrapS = wrap_s;
  out.wrapT = wrap_t;
  return out;
}

gltf::Texture texture(int source, int sampler) {
  gltf::Texture out;
  out.source = source;
  out.sampler = sampler;
  return out;
}

TEST(read_materials, name_each_extension_that_is_not_read_once_at_its_first_place) {
  const char* extensions[] = {
      R"({"KHR_materials_clearcoat": {}, "KHR_materials_sheen": {}, "KHR_materials_ior": {}})",
      R"({"KHR_materials_diffuse_transmission": {}, "KHR_materials_transmission": {}})",
      R"({"KHR_materials_diffuse_transmission": {}, "A/B_wet": {}, "KHR_materials_dispersion": {}})",
      R"({"KHR_materials_diffuse_transmission": {}})"};
  gltf::Document document;
  for (const char* text : extensions) document.materials.emplace_back().extensions = Json::parse(text);
  IssueLog log;
  EXPECT_THAT(read_materials(document, log), SizeIs(4));
  std::vector<std::string> said;
  for (const auto& warning : log.take_warnings()) {
    EXPECT_EQ(warning.rule, "material-extension");
    said.push_back(warning.json_pointer + ": " + warning.detail);
  }
  const std::string is = " is not read; materials that have it: ", at = "/extensions/KHR_materials_";
  EXPECT_THAT(said, testing::UnorderedElementsAre(
                        "/materials/1" + at + "diffuse_transmission: \"KHR_materials_diffuse_transmission\"" + is + "3",
                        "/materials/2" + at + "dispersion: \"KHR_materials_dispersion\"" + is + "1",
                        "/materials/2/extensions/A~1B_wet: \"A/B_wet\"" + is + "1"));
}

TEST(read_textures, have_the_samplers_of_the_file_and_defaults_elsewhere) {
  gltf::Document document;
  document.images.resize(2);
  document.samplers = {sampler(9728, 9984, 33071, 33648), sampler(-1, 9729, 10497, 10497), sampler(7, 8, 9, 10)};
  document.textures = {texture(0, -1), texture(1, 0), texture(1, 1), texture(1, 2)};
  IssueLog log;
  const auto textures = read_textures(document, log);
  ASSERT_THAT(textures, SizeIs(4));
  EXPECT_EQ(textures[0].image, 0u);
  EXPECT_EQ(textures[0].sampler.wrap_u, Wrap::repeat);
  EXPECT_TRUE(textures[0].sampler.use_mipmaps);
  EXPECT_EQ(textures[1].sampler.magnify, Filter::nearest);
  EXPECT_EQ(textures[1].sampler.minify, Filter::nearest);
  EXPECT_EQ(textures[1].sampler.mipmap, Filter::nearest);
  EXPECT_EQ(textures[1].sampler.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(textures[1].sampler.wrap_v, Wrap::mirrored_repeat);
  EXPECT_FALSE(textures[2].sampler.use_mipmaps);
  EXPECT_EQ(textures[2].sampler.magnify, Filter::linear);
  EXPECT_EQ(textures[3].sampler.minify, Filter::linear);
  std::vector<std::string> places;
  for (const auto& warning : log.take_warnings()) places.push_back(warning.json_pointer);
  EXPECT_THAT(places, testing::UnorderedElementsAre("/samplers/2/magFilter", "/samplers/2/minFilter",
                                                    "/samplers/2/wrapS", "/samplers/2/wrapT"));
}

TEST(read_textures, prefer_the_webp_image) {
  gltf::Document document;
  document.images.resize(2);
  document.textures = {texture(0, -1), texture(0, -1)};
  document.textures[0].extensions = Json::parse(R"({"EXT_texture_webp": {"source": 1}})");
  document.textures[1].extensions = Json::parse(R"({"EXT_texture_webp": {"source": 2}})");
  IssueLog log;
  const auto textures = read_textures(document, log);
  EXPECT_EQ(textures[0].image, 1u);
  EXPECT_EQ(textures[1].image, 0u);
  EXPECT_EQ(log.take_warnings().at(0).json_pointer, "/textures/1/extensions/EXT_texture_webp/source");
}

TEST(read_textures, of_images_that_are_not_decoded_take_the_first_kind) {
  gltf::Document document;
  document.images.resize(2);
  document.textures = {texture(-1, -1)};
  document.textures[0].extensions =
      Json::parse(R"({"MSFT_texture_dds": {"source": 1}, "KHR_texture_basisu": {"source": 0}})");
  IssueLog log;
  EXPECT_EQ(read_textures(document, log)[0].image, 0u) << "KHR_texture_basisu";
}

}  // namespace
}  // namespace sinew
