// SPDX-License-Identifier: MIT
// Pictures of geometry caches, compared with the reference renderer, which gets its vertices directly from the decoder.
#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/plan/run_plan.h"
#include "samples/showcase/showcase.h"
#include "tests/viewer/cache_files.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/app/cache/cache_playback.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

class cache_picture : public DeviceTest {};

View view_of_flag() { return look_at({1.0, -0.2, 2.2}, {0.35, -0.3, 0.0}, 0.5, 0.05); }

RenderOptions without_occlusion() {
  RenderOptions options;
  options.ao.on = false;
  return options;
}

/// Area-weighted normals in double precision, one for each vertex: no two vertices of these flags share a place.
std::vector<glm::vec3> normals_of(const std::vector<glm::vec3>& points, const std::vector<std::uint32_t>& triangles) {
  std::vector<glm::dvec3> sums(points.size(), glm::dvec3(0.0));
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const glm::dvec3 a(points[triangles[t]]), b(points[triangles[t + 1]]), c(points[triangles[t + 2]]);
    for (std::size_t corner = 0; corner < 3; ++corner) sums[triangles[t + corner]] += glm::cross(b - a, c - a);
  }
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& sum : sums) normals.emplace_back(glm::normalize(sum));
  return normals;
}

/// The vertices of a frame, through the decoder alone.
std::vector<glm::vec3> points_of(const Bytes& bytes, std::uint32_t frame) {
  const auto cache = GeometryCache::open(bytes);
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, bytes};
  std::vector<glm::vec3> points(cache->meshes()[0].vertex_count);
  EXPECT_EQ(decoder.decode(frame, source), GeometryStatus::ok);
  EXPECT_EQ(decoder.write_vertices(0, points), GeometryStatus::ok);
  return points;
}

/// Frame and pictures of a scene on which a cache plays, as the program makes them.
class Pictures {
 public:
  Pictures(const Scene& scene, const CacheOnScene& cache, CacheReader::Reads reads = CacheReader::Reads::blocking)
      : cache_(cache, scene, reads),
        plan_(compile_plan(lend(scene), needs(cache))),
        frame_(plan_),
        headless_(*test_device(), scene, 96, 80) {}

  const FrameResult& at(double time_s, float weight = 1.0f) {
    FrameInput input;
    input.geometry = cache_.at(time_s, weight);
    EXPECT_EQ(run_plan(plan_, input, frame_), ErrorCode::ok);
    return frame_.result();
  }

  Picture picture(double time_s, const View& view, float weight = 1.0f) {
    return headless_.render(at(time_s, weight), view, without_occlusion());
  }

 private:
  static Needs needs(const CacheOnScene& cache) {
    Needs needs;
    needs.in.cached_instances = cache.instances();
    needs.out.bounds = true;
    return needs;
  }

  CachePlayback cache_;
  Plan plan_;
  FrameBuffer frame_;
  Headless headless_;
};

int largest_step(const Picture& a, const Picture& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
  return most;
}

TEST_F(cache_picture, is_that_of_the_reference_renderer_for_the_vertices_of_the_decoder) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  Pictures pictures(alone.scene, *alone.cache);
  for (const std::uint32_t frame : {0u, 11u, 19u}) {
    BuiltScene built;
    Primitive flag = alone.scene.meshes[0].primitives[0];
    const std::uint32_t instance = built.add(flag, built.add_material(alone.scene.materials[0]));
    const std::vector<glm::vec3> points = points_of(bytes, frame);
    built.deform(instance, points, normals_of(points, flag.indices));
    expect_reference_picture(built, view_of_flag(), without_occlusion(), {.sharp = 0.5});
    Headless other_way(*test_device(), built.scene, 96, 80);
    const Picture expected = other_way.render(built.frame(), view_of_flag(), without_occlusion());
    EXPECT_LE(largest_step(pictures.picture(frame / 30.0, view_of_flag()), expected), 1) << frame;
  }
}

TEST_F(cache_picture, on_a_scene_replaces_the_mesh_of_its_name_and_nothing_else) {
  const showcase::ShowcaseScene shown = showcase::flag_in_wind(showcase::flag_cache());
  const auto cache = *bind_cache(*open_cache_bytes("flag", showcase::flag_cache()), shown.scene, {});
  Pictures pictures(shown.scene, *cache);
  const View view = look_at(shown.eye, shown.target, 0.58, 0.05);
  const auto bytes = showcase::flag_cache();
  const std::vector<glm::vec3> points = points_of({bytes.begin(), bytes.end()}, 30);

  Scene posed = shown.scene;
  Primitive& flag = posed.meshes[0].primitives[0];
  flag.positions = points;
  flag.normals = normals_of(points, flag.indices);
  flag.bounds = {};
  for (const glm::vec3& p : points) flag.bounds.add(p);
  const Plan plan = compile_plan(lend(posed), {});
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  Headless other_way(*test_device(), posed, 96, 80);
  const Picture expected = other_way.render(frame.result(), view, without_occlusion());
  const Picture flat = pictures.picture(1.0, view, 0.0f);
  EXPECT_LE(largest_step(pictures.picture(1.0, view), expected), 1);
  EXPECT_GT(largest_step(flat, expected), 50) << "without weight the flag is flat";
}

TEST_F(cache_picture, order_of_times_changes_no_byte) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  Pictures forward(alone.scene, *alone.cache), other(alone.scene, *alone.cache);
  const std::vector<double> times = {0.0, 0.1, 0.25, 0.4, 0.5, 0.62};
  std::vector<Picture> expected;
  for (const double t : times) expected.push_back(forward.picture(t, view_of_flag()));
  for (const std::size_t i : {5u, 2u, 0u, 4u, 1u, 3u, 1u})
    EXPECT_EQ(other.picture(times[i], view_of_flag()).rgba, expected[i].rgba) << times[i];
  EXPECT_NE(expected[0].rgba, expected[3].rgba);
}

TEST_F(cache_picture, vertices_that_have_not_changed_are_not_uploaded_again) {
  const Bytes bytes = flag_bytes();
  const CacheAlone alone = flag_alone(bytes);
  Pictures pictures(alone.scene, *alone.cache);
  FrameUpload upload(*test_device(), alone.scene, 1);
  upload.update(0, pictures.at(0.2), 1);
  EXPECT_EQ(upload.last_update().written, 1u);
  upload.update(0, pictures.at(0.2), 1);
  EXPECT_EQ(upload.last_update().written, 0u) << "paused";
  upload.update(0, pictures.at(0.25), 1);
  EXPECT_EQ(upload.last_update().written, 1u);
  upload.update(0, pictures.at(5.0), 1);
  upload.update(0, pictures.at(6.0), 1);
  EXPECT_EQ(upload.last_update().written, 0u) << "after the last frame nothing moves";
}

}  // namespace
}  // namespace sinew::viewer
