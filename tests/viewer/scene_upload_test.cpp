// SPDX-License-Identifier: MIT
// Copies of a scene's fixed parts: staging, samplers, images, vertex streams, materials.
#include "viewer/upload/scene_upload.h"

#include <array>
#include <cstring>
#include <set>
#include <vector>

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

class staging : public DeviceTest {
 protected:
  static Buffer target(std::size_t bytes) {
    return {*test_device(), bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, MemoryUse::read_back};
  }
};

std::vector<std::byte> bytes_of(std::size_t count, unsigned first) {
  std::vector<std::byte> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<std::byte>(i * 7 + first);
  return out;
}

TEST_F(staging, copies_arrive_when_they_are_sent) {
  Staging copies(*test_device());
  const Buffer a = target(1000), b = target(24);
  const auto first = bytes_of(1000, 1), second = bytes_of(24, 9);
  std::memset(a.mapped(), 0, 1000);
  copies.copy(a, first);
  copies.copy(b, second);
  copies.copy(b, {});
  EXPECT_EQ(copies.waiting_bytes(), 1024u);
  EXPECT_EQ(a.mapped()[3], std::byte(0)) << "not yet";
  copies.send();
  EXPECT_EQ(copies.waiting_bytes(), 0u);
  EXPECT_EQ(0, std::memcmp(a.mapped(), first.data(), first.size()));
  EXPECT_EQ(0, std::memcmp(b.mapped(), second.data(), second.size()));
  const auto third = bytes_of(24, 77);
  copies.copy(b, third);
  copies.send();
  EXPECT_EQ(0, std::memcmp(b.mapped(), third.data(), third.size()));
  EXPECT_EQ(0, std::memcmp(a.mapped(), first.data(), first.size())) << "what was sent is not sent again";
}

TEST_F(staging, more_than_64_MiB_do_not_wait) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  Staging copies(*test_device());
  const Buffer a = target(32 * kMiB), other = target(32 * kMiB), b = target(1);
  const std::vector<std::byte> half(32 * kMiB, std::byte(5)), one(1, std::byte(6));
  copies.copy(a, half);
  EXPECT_EQ(copies.waiting_bytes(), 32 * kMiB);
  copies.copy(other, half);
  EXPECT_EQ(copies.waiting_bytes(), 64 * kMiB) << "as much as may be";
  copies.copy(b, one);
  EXPECT_EQ(copies.waiting_bytes(), 0u);
  EXPECT_EQ(b.mapped()[0], std::byte(6));
  EXPECT_EQ(a.mapped()[32 * kMiB - 1], std::byte(5));
}

TEST_F(staging, levels_of_images_count_as_well) {
  Staging copies(*test_device());
  const GpuImage image(*test_device(), {VK_FORMAT_R8G8B8A8_UNORM,
                                        {64, 32},
                                        mip_count(64, 32),
                                        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
  const std::vector<MipLevel> levels = mip_chain(std::vector<std::uint8_t>(4 * 64 * 32, 9), 64, 32, {});
  copies.copy(image, levels);
  std::size_t bytes = 0;
  for (const MipLevel& level : levels) bytes += level.rgba.size();
  EXPECT_EQ(copies.waiting_bytes(), bytes);
  copies.send();
  EXPECT_EQ(copies.waiting_bytes(), 0u);
}

class textures : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    for (int i = 0; i < 2; ++i) scene.images.push_back({"", 2, 1, {1, 2, 3, 4, 5, 6, 7, 8}, ""});
    scene.images.push_back({"", 2, 1, {1, 2, 3, 4, 5, 6, 7}, ""});  // a byte is missing
    scene.images.push_back({"", 2, 1, {1, 2, 3, 4, 5, 6, 7, 8}, "not found"});
    scene.images.push_back({"", 0, 0, {}, ""});
    for (std::uint32_t i = 0; i < 5; ++i) scene.textures.push_back({i, {}});
    scene.textures.push_back({kNone, {}});
  }
  Scene scene;
};

TEST_F(textures, every_kind_of_sampler_is_made_once) {
  scene.textures.clear();
  for (const Filter magnify : {Filter::nearest, Filter::linear})
    for (const Filter minify : {Filter::nearest, Filter::linear})
      for (const Filter mipmap : {Filter::nearest, Filter::linear})
        for (const bool use_mipmaps : {false, true})
          for (const Wrap u : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat})
            for (const Wrap v : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat})
              scene.textures.push_back({0, {magnify, minify, mipmap, use_mipmaps, u, v}});
  Staging copies(*test_device());
  TextureSet set(*test_device());
  std::set<VkSampler> samplers;
  for (std::uint32_t t = 0; t < scene.textures.size(); ++t)
    samplers.insert(set.bind(scene, t, {.srgb = true}, copies).sampler);
  EXPECT_EQ(samplers.size(), scene.textures.size());
  for (std::uint32_t t = 0; t < scene.textures.size(); ++t)
    EXPECT_EQ(samplers.count(set.bind(scene, t, {}, copies).sampler), 1u);
  copies.send();
}

TEST_F(textures, an_image_is_uploaded_once_for_colour_and_once_for_data) {
  Staging copies(*test_device());
  TextureSet set(*test_device());
  const auto view = [&](std::uint32_t texture, bool srgb) {
    return set.bind(scene, texture, {.srgb = srgb}, copies).imageView;
  };
  const VkImageView color = view(0, true), data = view(0, false);
  const auto waiting = copies.waiting_bytes();
  EXPECT_EQ(waiting, 2 * (8u + 4u)) << "with a level of one texel";
  EXPECT_NE(color, data);
  EXPECT_EQ(view(0, true), color);
  EXPECT_EQ(view(0, false), data);
  EXPECT_EQ(copies.waiting_bytes(), waiting);
  EXPECT_NE(view(1, true), color) << "another image, if of the same pixels";
  copies.send();
}

TEST_F(textures, an_image_is_uploaded_for_each_use_of_its_alpha_unless_all_of_it_covers) {
  for (const int alpha : {254, 255}) {
    scene.images[0].rgba.assign(8, static_cast<std::uint8_t>(alpha));
    Staging copies(*test_device());
    TextureSet set(*test_device());
    std::set<VkImageView> views;
    for (const TexelUse& use : {TexelUse{true}, {true, true}, {true, true, 128}, {true, true, 64}})
      views.insert(set.bind(scene, 0, use, copies).imageView);
    EXPECT_EQ(views.size(), alpha == 255 ? 1u : 4u);
    copies.send();
  }
}

TEST_F(textures, G66_unreadable_images_share_one_board_and_no_texture_is_white) {
  Staging copies(*test_device());
  TextureSet set(*test_device());
  const auto view = [&](std::uint32_t texture) { return set.bind(scene, texture, {.srgb = true}, copies).imageView; };
  const VkImageView board = view(2), white = view(kNone);
  EXPECT_EQ(view(3), board) << "missing";
  EXPECT_EQ(view(4), board) << "without pixels";
  EXPECT_EQ(view(5), board) << "a texture without image";
  EXPECT_NE(white, board);
  EXPECT_NE(view(0), board);
  EXPECT_NE(view(0), white);
  copies.send();
}

TEST_F(textures, readable_ones_have_an_image_with_all_its_pixels) {
  for (std::uint32_t t = 0; t < scene.textures.size(); ++t) EXPECT_EQ(readable(scene, TextureUse{t}), t < 2) << t;
  EXPECT_FALSE(readable(scene, TextureUse{}));
  scene.images[0].height = 0;
  EXPECT_FALSE(readable(scene, TextureUse{0}));
  scene.images[1].width = 0;
  EXPECT_FALSE(readable(scene, TextureUse{1}));
}

TEST(sampler_info, filters_and_wrapping_are_those_of_the_file) {
  const VkSamplerCreateInfo info = sampler_info(
      {Filter::nearest, Filter::linear, Filter::linear, true, Wrap::clamp_to_edge, Wrap::mirrored_repeat}, 16.0f);
  EXPECT_EQ(info.magFilter, VK_FILTER_NEAREST);
  EXPECT_EQ(info.minFilter, VK_FILTER_LINEAR);
  EXPECT_EQ(info.mipmapMode, VK_SAMPLER_MIPMAP_MODE_LINEAR);
  EXPECT_EQ(info.addressModeU, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  EXPECT_EQ(info.addressModeV, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT);
  EXPECT_EQ(info.maxLod, VK_LOD_CLAMP_NONE);
  EXPECT_FALSE(info.anisotropyEnable) << "not all filters are linear";
  const VkSamplerCreateInfo flat = sampler_info({.minify = Filter::nearest, .use_mipmaps = false}, 16.0f);
  EXPECT_EQ(flat.minFilter, VK_FILTER_NEAREST);
  EXPECT_EQ(flat.magFilter, VK_FILTER_LINEAR);
  EXPECT_EQ(flat.mipmapMode, VK_SAMPLER_MIPMAP_MODE_NEAREST);
  EXPECT_EQ(flat.addressModeU, VK_SAMPLER_ADDRESS_MODE_REPEAT);
  EXPECT_EQ(flat.maxLod, 0.25f);
  EXPECT_FALSE(flat.anisotropyEnable);
}

TEST(sampler_info, anisotropy_is_for_smooth_mipmaps) {
  EXPECT_EQ(sampler_info({}, 16.0f).maxAnisotropy, 16.0f);
  EXPECT_EQ(sampler_info({}, 4.0f).maxAnisotropy, 4.0f);
  EXPECT_TRUE(sampler_info({}, 4.0f).anisotropyEnable);
  for (const Sampler& rough : {Sampler{.magnify = Filter::nearest}, Sampler{.minify = Filter::nearest},
                               Sampler{.mipmap = Filter::nearest}, Sampler{.use_mipmaps = false}}) {
    EXPECT_FALSE(sampler_info(rough, 16.0f).anisotropyEnable);
    EXPECT_EQ(sampler_info(rough, 16.0f).maxAnisotropy, 1.0f);
  }
  EXPECT_FALSE(sampler_info({}, 1.0f).anisotropyEnable) << "the device has none";
}

TEST(placeholder_image, G66_is_a_board_of_8_by_8_fields) {
  const MipLevel board = placeholder_image();
  ASSERT_EQ(board.rgba.size(), 4u * board.width * board.height);
  for (std::uint32_t y = 0; y < board.height; ++y)
    for (std::uint32_t x = 0; x < board.width; ++x) {
      const std::uint8_t* texel = &board.rgba[4 * (y * board.width + x)];
      const std::uint8_t lit = (8 * x / board.width + 8 * y / board.height) % 2 == 0 ? 255 : 0;
      ASSERT_TRUE(texel[0] == lit && texel[1] == 0 && texel[2] == lit && texel[3] == 255) << x << ' ' << y;
    }
}

class mesh_set : public DeviceTest {};

TEST_F(mesh_set, streams_lie_one_after_another_on_multiples_of_16_bytes_behind_the_defaults) {
  Scene scene;
  scene.meshes.resize(2);
  for (int i = 0; i < 2; ++i) scene.meshes[0].primitives.emplace_back();
  scene.meshes[1].primitives.emplace_back();
  Primitive& full = scene.meshes[0].primitives[1];
  full.positions.resize(3);
  full.normals.resize(3);
  full.tangents.resize(3);
  full.texcoords = {std::vector<glm::vec2>(3), std::vector<glm::vec2>(3)};
  full.colors.resize(3);
  full.indices = {0, 1, 2};
  Primitive& bare = scene.meshes[1].primitives[0];
  bare.positions.resize(5);
  bare.texcoords = {std::vector<glm::vec2>(5)};
  bare.indices = {0, 1, 2, 2, 3, 4};
  Staging copies(*test_device());
  VertexVisibility visibility;
  visibility.times_s = {0.0, 1.0};
  visibility.values = {{{}, {}}, {std::vector<float>(10, 0.5f)}};
  const MeshSet set(*test_device(), scene, &visibility, copies);
  const auto waiting = copies.waiting_bytes();
  copies.send();
  using Places = std::array<VkDeviceSize, kAttributeCount>;
  EXPECT_EQ(set.primitive(0, 0).attributes,
            (Places{kAbsent, kAbsent, kAbsent, kAbsent, kAbsent, kAbsent, kAbsent, kAbsent}));
  EXPECT_EQ(set.primitive(0, 0).index_count, 0u);
  EXPECT_EQ(set.primitive(0, 1).attributes, (Places{48, 96, 144, 192, 224, 256, kAbsent, kAbsent}));
  EXPECT_EQ(set.primitive(0, 1).indices, 304u);
  EXPECT_EQ(set.primitive(0, 1).index_count, 3u);
  EXPECT_EQ(set.primitive(1, 0).attributes, (Places{320, kAbsent, kAbsent, 384, kAbsent, kAbsent, 432, 432}));
  EXPECT_EQ(set.primitive(1, 0).indices, 480u) << "behind two key poses of five vertices";
  EXPECT_EQ(set.primitive(1, 0).index_count, 6u);
  EXPECT_EQ(waiting, 480u + 6 * 4);
  for (const Attribute one : {Attribute::color, Attribute::visibility, Attribute::next_visibility})
    EXPECT_EQ(set.default_of(one), 16u);
  EXPECT_EQ(set.default_of(Attribute::tangent), 32u) << "x, right-handed";
  for (const Attribute zero : {Attribute::position, Attribute::normal, Attribute::texcoord_0, Attribute::texcoord_1})
    EXPECT_EQ(set.default_of(zero), 0u);
}

TEST_F(mesh_set, each_primitive_brings_its_own_visibility) {
  Scene scene;
  scene.meshes.resize(2);
  VertexVisibility visibility;
  std::size_t lists = 0;
  for (Mesh& mesh : scene.meshes) {
    mesh.primitives.resize(2);
    auto& values = visibility.values.emplace_back();
    for (Primitive& primitive : mesh.primitives) {
      primitive.positions.resize(1);
      values.emplace_back(4 * ++lists, 0.5f);  // of 4 key poses, 8, 12 and 16
    }
  }
  Staging copies(*test_device());
  const MeshSet set(*test_device(), scene, &visibility, copies);
  copies.send();
  VkDeviceSize at = 48;  // behind the defaults
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto& places = set.primitive(i / 2, i % 2).attributes;
    EXPECT_EQ(places[0], at) << i;
    EXPECT_EQ(places[static_cast<std::size_t>(Attribute::visibility)], at + 16) << i;
    at += 16 + 16 * (i + 1);
  }
}

class material_set : public DeviceTest {};

TEST_F(material_set, each_material_has_a_set_and_a_copy_in_each_slot_only_where_clips_animate_some) {
  for (const bool animated : {false, true}) {
    Scene scene;
    scene.materials.resize(3);
    scene.materials[1].unlit = true;
    if (animated) scene.properties.entries.push_back({{PropertyKind::base_color, 2}, 0, 4});
    scene.properties.entries.push_back({{PropertyKind::light_outer_cone, 0}, 4, 1});
    Staging copies(*test_device());
    const MaterialSet set(*test_device(), scene, copies, 2);
    copies.send();
    std::set<VkDescriptorSet> sets;
    for (std::uint32_t slot = 0; slot < 2; ++slot)
      for (std::uint32_t m = 0; m < 4; ++m) sets.insert(set.set_of(m, slot));
    EXPECT_EQ(sets.size(), animated ? 8u : 4u);
    EXPECT_EQ(set.set_of(kNone, 0), set.set_of(3, 0)) << "the default";
    EXPECT_EQ(set.set_of(1, 2), set.set_of(1, 0)) << "slots go around";
    for (std::uint32_t m = 0; m < 5; ++m) EXPECT_EQ(set.features_of(m).unlit, m == 1);
  }
}

TEST_F(material_set, G66_features_leave_out_data_that_cannot_be_read_but_not_colours) {
  Scene scene;
  scene.images.push_back({"", 1, 1, {}, "not found"});
  scene.images.push_back({"", 1, 1, {1, 2, 3, 4}, ""});
  scene.textures = {{0, {}}, {1, {}}};
  for (const std::uint32_t texture : {0u, 1u}) {
    Material& m = scene.materials.emplace_back();
    m.base_color_texture = m.metallic_roughness_texture = m.normal_texture = m.emissive_texture = {texture, 0};
    m.occlusion_texture = {texture, 1};
  }
  Staging copies(*test_device());
  const MaterialSet set(*test_device(), scene, copies, 1);
  copies.send();
  using Sets = std::array<std::uint8_t, kMaterialTextures>;
  EXPECT_EQ(set.features_of(0).texcoord_sets, (Sets{1, 0, 0, 0, 1}));
  EXPECT_EQ(set.features_of(1).texcoord_sets, (Sets{1, 1, 1, 2, 1}));
  EXPECT_EQ(set.features_of(kNone).texcoord_sets, (Sets{}));
}

TEST(texel_use, base_colours_cover_where_alpha_counts) {
  Material m;
  EXPECT_EQ(base_color_use(m), (TexelUse{true, false, 0}));
  m.alpha_mode = AlphaMode::blend;
  EXPECT_EQ(base_color_use(m), (TexelUse{true, true, 0}));
}

TEST(texel_use, cutoff_is_the_least_code_that_an_alpha_test_keeps) {
  Material m;
  m.alpha_mode = AlphaMode::mask;
  const auto cutoff = [&](float alpha_cutoff, float factor) {
    m.alpha_cutoff = alpha_cutoff;
    m.base_color.a = factor;
    return int{base_color_use(m).cutoff};
  };
  EXPECT_EQ(cutoff(0.5f, 1.0f), 128);
  EXPECT_EQ(cutoff(0.25f, 0.5f), 128) << "of alpha times the factor";
  EXPECT_EQ(cutoff(1.0f, 1.0f), 255);
  EXPECT_EQ(cutoff(0.001f, 1.0f), 1);
  EXPECT_EQ(cutoff(0.0f, 1.0f), 0) << "keeps all";
  EXPECT_EQ(cutoff(1.1f, 1.0f), 0) << "keeps nothing";
  EXPECT_EQ(cutoff(0.5f, 0.0f), 0);
  for (int code = 1; code < 256; ++code) EXPECT_EQ(cutoff(static_cast<float>(code) / 255.0f, 1.0f), code);
}

TEST(material_places, textures_of_layers_take_free_places_or_share_one) {
  Material m;
  for (TextureUse* use : texture_uses(m)) *use = {9, 0};
  m.base_color_texture.texture = 1;
  m.metallic_roughness_texture.texture = m.occlusion_texture.texture = 2;
  m.normal_texture = {};
  m.emissive_texture.texture = 3;
  EXPECT_EQ(material_features(m).layers.textures[0], 1 + 2 * 2) << "the place of the normal map is free";
  EXPECT_EQ(material_features(m).layers.textures[1], 1 + 2 * 5) << "as sRGB it is another image";
  EXPECT_EQ(texture_places(m)[2].texture, 9u);
  EXPECT_TRUE(texture_places(m)[5].use.srgb);
  m.specular.texture = {2, 1};
  EXPECT_EQ(material_features(m).layers.textures[0], 1 + 2 * 1 + 1) << "shares with metallic-roughness, TEXCOORD_1";
  m.specular.texture = {1, 0};
  EXPECT_EQ(material_features(m).layers.textures[0], 1) << "alpha is the same in sRGB";
  m.alpha_mode = AlphaMode::mask;
  EXPECT_EQ(material_features(m).layers.textures[0], 1 + 2 * 2) << "but not where levels keep coverage";
  EXPECT_TRUE(shows_all_textures(m));
  m.unlit = true;
  EXPECT_EQ(material_features(m).layers, LayerFeatures{});
}

}  // namespace
}  // namespace sinew::viewer
