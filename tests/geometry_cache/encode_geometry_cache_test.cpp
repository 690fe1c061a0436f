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

/// Largest error of a decoded vertex of each stream, in double precision.
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
  mesh.streams[0].frames[9][count + 5].x += 0.01f;  // it leaves its twin vertex in the last frame
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

/// One vertex that does not move.
GeometryTake one_point(const glm::vec3& at, double budget) { return take_of({{at}, {at}}, {}, budget); }

TEST(encode_geometry_cache, the_grid_is_as_wide_as_the_budget_less_what_float_rounds_off) {
  // Half the diagonal of a cell is the budget, less 2^-22 of the largest number.
  for (const double budget : {1e-2, 1e-4})
    for (const glm::vec3& at : {glm::vec3(0), glm::vec3(0.25f, 0, 0), glm::vec3(0.125f, -3, 1), glm::vec3(1, 2, 100)}) {
      double largest = 0.0;
      for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(double{at[axis]}));
      const auto file = encode_geometry_cache(one_point(at, budget));
      ASSERT_TRUE(file.has_value());
      EXPECT_EQ(GeometryCache::open(*file)->meshes()[0].streams[0].step,
                static_cast<float>(2.0 * (budget - 0x1p-22 * largest) / std::sqrt(3.0)));
    }
}

TEST(encode_geometry_cache, a_budget_is_at_least_twice_what_float_rounds_off) {
  EXPECT_TRUE(encode_geometry_cache(one_point({0, -1, 0}, 0x1p-21)).has_value());
  EXPECT_FALSE(encode_geometry_cache(one_point({0, -1, 0}, std::nextafter(0x1p-21, 0.0))).has_value());
  EXPECT_TRUE(encode_geometry_cache(one_point({0, 0, 0}, std::nextafter(0x1p-100, 1.0))).has_value());
  EXPECT_FALSE(encode_geometry_cache(one_point({0, 0, 0}, 0x1p-100)).has_value());
  EXPECT_FALSE(encode_geometry_cache(one_point({0, 0, 0}, std::nan(""))).has_value());
}

TEST(encode_geometry_cache, boxes_hold_the_decoded_vertices_and_hardly_more) {
  GeometryTake take = noise_take(90, 7, 1e-3);
  take.meshes.push_back(noise_take(40, 7, 1e-3).meshes[0]);
  take.meshes.push_back(take_of(std::vector(7, std::vector<glm::vec3>(5, {3, 4, 5})), {}).meshes[0]);
  take.meshes.push_back(take_of(std::vector<std::vector<glm::vec3>>(7), {}).meshes[0]);
  for (std::size_t f = 0; f < 7; ++f) {
    const auto away = static_cast<float>(f);
    for (glm::vec3& p : take.meshes[0].streams[0].frames[f]) p = 0.01f * p + glm::vec3(50.0f - 2 * away, 70, -20);
    for (glm::vec3& p : take.meshes[1].streams[0].frames[f]) p.z = -9.0f;  // flat
  }
  const auto file = encode_geometry_cache(take);
  ASSERT_TRUE(file.has_value());
  const auto cache = GeometryCache::open(*file);
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, *file};
  std::vector<Aabb> all(3);
  for (std::uint32_t f = 0; f < 7; ++f) {
    ASSERT_EQ(decoder.decode(f, source), GeometryStatus::ok);
    for (std::size_t m = 0; m < 3; ++m) {
      std::vector<glm::vec3> vertices(take.meshes[m].vertex_count);
      ASSERT_EQ(decoder.write_vertices(m, vertices), GeometryStatus::ok);
      Aabb tight;
      for (const glm::vec3& p : vertices) tight.add(p);
      all[m].add(tight.lower);
      all[m].add(tight.upper);
      const Aabb box = cache->bounds(f, m), whole = cache->meshes()[m].bounds;
      for (int axis = 0; axis < 3; ++axis) {
        const float part = (whole.upper[axis] - whole.lower[axis]) / 65535.0f,
                    ulp = 1e-6f * std::abs(tight.lower[axis]);
        EXPECT_LE(box.lower[axis], tight.lower[axis]);
        EXPECT_GE(box.upper[axis], tight.upper[axis]);
        EXPECT_GE(box.lower[axis], tight.lower[axis] - 2.01f * part - ulp) << "mesh " << m << " frame " << f;
        EXPECT_LE(box.upper[axis], tight.upper[axis] + 2.01f * part + ulp) << "mesh " << m << " frame " << f;
      }
    }
  }
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_EQ(cache->meshes()[m].bounds.lower, all[m].lower) << m;
    EXPECT_EQ(cache->meshes()[m].bounds.upper, all[m].upper) << m;
  }
  EXPECT_EQ(cache->meshes()[3].bounds.lower, glm::vec3(0)) << "without vertices";
  EXPECT_EQ(cache->meshes()[3].bounds.upper, glm::vec3(0));
}

TEST(encode_geometry_cache, between_frames_is_measured_mesh_by_mesh) {
  GeometryTake take = noise_take(6, 4, 1e-3);
  take.meshes[0].streams.push_back({GeometryKind::normals, take.meshes[0].streams[0].frames, 0.1});
  take.meshes.push_back(noise_take(9, 4, 1e-3).meshes[0]);
  TakeMesh& mesh = take.meshes[1];
  for (std::size_t f = 0; f + 1 < 4; ++f) {
    auto& middle = mesh.between.emplace_back();
    const auto& frames = mesh.streams[0].frames;
    for (std::size_t v = 0; v < 9; ++v) middle.push_back(0.5f * (frames[f][v] + frames[f + 1][v]));
  }
  mesh.between[1][4] += glm::vec3(0.3f, 0, -0.4f);
  mesh.between[2][8].y += 0.2f;
  const auto file = encode_geometry_cache(take);
  ASSERT_TRUE(file.has_value());
  const auto cache = GeometryCache::open(*file);
  EXPECT_LT(cache->meshes()[0].certificate.between_m, 0.0) << "its source is not known";
  EXPECT_NEAR(cache->meshes()[1].certificate.between_m, 0.5, 2e-3);
}

TEST(encode_geometry_cache, what_is_refused_is_named) {
  const auto detail_of = [](const GeometryTake& take) {
    const auto file = encode_geometry_cache(take);
    return file ? std::string() : file.error().issue.detail;
  };
  GeometryTake take = noise_take(8, 4, 1e-3);
  take.meshes.push_back(take.meshes[0]);
  take.meshes[1].name = "other";
  take.meshes[1].streams[0].frames[2][5].y = std::numeric_limits<float>::infinity();
  EXPECT_EQ(detail_of(take), "mesh \"other\": vertex 5 is not finite in frame 2");
  take.meshes[1].streams[0].frames[2].pop_back();
  EXPECT_EQ(detail_of(take), "mesh \"other\" has 7 vertices in frame 2, not 8");
  take.meshes[1].streams[0].frames.pop_back();
  EXPECT_EQ(detail_of(take), "mesh \"other\" has 3 frames of 4, or too many vertices");
}

}  // namespace
}  // namespace sinew::test
