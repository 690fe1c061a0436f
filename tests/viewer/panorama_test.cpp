// SPDX-License-Identifier: MIT
// Panoramas: writes files, reads them back, and resamples them to cube maps.
#include "viewer/light/panorama.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include <unistd.h>

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <glm/geometric.hpp>

#include "tests/support/file_text.h"
#include "viewer/app/load_environment.h"

namespace sinew::viewer {
namespace {

using testing::HasSubstr;

/// A path in the temporary folder, unique to this process.
std::filesystem::path own_path(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("sinew-" + std::to_string(getpid()) + "-" + name);
}

tl::expected<Panorama, std::string> decoded(const std::string& bytes) {
  return decode_panorama(std::as_bytes(std::span(bytes)));
}

std::string why(const std::string& bytes) {
  const auto panorama = decoded(bytes);
  return panorama ? "it was read" : panorama.error();
}

/// A Radiance file without run-length encoding, as for narrow pictures.
std::string radiance(int width, int height, const std::string& rgbe) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n" +
         rgbe;
}

/// OpenEXR's own writer.
std::filesystem::path write_exr(int width, int height, const std::vector<Imf::Rgba>& texels) {
  const std::filesystem::path path = own_path("made.exr");
  Imf::RgbaOutputFile file(path.c_str(), width, height, Imf::WRITE_RGB);
  file.setFrameBuffer(texels.data(), 1, static_cast<std::size_t>(width));
  file.writePixels(height);
  return path;
}

std::string exr(int width, int height, const std::vector<Imf::Rgba>& texels) {
  const std::filesystem::path path = write_exr(width, height, texels);  // complete once its writer is gone
  std::string bytes = test::text_of_file(path);
  std::filesystem::remove(path);
  return bytes;
}

TEST(panorama, radiance_has_a_common_exponent) {
  const std::string texels = {char(128), 64, 0, char(129), 0, char(255), 32, char(136)};  // value / 256 * 2^(e - 128)
  const auto panorama = decoded(radiance(2, 1, texels));
  ASSERT_TRUE(panorama) << panorama.error();
  ASSERT_EQ(panorama->width, 2u);
  ASSERT_EQ(panorama->height, 1u);
  EXPECT_EQ(panorama->texels[0], glm::vec3(1.0f, 0.5f, 0.0f));
  EXPECT_EQ(panorama->texels[1], glm::vec3(0.0f, 255.0f, 32.0f));
}

TEST(panorama, open_exr_keeps_half_floats_and_what_is_no_light_is_black) {
  const half infinite = half::posInf(), none = half::qNan();
  const auto panorama = decoded(exr(4, 2,
                                    {{0.25f, 3.0f, 60000.0f, 1.0f},
                                     {infinite, 1.0f, 2.0f, 1.0f},
                                     {none, none, 1.0f, 1.0f},
                                     {-4.0f, 0.5f, 0.0f, 1.0f},
                                     {1.0f, 0.0f, 0.0f, 1.0f},
                                     {0.0f, 1.0f, 0.0f, 1.0f},
                                     {0.0f, 0.0f, 1.0f, 1.0f},
                                     {0.5f, 0.5f, 0.5f, 1.0f}}));
  ASSERT_TRUE(panorama) << panorama.error();
  EXPECT_EQ(panorama->texels[0], glm::vec3(0.25f, 3.0f, 60000.0f));
  EXPECT_EQ(panorama->texels[1], glm::vec3(0.0f, 1.0f, 2.0f));
  EXPECT_EQ(panorama->texels[2], glm::vec3(0.0f, 0.0f, 1.0f));
  EXPECT_EQ(panorama->texels[3], glm::vec3(0.0f, 0.5f, 0.0f));
  EXPECT_EQ(panorama->texels[7], glm::vec3(0.5f));
}

TEST(panorama, open_exr_has_its_texels_wherever_its_data_window_lies) {
  const std::filesystem::path path = own_path("window.exr");
  const Imath::Box2i window({7, -3}, {10, -2});
  std::vector<Imf::Rgba> texels(8);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = Imf::Rgba(static_cast<float>(i), 1.0f, 2.0f);
  {
    Imf::RgbaOutputFile file(path.c_str(), window, window, Imf::WRITE_RGB);
    file.setFrameBuffer(texels.data() - window.min.x - window.min.y * 4, 1, 4);
    file.writePixels(2);
  }
  const auto panorama = decoded(test::text_of_file(path));
  std::filesystem::remove(path);
  ASSERT_TRUE(panorama) << panorama.error();
  ASSERT_EQ(panorama->width, 4u);
  ASSERT_EQ(panorama->height, 2u);
  for (std::size_t i = 0; i < texels.size(); ++i) EXPECT_EQ(panorama->texels[i].x, static_cast<float>(i)) << i;
}

TEST(panorama, what_cannot_be_read_is_one_sentence) {
  EXPECT_THAT(why("PNG or so"), HasSubstr("neither Radiance"));
  EXPECT_THAT(why(""), HasSubstr("neither Radiance"));
  EXPECT_THAT(why(radiance(3, 1, std::string(12, 'x'))), HasSubstr("3 x 1: a panorama is twice as wide as high"));
  EXPECT_THAT(why(radiance(8000, 4000, "short")), HasSubstr("ends too early"));
  EXPECT_THAT(why(radiance(9000, 4500, "short")), HasSubstr("wider than 8192"));
  EXPECT_THAT(why(radiance(8194, 4097, "short")), HasSubstr("wider than 8192"));
  EXPECT_THAT(why(radiance(8192, 4096, "short")), HasSubstr("ends too early")) << "the widest that is read";
  EXPECT_THAT(why("#?RADIANCE\nno format\n"), HasSubstr("Radiance"));
  const std::string whole = exr(8, 4, std::vector<Imf::Rgba>(32, Imf::Rgba(1.0f, 1.0f, 1.0f)));
  for (const std::size_t length : {5ul, 40ul, whole.size() / 2, whole.size() - 3})
    EXPECT_THAT(why(whole.substr(0, length)), HasSubstr("OpenEXR")) << length;
  EXPECT_THAT(why(exr(4, 4, std::vector<Imf::Rgba>(16))), HasSubstr("4 x 4"));
}

TEST(panorama, lies_around_with_plus_x_in_the_middle_and_plus_y_above) {
  Panorama panorama{256, 128, {}};
  for (std::uint32_t y = 0; y < panorama.height; ++y)
    for (std::uint32_t x = 0; x < panorama.width; ++x) {
      // From -x at the left edge over -z to +x in the middle.
      const float turn = (static_cast<float>(x) + 0.5f) / 256.0f * 2.0f * std::numbers::pi_v<float>;
      const float fall = (static_cast<float>(y) + 0.5f) / 128.0f * std::numbers::pi_v<float>;
      const glm::vec3 d(-std::cos(turn) * std::sin(fall), std::cos(fall), -std::sin(turn) * std::sin(fall));
      panorama.texels.push_back(d);
    }
  for (const std::uint32_t size : {16u, 64u, 128u}) {
    const CubeMap cube = cube_from(panorama, size);
    std::size_t at = 0;
    for (std::uint32_t face = 0; face < kCubeFaces; ++face)
      for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x)
          ASSERT_LT(glm::length(cube.texels[at++] - texel_direction(face, x, y, size)), 0.02f) << face << " " << size;
  }
}

TEST(panorama, radiance_with_run_lengths_is_read_and_refused_wherever_it_is_cut) {
  std::string rows;
  for (int y = 0; y < 4; ++y) {
    rows += {2, 2, 0, 8};
    for (const char value : {char(128), char(64), char(32), char(129)})
      rows += {char(128 + 5), value, 3, value, value, value};
  }
  const auto panorama = decoded(radiance(8, 4, rows));
  ASSERT_TRUE(panorama) << panorama.error();
  for (const glm::vec3& texel : panorama->texels) EXPECT_EQ(texel, glm::vec3(1.0f, 0.5f, 0.25f));
  for (std::size_t length = 16; length < rows.size(); ++length)
    EXPECT_THAT(why(radiance(8, 4, rows.substr(0, length))), HasSubstr("run lengths")) << length;
  rows[4] = 0;
  EXPECT_THAT(why(radiance(8, 4, rows)), HasSubstr("run lengths")) << "a run of nothing";
}

TEST(panorama, brightest_light_that_a_file_can_hold_stays_finite) {
  std::string texels;
  for (int i = 0; i < 8 * 4; ++i) texels += {char(255), char(255), char(255), char(255)};  // 255 * 2^119 each
  const auto panorama = decoded(radiance(8, 4, texels));
  ASSERT_TRUE(panorama) << panorama.error();
  const auto sky = make_environment(cube_from(*panorama, 64));
  for (const glm::vec3& coefficient : sky->diffuse) EXPECT_TRUE(std::isfinite(coefficient.x)) << coefficient.x;
  EXPECT_GT(sky->diffuse[0].x, 1e29f);
  for (const CubeMap& level : sky->reflected)
    for (const glm::vec3& texel : level.texels) ASSERT_TRUE(std::isfinite(texel.x)) << level.size;
}

TEST(panorama, small_bright_light_keeps_its_energy_on_a_coarse_cube) {
  Panorama panorama{512, 256, std::vector<glm::vec3>(512 * 256, glm::vec3(0.0f))};
  for (std::uint32_t y = 126; y < 130; ++y)
    for (std::uint32_t x = 300; x < 304; ++x) panorama.texels[y * 512 + x] = glm::vec3(1000.0f);
  const CubeMap cube = cube_from(panorama, 16);
  double light = 0.0;
  std::size_t at = 0;
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < 16; ++y)
      for (std::uint32_t x = 0; x < 16; ++x)
        light += static_cast<double>(cube.texels[at++].x * texel_solid_angle(x, y, 16));
  const double texel = 2.0 * std::numbers::pi / 512.0;  // an angle, at the horizon both ways
  EXPECT_NEAR(light, 16.0 * 1000.0 * texel * texel, 0.15 * 16.0 * 1000.0 * texel * texel);
}

TEST(load_environment, each_file_has_its_own_light_though_the_light_of_one_is_kept) {
  const std::filesystem::path folder = own_path("kept");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const float light : {0.5f, 2.0f, 0.5f}) {
    const std::string path = (folder / "sky.exr").string();
    std::ofstream(path, std::ios::binary) << exr(8, 4, std::vector<Imf::Rgba>(32, Imf::Rgba(light, light, light)));
    for (int run = 0; run < 2; ++run) {
      const auto sky = load_environment(path, DiskCache(folder / "cache"));
      ASSERT_TRUE(sky) << sky.error();
      EXPECT_NEAR((*sky)->diffuse[0].x, light, 1e-3f) << run;
      EXPECT_NEAR((*sky)->reflected.back().texels[0].x, light, 1e-2f) << run;
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(load_environment, knows_its_names_and_reads_files) {
  EXPECT_EQ(load_environment("studio").value(), studio_environment());
  EXPECT_EQ(load_environment("plain").value(), plain_environment());
  EXPECT_EQ(load_environment("none").value(), nullptr);
  EXPECT_THAT(load_environment("no/such.hdr").error(), HasSubstr("no/such.hdr: there is no such file"));
  const std::string path = own_path("sky.exr").string();
  std::ofstream(path, std::ios::binary) << exr(8, 4, std::vector<Imf::Rgba>(32, Imf::Rgba(0.5f, 1.0f, 2.0f)));
  const auto sky = load_environment(path);
  ASSERT_TRUE(sky) << sky.error();
  EXPECT_LT(glm::length((*sky)->diffuse[0] - glm::vec3(0.5f, 1.0f, 2.0f)), 1e-3f);
  EXPECT_EQ((*sky)->reflected[0].size, 256u) << "texels along an edge: what a backdrop shows";
  std::ofstream(path, std::ios::binary) << "text";
  EXPECT_THAT(load_environment(path).error(), HasSubstr("sky.exr: neither"));
  EXPECT_THAT(load_environment("/proc/self/mem").error(), HasSubstr("/proc/self/mem: cannot be read"));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace sinew::viewer
