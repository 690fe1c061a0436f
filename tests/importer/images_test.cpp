// SPDX-License-Identifier: MIT
#include "importer/read/images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "importer/export_glb.h"
#include "importer/read/image_codec.h"
#include "tests/importer/encoded_images.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<std::uint8_t> kFourPixels{255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 0, 10, 20, 30, 40};

/// A document of images that are already loaded; it owns their bytes.
gltf::Document document_of(const std::vector<std::vector<std::byte>>& files) {
  gltf::Document document;
  for (const auto& file : files) {
    document.storage.push_back(file);
    gltf::Image image;
    image.encoded = document.storage.back();
    if (file.empty()) image.missing_reason = "not there";
    document.images.push_back(image);
  }
  return document;
}

std::vector<Image> read_decoded(const gltf::Document& document, const ImportOptions& options, IssueLog& log) {
  std::vector<Texture> textures;
  return read_images(document, options, textures, log);
}

void expect_missing(const std::vector<std::byte>& file, const std::string& reason, const ImportOptions& options = {}) {
  IssueLog log;
  const auto images = read_decoded(document_of({file}), options, log);
  ASSERT_THAT(images, SizeIs(1));
  EXPECT_THAT(images[0].missing_reason, HasSubstr(reason));
  EXPECT_THAT(images[0].rgba, IsEmpty());
  EXPECT_EQ(images[0].width, 0u);
  EXPECT_EQ(images[0].height, 0u);
  EXPECT_EQ(images[0].encoded_size, 0u);
  EXPECT_EQ(images[0].mime_type, "");
  EXPECT_TRUE(log.ok());
  const auto warnings = log.take_warnings();
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_EQ(warnings[0].rule, "image-missing");
  EXPECT_EQ(warnings[0].json_pointer, "/images/0");
}

TEST(read_images, give_the_pixels_of_a_png) {
  IssueLog log;
  const auto images = read_decoded(document_of({test::encode_png(2, 2, 4, kFourPixels)}), {}, log);
  ASSERT_THAT(images, SizeIs(1));
  EXPECT_EQ(images[0].width, 2u);
  EXPECT_EQ(images[0].height, 2u);
  EXPECT_EQ(images[0].rgba, kFourPixels);
  EXPECT_THAT(images[0].missing_reason, IsEmpty());
  EXPECT_THAT(log.take_warnings(), IsEmpty());
}

/// Four textures, each with an image in another format.
test::TinyGltf images_of_all_kinds(const std::vector<std::vector<std::byte>>& encoded) {
  test::TinyGltf file;
  file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"EXT_texture_webp", "EXT_texture_avif"};
  const char* const kinds[] = {"image/png", "image/jpeg", "image/webp", "image/avif"};
  for (std::size_t i = 0; i < 4; ++i) {
    file.root["images"].push_back({{"bufferView", file.add_view(encoded[i])}, {"mimeType", kinds[i]}});
    test::Json texture{{"source", i}};
    if (i >= 2) texture = {{"extensions", {{file.root["extensionsUsed"][i - 2].get<std::string>(), {{"source", i}}}}}};
    file.root["textures"].push_back(texture);
    file.root["materials"].push_back({{"emissiveTexture", {{"index", i}}}});
  }
  return file;
}

TEST(read_images, are_written_back_byte_for_byte_webp_and_avif_by_their_extensions) {
  const std::vector<std::vector<std::byte>> encoded{
      test::encode_png(2, 2, 4, kFourPixels), test::encode_jpeg(2, 1, 3, {9, 8, 7, 6, 5, 4}),
      test::encode_webp(2, 2, kFourPixels), test::encode_avif(2, 2, kFourPixels)};
  ImportOptions options;
  options.decode_images = false;
  options.keep_encoded_images = true;
  const auto before = images_of_all_kinds(encoded).import(options);
  ASSERT_EQ(test::outcome(before), "ok");
  const auto written = export_glb(before->scene);
  ASSERT_TRUE(written);
  const auto after = import_gltf(*written, "written.glb", options);
  ASSERT_EQ(test::outcome(after), "ok");
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(after->scene.images[i].encoded, encoded[i]) << i;
    EXPECT_EQ(after->scene.textures[i].image, i);
    EXPECT_THAT(after->scene.images[i].rgba, IsEmpty());
  }
  EXPECT_THAT(after->facts.extensions_required, testing::UnorderedElementsAre("EXT_texture_webp", "EXT_texture_avif"));
  EXPECT_THAT(after->facts.extensions_used, testing::UnorderedElementsAre("EXT_texture_webp", "EXT_texture_avif"));
}

TEST(read_images, probing_takes_kind_and_size_from_the_header_alone) {
  auto cut = test::encode_png(2, 2, 4, kFourPixels);
  cut.resize(40);  // signature and header only, no pixels
  ImportOptions options;
  options.decode_images = false;
  options.probe_images = true;
  IssueLog log;
  const auto images =
      read_decoded(document_of({cut, test::encode_webp(2, 2, kFourPixels), {std::byte{1}}}), options, log);
  EXPECT_EQ(images[0].width, 2u);
  EXPECT_EQ(images[0].height, 2u);
  EXPECT_EQ(images[0].mime_type, "image/png");
  EXPECT_EQ(images[0].encoded_size, 40u);
  EXPECT_EQ(images[1].mime_type, "image/webp");
  EXPECT_THAT(images[1].rgba, IsEmpty());
  EXPECT_THAT(images[1].encoded, IsEmpty());
  EXPECT_THAT(images[2].missing_reason, HasSubstr("is no undamaged"));
}

TEST(read_images, give_the_pixels_of_a_lossless_webp) {
  IssueLog log;
  std::vector<std::uint8_t> opaque = kFourPixels;
  for (std::size_t i = 3; i < opaque.size(); i += 4) opaque[i] = 255;
  const auto images = read_decoded(document_of({test::encode_webp(2, 2, opaque)}), {}, log);
  EXPECT_EQ(images[0].rgba, opaque);
}

TEST(read_images, give_the_pixels_of_a_lossless_avif) {
  IssueLog log;
  const auto images = read_decoded(document_of({test::encode_avif(2, 2, kFourPixels)}), {}, log);
  EXPECT_EQ(images[0].rgba, kFourPixels);
  EXPECT_EQ(images[0].mime_type, "image/avif");
  EXPECT_THAT(log.take_warnings(), IsEmpty());
}

/// Offset of the name of a box or property in a file.
std::size_t find_name(const std::vector<std::byte>& file, std::string_view name) {
  const auto found = std::search(file.begin(), file.end(), name.begin(), name.end(),
                                 [](std::byte b, char c) { return b == static_cast<std::byte>(c); });
  EXPECT_NE(found, file.end()) << name;
  return static_cast<std::size_t>(found - file.begin());
}

TEST(read_images, G66_a_truncated_avif_is_missing) {
  const auto file = test::encode_avif(2, 2, kFourPixels);
  for (const std::size_t left : {find_name(file, "mdat") + 5, find_name(file, "ispe")})
    expect_missing({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(left)}, "AVIF");
}

/// The container claims another size than its stream has.
TEST(read_images, G68_an_avif_has_no_more_pixels_than_it_claims) {
  auto file = test::encode_avif(64, 64, std::vector<std::uint8_t>(4 * 64 * 64, 9));
  const std::size_t width = find_name(file, "ispe") + 11;  // the lowest of four bytes, after version and flags
  ASSERT_EQ(file[width], std::byte{64});
  file[width] = std::byte{32};
  expect_missing(file, "its AVIF data are damaged");
  file[width - 2] = file[width + 2] = std::byte{1};  // 65568 x 65600
  expect_missing(file, "AVIF");
  file[width - 2] = file[width + 2] = std::byte{0};
  file[width - 1] = file[width + 3] = std::byte{0x38};  // 14368 x 14400
  expect_missing(file, "14368 x 14400 pixels in ");
}

TEST(read_images, spread_grey_over_colours_and_make_it_opaque) {
  IssueLog log;
  const auto images = read_decoded(document_of({test::encode_png(2, 1, 1, {7, 200})}), {}, log);
  EXPECT_EQ(images[0].rgba, (std::vector<std::uint8_t>{7, 7, 7, 255, 200, 200, 200, 255}));
}

TEST(read_images, decode_jpeg_close_to_its_source) {
  IssueLog log;
  const std::vector<std::uint8_t> flat(16 * 16 * 3, 100);
  const auto images = read_decoded(document_of({test::encode_jpeg(16, 16, 3, flat)}), {}, log);
  ASSERT_THAT(images[0].rgba, SizeIs(4 * 16 * 16));
  for (std::size_t i = 0; i < images[0].rgba.size(); ++i)
    EXPECT_NEAR(images[0].rgba[i], i % 4 == 3 ? 255 : 100, i % 4 == 3 ? 0 : 2);
}

/// The file's single image after import.
Image imported_image(const std::vector<std::byte>& encoded) {
  test::TinyGltf file;
  file.root["images"] = test::Json::array({{{"bufferView", file.add_view(encoded)}, {"mimeType", "image/jpeg"}}});
  auto result = file.import();
  EXPECT_EQ(test::outcome(result), "ok");
  return result ? result->scene.images.at(0) : Image{};
}

TEST(read_images, G66_a_jpeg_that_ends_early_shows_the_rows_that_it_has) {
  test::FixedRandom random(2);
  std::vector<std::uint8_t> pixels(3 * 64 * 64);  // grey bands of 8 rows, with noise so that each row takes some bytes
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = static_cast<std::uint8_t>(100 + 10 * (i / (3 * 64 * 8)) + random.below(3));
  auto file = test::encode_jpeg(64, 64, 3, pixels);
  file.resize(file.size() - file.size() / 4);
  const Image image = imported_image(file);
  EXPECT_EQ(image.missing_reason, "");
  ASSERT_THAT(image.rgba, SizeIs(4 * 64 * 64));
  for (const std::size_t row : {0, 8, 16}) EXPECT_NEAR(image.rgba[4 * 64 * row], pixels[3 * 64 * row], 8) << row;
}

/// Repeats the first scan of a progressive file: decoding each scan takes the time of the whole picture.
TEST(read_images, G68_a_jpeg_with_thousands_of_scans_is_missing) {
  const auto file = test::encode_progressive_jpeg(16, 16, std::vector<std::uint8_t>(3 * 16 * 16, 100));
  EXPECT_EQ(imported_image(file).missing_reason, "");
  const auto scan_after = [&](auto from) {
    return std::search_n(from, file.end(), 1, std::byte{0xff},
                         [&](const std::byte& b, std::byte mark) { return b == mark && (&b)[1] == std::byte{0xda}; });
  };
  const auto first = scan_after(file.begin()), second = scan_after(first + 1);
  std::vector<std::byte> scans(file.begin(), second);
  for (int i = 0; i < 2000; ++i) scans.insert(scans.end(), first, second);
  scans.insert(scans.end(), second, file.end());
  EXPECT_THAT(imported_image(scans).missing_reason, HasSubstr("cannot be decoded"));
}

TEST(read_images, G66_an_image_that_was_not_found_keeps_its_reason_and_the_others_load) {
  IssueLog log;
  const auto images = read_decoded(document_of({{}, test::encode_png(2, 2, 4, kFourPixels)}), {}, log);
  EXPECT_EQ(images[0].missing_reason, "not there");
  EXPECT_EQ(images[1].rgba, kFourPixels);
  EXPECT_THAT(log.take_warnings(), IsEmpty()) << "who looked for it has warned";
}

TEST(read_images, G66_an_unknown_format_is_missing) {
  expect_missing(std::vector<std::byte>(100, std::byte{'x'}), "no undamaged PNG, JPEG, WebP, AVIF or KTX2");
}

TEST(read_images, G66_a_truncated_png_is_missing) {
  test::FixedRandom random(1);
  std::vector<std::uint8_t> noise(4 * 64 * 64);
  for (auto& byte : noise) byte = static_cast<std::uint8_t>(random.below(256));
  auto file = test::encode_png(64, 64, 4, noise);
  file.resize(file.size() / 2);
  expect_missing(file, "a chunk of the PNG leaves the file");
}

/// A decoder that trusts the last chunk's length would allocate 13 * 2^24 bytes.
TEST(read_images, G68_a_png_that_ends_inside_of_a_checksum_is_missing) {
  auto file = test::encode_png(2, 2, 4, kFourPixels);
  const std::string_view name = "IDAT";
  const auto data = std::search(file.begin(), file.end(), name.begin(), name.end(),
                                [](std::byte b, char c) { return b == static_cast<std::byte>(c); });
  *(data - 4) = std::byte{13};  // a length of a little over 13 * 2^24 bytes
  file.resize(static_cast<std::size_t>(data - file.begin()) + 7);
  expect_missing(file, "a chunk of the PNG leaves the file");
}

TEST(read_images, G66_a_truncated_webp_is_missing) {
  auto file = test::encode_webp(2, 2, kFourPixels);
  file.resize(file.size() - 8);
  expect_missing(file, "WebP");
}

std::vector<std::byte> bytes_of_text(std::string_view text, std::size_t size) {
  std::vector<std::byte> bytes(size);
  std::transform(text.begin(), text.end(), bytes.begin(), [](char c) { return static_cast<std::byte>(c); });
  return bytes;
}

/// Files of only a header, which claims 640 x 480 pixels.
std::map<std::string, std::vector<std::byte>> undecoded_images() {
  auto dds = bytes_of_text("DDS ", 128);
  dds[12] = std::byte{0xe0};
  dds[13] = std::byte{0x01};
  dds[16] = std::byte{0x80};
  dds[17] = std::byte{0x02};
  return {{"image/vnd-ms.dds", dds}};
}

TEST(read_images, kinds_that_are_not_decoded_are_placeholders_whose_bytes_a_converter_keeps) {
  for (const auto& [type, file] : undecoded_images()) {
    expect_missing(file, "is " + type + ", which is not decoded");
    ImportOptions keep;
    keep.decode_images = false;
    keep.probe_images = keep.keep_encoded_images = true;
    keep.max_image_pixels = 100;  // nothing is decoded, so the limit does not apply
    IssueLog log;
    const auto images = read_decoded(document_of({file}), keep, log);
    EXPECT_EQ(images[0].mime_type, type);
    EXPECT_EQ(images[0].width, 640u);
    EXPECT_EQ(images[0].height, 480u);
    EXPECT_EQ(images[0].encoded, file);
    EXPECT_THAT(log.take_warnings(), IsEmpty());
    for (std::size_t size = 0; size < file.size(); ++size) probe_image(std::span(file).first(size));
  }
}

TEST(read_images, an_extension_that_only_names_images_blocks_no_pose) {
  for (const char* name : {"KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds", "EXT_texture_webp"}) {
    test::TinyGltf file;
    file.add_triangle()["material"] = 0;
    file.root["extensionsUsed"] = file.root["extensionsRequired"] = {name};
    file.root["images"] = {{{"uri", "missing.bin"}}, {{"uri", "missing.png"}}};
    file.root["textures"] = {{{"extensions", {{name, {{"source", 0}}}}}},
                             {{"source", 1}, {"extensions", {{name, {{"source", 0}}}}}}};
    file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    ImportOptions no_images;
    no_images.decode_images = false;
    const auto result = file.import(no_images);
    ASSERT_EQ(test::outcome(result), "ok") << name;
    EXPECT_THAT(result->warnings, SizeIs(1)) << "texture coordinates are missing, nothing else";
    EXPECT_EQ(result->scene.textures[0].image, 0u) << name;
    const bool decoded = std::string_view(name) != "MSFT_texture_dds";
    EXPECT_EQ(result->scene.textures[1].image, decoded ? 0u : 1u) << "what can be shown is preferred: " << name;
  }
}

TEST(read_images, G68_few_bytes_cannot_claim_a_huge_picture) {
  auto file = test::encode_png(2, 2, 4, kFourPixels);
  file[17] = std::byte{0x01};  // width 2 + 65536
  file[21] = std::byte{0x01};  // and height 2 + 65536
  expect_missing(file, "is no undamaged");
  file[17] = file[21] = std::byte{0};
  file[18] = file[22] = std::byte{0x38};  // 14338 x 14338
  expect_missing(file, "14338 x 14338 pixels in ");
}

TEST(read_images, G68_all_images_together_stay_below_the_pixels_allowed) {
  IssueLog log;
  const auto file = test::encode_png(2, 2, 4, kFourPixels);
  ImportOptions options;
  options.max_image_pixels = 9;
  const auto images = read_decoded(document_of({file, file, file}), options, log);
  EXPECT_THAT(images[0].missing_reason, IsEmpty());
  EXPECT_THAT(images[1].missing_reason, IsEmpty());
  EXPECT_THAT(images[2].missing_reason, HasSubstr("exceed the pixels allowed"));
  EXPECT_EQ(log.take_warnings().at(0).json_pointer, "/images/2");
}

TEST(read_images, are_empty_without_a_reason_when_not_asked_for) {
  IssueLog log;
  ImportOptions options;
  options.decode_images = false;
  const auto images = read_decoded(document_of({test::encode_png(2, 2, 4, kFourPixels)}), options, log);
  ASSERT_THAT(images, SizeIs(1));
  EXPECT_THAT(images[0].rgba, IsEmpty());
  EXPECT_THAT(images[0].missing_reason, IsEmpty());
}

TEST(image_codec, survives_any_byte_changed) {
  test::FixedRandom random(2);
  std::vector<std::uint8_t> noise(4 * 9 * 7);
  for (auto& byte : noise) byte = static_cast<std::uint8_t>(random.below(256));
  for (const auto& file : {test::encode_png(9, 7, 4, noise), test::encode_jpeg(9, 7, 4, noise),
                           test::encode_webp(9, 7, noise), test::encode_avif(9, 7, noise)})
    for (std::size_t i = 0; i < file.size(); ++i) {
      auto damaged = file;
      damaged[i] = static_cast<std::byte>(random.below(256));
      const auto size = probe_image(damaged);
      if (!size || size->pixels() > 100'000) continue;
      const auto pixels = decode_image(damaged);
      if (pixels) {
        EXPECT_EQ(pixels->size(), 4 * size->pixels());
      }
    }
}

}  // namespace
}  // namespace sinew
