// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/bind_geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/geometry_cache/scene_of_cache.h"
#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two quads of two triangles each, from which the cache is baked.
GeometryTake two_quads() {
  GeometryTake take = take_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {0, 1, 2, 2, 1, 3});
  take.meshes.push_back(take.meshes[0]);
  take.meshes[0].name = "sail 0";
  take.meshes[1].name = "flag";
  return take;
}

class bind_geometry : public testing::Test {
 protected:
  bind_geometry() {
    MappedFrames frames{cache_, file_};
    scene_ = scene_of(cache_, frames)->scene;
  }

  /// The first quad with a seam along its diagonal and another vertex order.
  static Primitive split_quad() {
    Primitive quad;
    quad.positions = {{1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
    quad.indices = {5, 4, 3, 1, 2, 0};
    return quad;
  }

  std::vector<std::byte> file_ = *encode_geometry_cache(two_quads());
  GeometryCache cache_ = *GeometryCache::open(file_);
  Scene scene_;
};

TEST_F(bind_geometry, vertices_that_are_split_or_reordered_are_matched_corner_for_corner) {
  EXPECT_THAT(*match_vertices(cache_.meshes()[0], split_quad()), ElementsAre(3u, 2u, 1u, 2u, 1u, 0u));
  Primitive other = split_quad();
  other.indices[0] = 0;  // vertex 0 would match two vertices of the cache
  EXPECT_EQ(match_vertices(cache_.meshes()[0], other).error(), ErrorCode::unsupported);
  other.indices.resize(3);
  EXPECT_EQ(match_vertices(cache_.meshes()[0], other).error(), ErrorCode::size_mismatch);
  Primitive more = scene_.meshes[0].primitives[0];
  ASSERT_EQ(match_vertices(cache_.meshes()[0], more)->size(), 4u);
  more.positions.emplace_back();  // part of no triangle
  EXPECT_EQ(match_vertices(cache_.meshes()[0], more).error(), ErrorCode::size_mismatch);
}

TEST(scene_of_cache, without_triangles_a_mesh_is_its_points) {
  const std::vector<std::byte> file = *encode_geometry_cache(two_quads(), {.keep_triangles = false});
  const GeometryCache cache = *GeometryCache::open(file);
  MappedFrames frames{cache, file};
  const Scene scene = scene_of(cache, frames)->scene;
  ASSERT_EQ(scene.meshes.size(), 2u);
  for (const Mesh& mesh : scene.meshes) {
    EXPECT_EQ(mesh.primitives[0].topology, Topology::points);
    EXPECT_THAT(mesh.primitives[0].indices, ElementsAre(0u, 1u, 2u, 3u));
    EXPECT_TRUE(mesh.primitives[0].normals.empty());
  }
}

TEST_F(bind_geometry, without_triangles_the_order_is_that_of_the_mesh) {
  const std::vector<std::byte> file = *encode_geometry_cache(two_quads(), {.keep_triangles = false});
  const GeometryCache cache = *GeometryCache::open(file);
  EXPECT_THAT(*match_vertices(cache.meshes()[0], scene_.meshes[0].primitives[0]), ElementsAre(0u, 1u, 2u, 3u));
  EXPECT_EQ(match_vertices(cache.meshes()[0], split_quad()).error(), ErrorCode::size_mismatch);
}

TEST_F(bind_geometry, names_are_those_of_meshes_and_of_their_primitives) {
  scene_.meshes[0].name = "sail";
  scene_.meshes[0].primitives.push_back(split_quad());
  const GeometryBindings in_part = bind_by_name(cache_, scene_);
  ASSERT_EQ(in_part.bound.size(), 1u) << "the flag; of the sail there is one primitive of two";
  EXPECT_EQ(in_part.bound[0].instance, 1u);
  EXPECT_THAT(in_part.unbound, ElementsAre(HasSubstr("some of its primitives only")));
  EXPECT_EQ(check(cache_, scene_, in_part.bound), ErrorCode::ok);
  scene_.meshes[1].name = "pennant";
  EXPECT_THAT(bind_by_name(cache_, scene_).unbound,
              ElementsAre(HasSubstr("some of its primitives only"), HasSubstr("\"flag\" of the cache: no such name")));
}

TEST_F(bind_geometry, instances_of_one_name_take_the_meshes_of_that_name_in_order) {
  GeometryTake take = two_quads();
  take.meshes[0].name = take.meshes[1].name = "flag";
  const std::vector<std::byte> file = *encode_geometry_cache(take);
  const GeometryCache cache = *GeometryCache::open(file);
  scene_.meshes[0].name = "flag";
  scene_.instances[1].mesh = 0;
  const GeometryBindings bindings = bind_by_name(cache, scene_);
  ASSERT_EQ(bindings.bound.size(), 2u);
  EXPECT_EQ(bindings.bound[0].mesh, 0u);
  EXPECT_EQ(bindings.bound[1].mesh, 1u);
  EXPECT_TRUE(bindings.unbound.empty());
}

TEST_F(bind_geometry, other_triangles_are_named) {
  scene_.meshes[1].primitives[0].indices = {0, 1, 2};
  const GeometryBindings bindings = bind_by_name(cache_, scene_);
  EXPECT_THAT(bindings.unbound, testing::Contains(HasSubstr("the triangles of \"flag\" are others")));
}

TEST_F(bind_geometry, explicit_bindings_are_checked) {
  const auto code = [&](std::vector<GeometryBinding> bindings) { return check(cache_, scene_, bindings); };
  EXPECT_EQ(code({{0, 0, 1}, {1, 0, 0}}), ErrorCode::ok);
  EXPECT_EQ(code({}), ErrorCode::ok);
  EXPECT_EQ(code({{2, 0, 0}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({{0, 1, 0}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({{0, 0, 2}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({{0, 0, 0}, {0, 0, 1}}), ErrorCode::unsupported) << "one primitive twice";
  scene_.meshes[0].primitives.push_back(split_quad());
  EXPECT_EQ(code({{0, 0, 0}}), ErrorCode::unsupported) << "one primitive of two";
  EXPECT_EQ(code({{0, 1, 0}, {0, 0, 0}}), ErrorCode::ok);
  scene_.meshes[1].primitives[0].indices.resize(3);
  EXPECT_EQ(code({{1, 0, 0}}), ErrorCode::size_mismatch);
}

}  // namespace
}  // namespace sinew::test
