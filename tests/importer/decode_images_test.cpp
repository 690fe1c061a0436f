// SPDX-License-Identifier: MIT
#include "importer/rewrite/decode_images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "importer/export_glb.h"
#include "importer/rewrite_gltf.h"
#include "tests/importer/encoded_images.h"
#include "tests/importer/ktx2_samples.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<std::uint8_t> kTwoTexels{255, 0, 0, 255, 0, 255, 0, 128};

/// A triangle with textures of a KTX2 (beside a PNG), a WebP and a PNG image.
test::TinyGltf textured_triangle(const std::vector<std::byte>& ktx2) {
  test::TinyGltf file;
  file.add_triangle()["material"] = 0;
  file.root["extensionsUsed"] = {"KHR_texture_basisu", "EXT_texture_webp"};
  file.root["extensionsRequired"] = {"EXT_texture_webp"};
  const auto image = [&](const std::vector<std::byte>& bytes, const char* type) {
    return Json{{"bufferView", file.add_view(bytes)}, {"mimeType", type}};
  };
  const auto by = [](const char* extension, int source) { return Json{{extension, {{"source", source}}}}; };
  file.root["images"] = {image(ktx2, "image/ktx2"), image(test::encode_webp(2, 1, kTwoTexels), "image/webp"),
                         image(test::encode_png(2, 1, 4, kTwoTexels), "image/png")};
  file.root["textures"] = {{{"source", 2}, {"extensions", by("KHR_texture_basisu", 0)}},
                           {{"extensions", by("EXT_texture_webp", 1)}},
                           {{"source", 2}}};
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                             {"emissiveTexture", {{"index", 1}}},
                             {"occlusionTexture", {{"index", 2}}}}};
  return file;
}

ImportResult<ImportedFile> import_carrying(const test::TinyGltf& file) {
  ImportOptions options;
  options.carry_document = true;
  return file.import(options);
}

TEST(decode_images, writes_webp_and_ktx2_as_png_without_their_extensions) {
  const auto before = import_carrying(textured_triangle(test::uastc_zstd_sample().file));
  ASSERT_EQ(test::outcome(before), "ok");
  RewriteOptions options;
  options.decode_images = true;
  const auto written = rewrite_gltf(*before, options);
  ASSERT_TRUE(written);
  EXPECT_THAT(written->drops, IsEmpty());
  const auto after = import_gltf(written->file, "after.glb");
  ASSERT_EQ(test::outcome(after), "ok");
  EXPECT_THAT(after->facts.extensions_used, IsEmpty());
  EXPECT_THAT(after->facts.extensions_required, IsEmpty());
  ASSERT_THAT(after->scene.images, SizeIs(3));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(after->scene.images[i].mime_type, "image/png");
    EXPECT_EQ(after->scene.images[i].rgba, before->scene.images[i].rgba);
    EXPECT_EQ(after->scene.textures[i].image, i);
  }
  EXPECT_EQ(after->scene.images[0].rgba, test::uastc_zstd_sample().rgba);
}

TEST(decode_images, lists_an_image_that_cannot_be_decoded_and_keeps_it_where_that_is_permitted) {
  auto damaged = test::uastc_zstd_sample().file;
  damaged[44] = std::byte{3};  // zlib
  const auto before = import_carrying(textured_triangle(damaged));
  ASSERT_TRUE(before);
  RewriteOptions options;
  options.decode_images = true;
  const auto refused = rewrite_gltf(*before, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().issue.json_pointer, "/images/0");
  EXPECT_THAT(refused.error().issue.detail, HasSubstr("supercompression scheme 3, which is not decoded"));
  options.drop = {"image-missing"};
  const auto written = rewrite_gltf(*before, options);
  ASSERT_TRUE(written);
  ImportOptions keep;
  keep.decode_images = false;
  keep.keep_encoded_images = true;
  const auto after = import_gltf(written->file, "after.glb", keep);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->scene.images[0].encoded, damaged);
  EXPECT_THAT(after->facts.extensions_used, testing::ElementsAre("KHR_texture_basisu"));
}

TEST(export_glb, keeps_the_bytes_of_a_ktx2_image_by_its_extension) {
  ImportOptions keep;
  keep.keep_encoded_images = true;
  const auto before = textured_triangle(test::etc1s_sample().file).import(keep);
  ASSERT_TRUE(before);
  const auto written = export_glb(before->scene);
  ASSERT_TRUE(written);
  const auto after = import_gltf(*written, "after.glb", keep);
  ASSERT_EQ(test::outcome(after), "ok");
  EXPECT_EQ(after->scene.images[0].encoded, test::etc1s_sample().file);
  EXPECT_EQ(after->scene.images[0].rgba, test::etc1s_sample().rgba);
  EXPECT_THAT(after->facts.extensions_required, testing::Contains("KHR_texture_basisu"));
}

}  // namespace
}  // namespace sinew
