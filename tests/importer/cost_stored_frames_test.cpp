// SPDX-License-Identifier: MIT
// The storage methods that `sinew cost` compares a geometry cache with: their decoded vertices and their sizes.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>
#include <map>

#include "importer/tool/cost/geometry_cache/stored_frames.h"
#include "runtime/base/same_bits.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using cost::PointFrames;

constexpr std::size_t kFrames = 7, kPoints = 37;

PointFrames noise(double size) {
  FixedRandom random(11);
  PointFrames frames(kFrames, std::vector<glm::vec3>(kPoints));
  for (auto& frame : frames)
    for (glm::vec3& point : frame) point = random.vec3(-size, size);
  return frames;
}

/// The decoded frames of each method, by its name.
std::map<std::string, PointFrames> decoded(const PointFrames& frames, double step) {
  std::map<std::string, PointFrames> out;
  for (const cost::NamedFrames& way : cost::stored_ways(frames, step))
    for (std::size_t f = 0; f < frames.size(); ++f) {
      out[way.name].emplace_back(frames[0].size());
      way.frames->decode(f, out[way.name].back());
    }
  return out;
}

void expect_same(const PointFrames& found, const PointFrames& expected, const std::string& name) {
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t f = 0; f < expected.size(); ++f)
    EXPECT_TRUE(same_bits<glm::vec3>(found[f], expected[f])) << name << " frame " << f;
}

PointFrames changed(PointFrames frames, float (*change)(float number, float step), float step) {
  for (auto& frame : frames)
    for (glm::vec3& point : frame)
      for (int axis = 0; axis < 3; ++axis) point[axis] = change(point[axis], step);
  return frames;
}

float as_half(float number, float) { return glm::unpackHalf1x16(glm::packHalf1x16(number)); }
float in_steps(float number, float step) {
  const auto whole = static_cast<std::int32_t>(std::lround(static_cast<double>(number) / static_cast<double>(step)));
  return static_cast<float>(whole) * step;
}

TEST(cost_stored_frames, come_back_as_they_are_rounded) {
  // 16 bits hold numbers of up to 3000 steps, 32 bits those of up to 3 million.
  for (const float step : {0x1p-10f, 0x1p-20f}) {
    const PointFrames frames = noise(3.0);
    const auto found = decoded(frames, static_cast<double>(step));
    ASSERT_EQ(found.size(), 6u);
    expect_same(found.at("floats"), frames, "floats");
    expect_same(found.at("halves"), changed(frames, as_half, 0.0f), "halves");
    for (const char* name : {"zstd -19", "meshopt", "zstd -19, residuals", "meshopt, residuals"})
      expect_same(found.at(name), changed(frames, in_steps, step), name);
  }
}

TEST(cost_stored_frames, halves_of_every_size_are_exact) {
  PointFrames frames(1);
  for (int exponent = -26; exponent < 16; ++exponent)
    for (const float part : {1.0f, 1.25f, 1.9990234375f}) {
      const float number = std::ldexp(part, exponent);
      frames[0].push_back({number, -number, part});
    }
  frames[0].push_back({0.0f, -0.0f, 65504.0f});
  expect_same(decoded(frames, 1.0).at("halves"), changed(frames, as_half, 0.0f), "halves");
}

/// If numbers alternate between -m and m, a prediction by velocity is wrong by 4 m. The product fits into 16 bits for
/// m = 8191, not for 8192.
TEST(cost_stored_frames, numbers_that_do_not_fit_into_16_bits_take_32) {
  for (const float most : {8191.0f, 8192.0f}) {
    PointFrames frames(5, std::vector<glm::vec3>(16, glm::vec3(most)));
    for (std::size_t f = 1; f < frames.size(); f += 2) frames[f].assign(16, glm::vec3(-most));
    for (const auto& [name, found] : decoded(frames, 1.0))
      if (name != "halves") expect_same(found, frames, name);
  }
}

TEST(cost_stored_frames, take_what_their_numbers_take) {
  std::map<std::string, std::size_t> bytes;
  for (const cost::NamedFrames& way : cost::stored_ways(noise(3.0), 0x1p-10)) bytes[way.name] = way.frames->bytes();
  EXPECT_EQ(bytes["floats"], kFrames * kPoints * 12);
  EXPECT_EQ(bytes["halves"], kFrames * kPoints * 6);
  for (const char* name : {"zstd -19", "meshopt"}) {
    EXPECT_GT(bytes[name], kFrames * kPoints * 5) << name << ": noise of 13 bits";
    EXPECT_LT(bytes[name], kFrames * (kPoints * 8 + 64)) << name;
  }
  const auto of_one = cost::stored_ways({noise(3.0)[0]}, 0x1p-10);
  EXPECT_EQ(of_one[0].frames->bytes(), kPoints * 12);
  EXPECT_EQ(of_one[1].frames->bytes(), kPoints * 6);
  PointFrames steady = noise(3.0);
  for (std::size_t f = 1; f < kFrames; ++f)
    for (std::size_t p = 0; p < kPoints; ++p)
      steady[f][p] = steady[0][p] + static_cast<float>(f) * glm::vec3(0.125f, 0.25f, -0.5f);
  for (const cost::NamedFrames& way : cost::stored_ways(steady, 0x1p-10)) bytes[way.name] = way.frames->bytes();
  for (const std::string name : {"zstd -19", "meshopt"})
    EXPECT_LT(2 * bytes[name + ", residuals"], bytes[name]) << name << ": no residual from the third frame on";
}

}  // namespace
}  // namespace sinew::test
