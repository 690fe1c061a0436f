// SPDX-License-Identifier: MIT
#include "importer/tool/bake/bake_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "importer/import_gltf.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using tool::bake_scene;

/// The model of the tool tests with colours on its triangle. A node, not a bone, scales the triangle.
Scene coloured_scene(float alpha) {
  const ToolModelFile model;
  auto file = import_gltf(model.path());
  EXPECT_TRUE(file.has_value());
  for (Mesh& mesh : file->scene.meshes)
    for (Primitive& primitive : mesh.primitives)
      if (primitive.influences.empty())
        for (std::size_t v = 0; v < primitive.vertex_count(); ++v)
          primitive.colors.emplace_back(0.25f * static_cast<float>(v), 0.5f, 1.0f, alpha);
  return std::move(file->scene);
}

TEST(bake_scene, normals_and_colours_are_streams_where_they_are_asked_for_and_there) {
  const Scene scene = coloured_scene(1.0f);
  const auto plain = bake_scene(scene, 0, 10.0, {});
  ASSERT_TRUE(plain.has_value());
  for (const TakeMesh& mesh : plain->take.meshes) EXPECT_EQ(mesh.streams.size(), 1u);
  const auto baked = bake_scene(scene, 0, 10.0, {.normals_rad = 0.01, .colors = 0.004});
  ASSERT_TRUE(baked.has_value());
  EXPECT_THAT(baked->left_out, testing::Each(testing::Not(testing::HasSubstr("alpha"))));
  std::size_t coloured = 0;
  for (const TakeMesh& mesh : baked->take.meshes) {
    ASSERT_GE(mesh.streams.size(), 2u);
    EXPECT_EQ(mesh.streams[1].kind, GeometryKind::normals);
    EXPECT_EQ(mesh.streams[1].budget, std::sin(0.01));
    for (const TakeStream& stream : mesh.streams) EXPECT_EQ(stream.frames.size(), 11u);
    for (const auto& frame : mesh.streams[1].frames)
      for (const glm::vec3& n : frame) EXPECT_NEAR(glm::length(n), 1.0f, 1e-5f);
    if (mesh.streams.size() < 3) continue;
    ++coloured;
    EXPECT_EQ(mesh.streams[2].kind, GeometryKind::colors);
    EXPECT_EQ(mesh.streams[2].frames[7][2], glm::vec3(0.5f, 0.5f, 1.0f));
  }
  EXPECT_EQ(coloured, 1u);
}

TEST(bake_scene, normals_turn_with_the_node_of_their_mesh) {
  Scene scene = coloured_scene(1.0f);
  for (const MeshInstance& instance : scene.instances)
    if (instance.skin == kNone) scene.skeleton.rest[instance.joint].rotation = quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f);
  const auto baked = bake_scene(scene, kNone, 10.0, {.normals_rad = 0.01});
  ASSERT_TRUE(baked.has_value());
  for (const TakeMesh& mesh : baked->take.meshes)
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += 3) {
      const auto at = [&](std::size_t k) { return mesh.streams[0].frames[0][mesh.triangles[corner + k]]; };
      const glm::vec3 across = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
      EXPECT_NEAR(glm::dot(across, mesh.streams[1].frames[0][mesh.triangles[corner]]), 1.0f, 1e-5f) << mesh.name;
    }
}

TEST(bake_scene, decoded_normals_stay_within_their_angle) {
  const double angle_rad = 0.02;
  const auto baked = bake_scene(coloured_scene(1.0f), 0, 30.0, {.normals_rad = angle_rad});
  ASSERT_TRUE(baked.has_value());
  const auto file = encode_geometry_cache(baked->take);
  ASSERT_TRUE(file.has_value());
  const auto cache = GeometryCache::open(*file);
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, *file};
  for (std::uint32_t f = 0; f < cache->frame_count(); ++f) {
    ASSERT_EQ(decoder.decode(f, source), GeometryStatus::ok);
    std::size_t stream = 0;
    for (const TakeMesh& mesh : baked->take.meshes) {
      std::vector<glm::vec3> shown(mesh.vertex_count);
      ASSERT_EQ(decoder.write_vertices(stream + 1, shown), GeometryStatus::ok);
      for (std::size_t v = 0; v < shown.size(); ++v) {
        const glm::dvec3 truth = mesh.streams[1].frames[f][v], n = glm::normalize(glm::dvec3(shown[v]));
        EXPECT_LE(std::asin(glm::length(glm::cross(truth, n))), angle_rad * 1.0001);
      }
      stream += mesh.streams.size();
    }
  }
}

TEST(bake_scene, what_a_stream_cannot_hold_is_told) {
  const auto baked = bake_scene(coloured_scene(0.5f), 0, 10.0, {.colors = 0.004});
  ASSERT_TRUE(baked.has_value());
  EXPECT_THAT(baked->left_out, testing::Contains(testing::HasSubstr("alpha")));
}

TEST(bake_scene, hidden_meshes_are_baked_as_if_they_were_shown) {
  const Scene shown = coloured_scene(1.0f);
  Scene hidden = shown;
  for (const MeshInstance& instance : hidden.instances) hidden.hidden_joints.push_back(instance.joint);
  finish_scene(hidden);
  const auto expected = bake_scene(shown, 1, 10.0, {}), baked = bake_scene(hidden, 1, 10.0, {});
  ASSERT_TRUE(expected && baked);
  ASSERT_EQ(baked->take.meshes.size(), expected->take.meshes.size());
  for (std::size_t m = 0; m < baked->take.meshes.size(); ++m)
    EXPECT_EQ(baked->take.meshes[m].streams[0].frames, expected->take.meshes[m].streams[0].frames) << m;
}

TEST(bake_scene, a_clip_that_ends_with_a_frame_but_for_rounding_has_that_frame) {
  Scene scene = coloured_scene(1.0f);
  scene.animations[0].duration_s = static_cast<double>(0.7f);  // slightly below 0.7 in double
  ASSERT_LT(scene.animations[0].duration_s * 10.0, 7.0);
  const auto baked = bake_scene(scene, 0, 10.0, {});
  ASSERT_TRUE(baked);
  EXPECT_EQ(baked->take.meshes[0].streams[0].frames.size(), 8u);
}

}  // namespace
}  // namespace sinew::test
