// SPDX-License-Identifier: MIT
// Sizes of coarse meshes, whose blocks of 64 points are a good part of the model. Version 1 took 20.1 and 11.9 %.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

constexpr std::uint32_t kFrames = 40;

double of_raw_floats(const GeometryTake& take) {
  const auto file = encode_geometry_cache(take);
  EXPECT_LE(GeometryCache::open(*file)->meshes()[0].certificate.measured_m, 1e-4);
  return static_cast<double>(file->size()) / (12.0 * take.meshes[0].vertex_count * kFrames);
}

/// A torus of 80 x 40 points that twists, bends and waves.
GeometryTake torus_take() {
  constexpr std::uint32_t kAround = 80, kAcross = 40;
  std::vector<std::vector<glm::vec3>> frames(kFrames);
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t f = 0; f < kFrames; ++f) {
    const double t = 0.3 + f / 30.0;
    for (std::uint32_t n = 0; n < kAround * kAcross; ++n) {
      const double u = 2.0 * M_PI * (n % kAround) / kAround, v = 2.0 * M_PI * (n / kAround) / kAcross;
      const double r = 0.35 + 0.05 * std::sin(3.0 * u + 4.0 * t), far = 1.0 + r * std::cos(v);
      const double x = far * std::cos(u), y = r * std::sin(v), z = far * std::sin(u);
      const double twist = 1.2 * std::sin(2.1 * t) * x, bend = 0.5 * std::sin(1.3 * t);
      const double high = 1.0 / bend + y * std::cos(twist) - z * std::sin(twist);
      const double along = high * std::sin(x * bend);
      frames[f].emplace_back(along, high * std::cos(x * bend) - 1.0 / bend,
                             y * std::sin(twist) + z * std::cos(twist) + 0.1 * std::sin(4.0 * along + 6.0 * t));
    }
  }
  for (std::uint32_t n = 0; n < kAround * kAcross; ++n) {
    const std::uint32_t row = n / kAround * kAround, next = (row + kAround) % (kAround * kAcross);
    const std::uint32_t i = n % kAround, j = (i + 1) % kAround;
    triangles.insert(triangles.end(), {row + i, row + j, next + j, row + i, next + j, next + i});
  }
  return take_of(std::move(frames), std::move(triangles));
}

TEST(coarse_meshes, a_cloth_in_a_storm_takes_a_seventh_less_than_in_version_1) {
  const showcase::FlagWind storm{.speed = 9.0, .gust = 9.4, .lift = 7.8, .swing = 11.6, .wave = 24.0};
  showcase::ClothFrames cloth = showcase::fly_flag(
      {.columns = 49, .rows = 49, .spacing_m = 0.04, .pieces = 1, .frame_count = kFrames, .wind = storm});
  const GeometryTake take = take_of(std::move(cloth.frames), std::move(cloth.triangles));
  EXPECT_LT(of_raw_floats(take), 0.170);
}

TEST(coarse_meshes, a_torus_that_bends_and_twists_takes_a_tenth_less_than_in_version_1) {
  EXPECT_LT(of_raw_floats(torus_take()), 0.108);
}

}  // namespace
}  // namespace sinew::test
