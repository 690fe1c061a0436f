// SPDX-License-Identifier: MIT
// The flag of the showcase, and its cache.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include "runtime/geometry_cache/geometry_decoder.h"
#include "samples/showcase/flag_cloth.h"
#include "samples/showcase/showcase.h"

namespace sinew::test {
namespace {

using Points = std::vector<glm::vec3>;

const showcase::ClothFrames& flight() {
  static const showcase::ClothFrames frames = showcase::flag_flight();
  return frames;
}

/// The largest movement of a vertex between two frames.
float farthest(const Points& a, const Points& b) {
  float most = 0.0f;
  for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, glm::length(a[v] - b[v]));
  return most;
}

TEST(showcase_flag, repeats_without_a_jump) {
  const auto& frames = flight().frames;
  EXPECT_EQ(frames.front(), frames.back());
  float step = 0.0f;
  for (std::size_t f = 1; f < frames.size(); ++f) step = std::max(step, farthest(frames[f - 1], frames[f]));
  const std::size_t last = frames.size() - 1;
  for (const std::size_t f : {last - 24, last - 1, last})  // where the loop blend begins, and the loop seam
    EXPECT_LE(farthest(frames[f - 1], frames[f]), 0.75f * step) << f;
  EXPECT_LE(farthest(frames[last - 1], frames[last]), 3.0f * farthest(frames[0], frames[1]));
}

TEST(showcase_flag, hangs_on_its_pole_and_keeps_its_size) {
  const auto& cloth = flight();
  const float edge = glm::length(cloth.frames[0][cloth.columns] - cloth.frames[0][0]);
  for (const Points& frame : cloth.frames) {
    for (std::uint32_t r = 0; r < cloth.rows; ++r)
      ASSERT_EQ(frame[r * cloth.columns], cloth.frames[0][r * cloth.columns]) << "row " << r;
    double sum = 0.0;
    for (std::uint32_t r = 0; r < cloth.rows; ++r)
      for (std::uint32_t c = 1; c < cloth.columns; ++c)
        sum += static_cast<double>(glm::length(frame[r * cloth.columns + c] - frame[r * cloth.columns + c - 1]));
    EXPECT_NEAR(sum / (cloth.rows * (cloth.columns - 1.0) * static_cast<double>(edge)), 1.0, 0.15) << "mean edge";
  }
}

TEST(showcase_flag, is_in_the_cache_within_its_budget) {
  const auto file = showcase::flag_cache();
  const auto cache = GeometryCache::open(file);
  ASSERT_TRUE(cache) << cache.error().detail;
  ASSERT_EQ(cache->frame_count(), flight().frames.size());
  ASSERT_EQ(cache->meshes().size(), 1u);
  EXPECT_EQ(cache->meshes()[0].name, showcase::kFlagMesh);
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, file};
  Points decoded(cache->meshes()[0].vertex_count);
  for (std::uint32_t f = 0; f < cache->frame_count(); ++f) {
    ASSERT_EQ(decoder.decode(f, source), GeometryStatus::ok);
    ASSERT_EQ(decoder.write_vertices(0, decoded), GeometryStatus::ok);
    ASSERT_LE(farthest(decoded, flight().frames[f]), showcase::kFlagBudget_m) << "frame " << f;
  }
}

TEST(showcase_flag, lies_flat_in_its_scene_with_the_vertices_of_the_cache) {
  const showcase::ShowcaseScene shown = showcase::flag_in_wind(showcase::flag_cache());
  const auto cache = GeometryCache::open(shown.geometry_cache);
  ASSERT_TRUE(cache);
  const auto& meshes = shown.scene.meshes;
  const auto flag =
      std::find_if(meshes.begin(), meshes.end(), [](const Mesh& m) { return m.name == showcase::kFlagMesh; });
  ASSERT_NE(flag, meshes.end());
  EXPECT_EQ(flag->primitives[0].vertex_count(), cache->meshes()[0].vertex_count);
  EXPECT_EQ(flag->primitives[0].indices, cache->meshes()[0].triangles);
  EXPECT_EQ(flag->primitives[0].positions[0], flight().frames[0][0]) << "it begins at the pole";
}

}  // namespace
}  // namespace sinew::test
