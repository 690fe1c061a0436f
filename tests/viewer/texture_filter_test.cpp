// SPDX-License-Identifier: MIT
#include "viewer/upload/texture_filter.h"

#include <gtest/gtest.h>

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

constexpr Sampler kOfFile{Filter::nearest,     Filter::linear,       Filter::nearest, true,
                          Wrap::clamp_to_edge, Wrap::mirrored_repeat};

TEST(texture_filter, of_the_file_changes_nothing) {
  const Sampler same = filtered(kOfFile, {});
  EXPECT_EQ(same.magnify, Filter::nearest);
  EXPECT_EQ(same.minify, Filter::linear);
  EXPECT_EQ(same.mipmap, Filter::nearest);
  EXPECT_TRUE(same.use_mipmaps);
}

TEST(texture_filter, replaces_filters_and_levels_and_keeps_wrapping) {
  struct Case {
    FilterKind kind;
    Filter within;
    bool mipmaps;
  };
  for (const auto& [kind, within, mipmaps] :
       {Case{FilterKind::nearest, Filter::nearest, false}, Case{FilterKind::bilinear, Filter::linear, false},
        Case{FilterKind::trilinear, Filter::linear, true}, Case{FilterKind::anisotropic, Filter::linear, true},
        Case{FilterKind::rip_map, Filter::nearest, false}})
    for (const bool levels : {false, true}) {
      Sampler file = kOfFile;
      file.use_mipmaps = levels;
      const Sampler sampler = filtered(file, {kind, 4});
      EXPECT_EQ(sampler.magnify, within);
      EXPECT_EQ(sampler.minify, within);
      EXPECT_EQ(sampler.use_mipmaps, mipmaps);
      EXPECT_TRUE(!mipmaps || sampler.mipmap == Filter::linear);
      EXPECT_EQ(sampler.wrap_u, Wrap::clamp_to_edge);
      EXPECT_EQ(sampler.wrap_v, Wrap::mirrored_repeat);
    }
}

TEST(texture_filter, anisotropy_is_8_for_files_else_as_asked_within_what_the_device_has) {
  EXPECT_EQ(anisotropy_of({}, 16.0f, false), 8.0f);
  EXPECT_EQ(anisotropy_of({}, 4.0f, false), 4.0f);
  EXPECT_EQ(anisotropy_of({}, 16.0f, true), 1.0f);
  EXPECT_EQ(anisotropy_of({FilterKind::anisotropic, 16}, 16.0f, true), 16.0f);
  EXPECT_EQ(anisotropy_of({FilterKind::anisotropic, 16}, 16.0f, false), 16.0f);
  EXPECT_EQ(anisotropy_of({FilterKind::anisotropic, 3}, 16.0f, false), 3.0f);
  EXPECT_EQ(anisotropy_of({FilterKind::anisotropic, 16}, 2.0f, false), 2.0f);
  EXPECT_EQ(anisotropy_of({FilterKind::trilinear, 16}, 16.0f, false), 1.0f);
}

TEST(texture_filter, says_what_the_device_lacks) {
  EXPECT_EQ(describe_missing_filter({FilterKind::anisotropic, 16}, 16.0f), "");
  EXPECT_EQ(describe_missing_filter({FilterKind::rip_map}, 1.0f), "");
  EXPECT_EQ(describe_missing_filter({FilterKind::anisotropic, 16}, 8.0f),
            "this device filters in at most 8 places along a footprint, not 16");
  EXPECT_EQ(describe_missing_filter({FilterKind::anisotropic, 2}, 1.0f),
            "this device has no anisotropic filter; textures are filtered as by --filter trilinear");
}

/// Texture memory in bytes of a scene with one image of 16 x 16 texels, without the single white texel that every scene
/// has.
std::uint64_t bytes_with(const TextureFilter& filter) {
  BuiltScene built;
  Material material;
  built.scene.images.emplace_back();
  built.scene.images[0].width = built.scene.images[0].height = 16;
  built.scene.images[0].rgba.assign(4 * 16 * 16, 200);
  built.scene.textures.push_back({0, {}});
  built.add(square(1.0f), built.add_material(material));
  const std::uint64_t without = SceneUpload(*test_device(), built.scene, 1, nullptr, filter).materials().texel_bytes();
  built.scene.materials[0].base_color_texture.texture = 0;
  return SceneUpload(*test_device(), built.scene, 1, nullptr, filter).materials().texel_bytes() - without;
}

class texture_memory : public DeviceTest {};

TEST_F(texture_memory, of_a_rip_map_is_four_times_that_of_the_image) {
  constexpr std::uint64_t image = 4 * 16 * 16;
  EXPECT_EQ(bytes_with({FilterKind::rip_map}), 4 * image);
  EXPECT_EQ(bytes_with({FilterKind::trilinear}), image + 4 * (64 + 16 + 4 + 1));
  EXPECT_EQ(bytes_with({FilterKind::bilinear}), image);
}

TEST_F(texture_memory, of_a_rip_map_beyond_what_the_device_holds_is_that_of_the_next_level_that_fits) {
  const std::uint32_t most = test_device()->limits().maxImageDimension2D;
  for (const std::uint32_t width : {most / 2, most / 2 + 2}) {
    BuiltScene built;
    built.scene.images.push_back({"row", width, 1, std::vector<std::uint8_t>(std::size_t{4} * width, 90)});
    built.scene.textures.push_back({0, {}});
    Material material = matte({1, 1, 1});
    const auto bytes = [&] {
      return SceneUpload(*test_device(), built.scene, 1, nullptr, {FilterKind::rip_map}).materials().texel_bytes();
    };
    const std::uint64_t without = bytes();
    material.base_color_texture.texture = 0;
    built.add_material(material);
    EXPECT_EQ(bytes() - without, 4u * 4u * (width > most / 2 ? width / 2 : width)) << width;
  }
}

}  // namespace
}  // namespace sinew::viewer
