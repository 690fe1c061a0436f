// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/encode_geometry_cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "runtime/geometry_cache/geometry_decoder.h"
#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

/// Largest distance of any decoded vertex from its source, in double precision, stream by stream.
std::vector<double> errors_of(const GeometryTake& take, const std::vector<std::byte>& file) {
  const auto cache = GeometryCache::open(file);
  EXPECT_TRUE(cache.has_value());
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, file};
  std::vector<double> errors(cache->stream_count(), 0.0);
  for (std::uint32_t f = 0; f < cache->frame_count(); ++f) {
    EXPECT_EQ(decoder.decode(f, source), GeometryStatus::ok);
    std::size_t stream = 0;
    for (const TakeMesh& mesh : take.meshes)
      for (const TakeStream& truth : mesh.streams) {
        std::vector<glm::vec3> vertices(mesh.vertex_count);
        EXPECT_EQ(decoder.write_vertices(stream, vertices), GeometryStatus::ok);
        for (std::size_t v = 0; v < vertices.size(); ++v)
          errors[stream] =
              std::max(errors[stream], glm::distance(glm::dvec3(vertices[v]), glm::dvec3(truth.frames[f][v])));
        ++stream;
      }
  }
  return errors;
}

TEST(encode_geometry_cache, no_vertex_of_any_frame_leaves_the_budget_and_the_certificate_says_how_far_it_went) {
  for (const double budget : {1e-2, 1e-3, 1e-4, 1e-5})
    for (const GeometryTake& take : {flag_take(20, budget), noise_take(150, 5, budget)}) {
      const auto file = encode_geometry_cache(take);
      ASSERT_TRUE(file.has_value());
      const double error = errors_of(take, *file)[0];
      EXPECT_LE(error, budget);
      EXPECT_GT(error, 0.5 * budget) << "the budget is used";
      const GeometryCertificate certificate = GeometryCache::open(*file)->meshes()[0].certificate;
      EXPECT_EQ(certificate.asked_m, budget);
      EXPECT_EQ(certificate.measured_m, error);
      EXPECT_LT(certificate.between_m, 0.0);
    }
}

TEST(encode_geometry_cache, a_flag_takes_a_small_part_of_its_floats) {
  const GeometryTake take = flag_take(60);
  const auto file = encode_geometry_cache(take);
  ASSERT_TRUE(file.has_value());
  const double raw = 12.0 * take.meshes[0].vertex_count * 60.0;
  EXPECT_LT(static_cast<double>(file->size()), 0.2 * raw);
}

TEST(encode_geometry_cache, a_mesh_that_stands_still_takes_next_to_nothing_after_its_first_frame) {
  GeometryTake take = flag_take(2);
  take.meshes[0].streams[0].frames.assign(30, take.meshes[0].streams[0].frames[1]);
  const auto file = encode_geometry_cache(take);
  ASSERT_TRUE(file.has_value());
  const auto cache = GeometryCache::open(*file);
  for (std::uint32_t f = 1; f < 30; ++f) EXPECT_LT(cache->frames()[f].size, 60u);
}

TEST(encode_geometry_cache, a_turning_stiff_mesh_is_a_motion_and_little_else) {
  GeometryTake take = flag_take(2);
  auto& frames = take.meshes[0].streams[0].frames;
  const std::vector<glm::vec3> rest = frames[1];
  frames.assign(24, rest);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const double angle = 0.15 * static_cast<double>(f);
    for (std::size_t v = 0; v < rest.size(); ++v)
      frames[f][v] = glm::vec3(glm::dvec3(std::cos(angle) * rest[v].x - std::sin(angle) * rest[v].y,
                                          std::sin(angle) * rest[v].x + std::cos(angle) * rest[v].y, rest[v].z));
  }
  const auto file = encode_geometry_cache(take);
  ASSERT_TRUE(file.has_value());
  const auto cache = GeometryCache::open(*file);
  for (std::uint32_t f = 2; f < 24; ++f)
    EXPECT_LT(cache->frames()[f].size, rest.size() * 12 / 12) << "frame " << f << ": less than 8 bits a vertex";
}

TEST(encode_geometry_cache, vertices_that_never_part_are_one_point) {
  GeometryTake take = flag_take(10);
  TakeMesh& mesh = take.meshes[0];
  const std::uint32_t count = mesh.vertex_count;
  for (auto& frame : mesh.streams[0].frames) frame.insert(frame.end(), frame.begin(), frame.begin() + count);
  mesh.vertex_count = 2 * count;
  mesh.streams[0].frames[9][count + 5].x += 0.01f;  // this one parts from its twin in the last frame
  const auto file = encode_geometry_cache(take);
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(GeometryCache::open(*file)->meshes()[0].streams[0].point_count, count + 1);
  EXPECT_LE(errors_of(take, *file)[0], 1e-4);
}

TEST(encode_geometry_cache, streams_of_normals_and_several_meshes_keep_their_own_budgets) {
  GeometryTake take = flag_take(12);
  take.meshes.push_back(noise_take(70, 12, 1e-3).meshes[0]);
  TakeStream normals{GeometryKind::normals, {}, 0.01};
  FixedRandom random(2);
  for (int f = 0; f < 12; ++f) {
    auto& frame = normals.frames.emplace_back();
    for (std::uint32_t v = 0; v < take.meshes[0].vertex_count; ++v) frame.push_back(random.direction());
  }
  take.meshes[0].streams.push_back(normals);
  const auto file = encode_geometry_cache(take, {.segment_frames = 5});
  ASSERT_TRUE(file.has_value());
  const std::vector<double> errors = errors_of(take, *file);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_LE(errors[0], 1e-4);
  EXPECT_LE(errors[1], 0.01);
  EXPECT_LE(errors[2], 1e-3);
  EXPECT_GT(errors[2], 5e-4);
  const auto cache = GeometryCache::open(*file);
  std::size_t stream = 0;
  for (const GeometryMesh& mesh : cache->meshes())
    for (const GeometryStream& measured : mesh.streams) EXPECT_EQ(measured.measured, errors[stream++]);
  EXPECT_EQ(cache->meshes()[0].streams[1].asked, 0.01);
}

TEST(encode_geometry_cache, the_smallest_takes) {
  for (const std::uint32_t points : {0u, 1u, 63u, 64u, 65u})
    for (const std::uint32_t frames : {1u, 2u, 3u}) {
      const GeometryTake take = noise_take(points, frames);
      const auto file = encode_geometry_cache(take, {.segment_frames = 2});
      ASSERT_TRUE(file.has_value()) << points << " points, " << frames << " frames";
      EXPECT_LE(errors_of(take, *file)[0], 1e-4);
    }
}

TEST(encode_geometry_cache, between_frames_is_measured_where_the_source_is_known) {
  GeometryTake take = flag_take(10);
  TakeMesh& mesh = take.meshes[0];
  const auto& frames = mesh.streams[0].frames;
  for (std::size_t f = 0; f + 1 < frames.size(); ++f) {
    auto& middle = mesh.between.emplace_back();
    for (std::size_t v = 0; v < frames[f].size(); ++v) middle.push_back(0.5f * (frames[f][v] + frames[f + 1][v]));
  }
  mesh.between[4][77].z += 0.02f;
  const auto file = encode_geometry_cache(take);
  ASSERT_TRUE(file.has_value());
  EXPECT_NEAR(GeometryCache::open(*file)->meshes()[0].certificate.between_m, 0.02, 2e-4);
}

TEST(encode_geometry_cache, what_cannot_be_baked_is_refused_by_rule) {
  const auto rule_of = [](const GeometryTake& take) {
    const auto file = encode_geometry_cache(take);
    return file ? std::string() : file.error().issue.rule;
  };
  GeometryTake take = flag_take(4);
  take.meshes[0].streams[0].frames[2][5].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(rule_of(take), "cache-values");
  take = flag_take(4);
  take.meshes[0].streams[0].frames[3].pop_back();
  EXPECT_EQ(rule_of(take), "cache-frames");
  take = flag_take(4);
  take.meshes.push_back(flag_take(3).meshes[0]);
  EXPECT_EQ(rule_of(take), "cache-frames");
  EXPECT_EQ(rule_of({}), "cache-frames");
  take = flag_take(4);
  take.meshes[0].triangles.push_back(0);
  EXPECT_EQ(rule_of(take), "cache-triangles");
  take.meshes[0].triangles = {0, 1, take.meshes[0].vertex_count};
  EXPECT_EQ(rule_of(take), "cache-triangles");
  EXPECT_EQ(rule_of(flag_take(4, 1e-9)), "cache-budget");
  EXPECT_EQ(rule_of(flag_take(4, 0.0)), "cache-budget");
}

}  // namespace
}  // namespace sinew::test
