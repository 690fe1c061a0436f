// SPDX-License-Identifier: MIT
// Sparse displacements in a file give the same result as dense ones.
#include "importer/build/build_morph_sets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "importer/export_glb.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t kVertices = 4;

/// Four points. Each vertex has one influence more than the vertex before, but the last one has only one. The scene's
/// vertex order is then a cycle of all four, which is not its own inverse.
TinyGltf points() {
  TinyGltf file;
  std::vector<float> weights;
  for (const std::size_t influences : {2u, 3u, 4u, 1u})
    for (std::size_t i = 0; i < 4; ++i)
      weights.push_back(i < influences ? 1.0f / static_cast<float>(influences) : 0.0f);
  file.add_skinned_triangle({0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}, weights)["mode"] = 0;
  Json& primitive = file.root["meshes"][0]["primitives"][0];
  primitive["attributes"]["POSITION"] = file.vec3(std::vector<float>(3 * kVertices, 1.0f));
  file.root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, Json::object()});
  file.root["skins"] = Json::array({{{"joints", {1, 1, 1, 1}}}});
  return file;
}

/// Displacements of four vertices. The first `dense` lie in a view; sparse entries give the others, replacing elements
/// of the view or zeros.
std::size_t add_displacements(TinyGltf& file, const std::vector<float>& deltas, std::uint8_t dense) {
  if (dense == kVertices) return file.vec3(deltas);
  std::vector<std::uint8_t> replaced(kVertices - dense);
  std::iota(replaced.begin(), replaced.end(), dense);
  std::vector<float> base(3 * kVertices, 9.0f);
  std::copy_n(deltas.begin(), 3 * dense, base.begin());
  const std::vector<float> rest(deltas.begin() + 3 * dense, deltas.end());
  Json accessor{{"componentType", 5126}, {"count", kVertices}, {"type", "VEC3"}};
  accessor["sparse"] = {{"count", replaced.size()},
                        {"indices", {{"bufferView", file.add_view(replaced)}, {"componentType", 5121}}},
                        {"values", {{"bufferView", file.add_view(rest)}}}};
  if (dense > 0) accessor["bufferView"] = file.add_view(base);
  file.root["accessors"].push_back(accessor);
  return file.root["accessors"].size() - 1;
}

TEST(build_morph_sets, sparse_and_dense_displacements_are_the_same_of_vertices_in_any_order) {
  for (const int dense : {0, 1, 2, 3, 4}) {
    TinyGltf file = points();
    // The first vertex moves by a tiny amount in one component only; the third does not move.
    const std::size_t deltas =
        add_displacements(file, {1e-30f, 0, 0, 2, 1e-41f, 0, 0, 0, 0, 0, 0, 4}, static_cast<std::uint8_t>(dense));
    file.root["meshes"][0]["primitives"][0]["targets"] = Json::array({{{"POSITION", deltas}}});
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok");
    const Primitive& read = result->scene.meshes[0].primitives[0];
    ASSERT_THAT(read.source_vertex, ElementsAre(3, 0, 1, 2));
    EXPECT_THAT(read.morphs.targets[0].positions.vertices, ElementsAre(0, 2)) << dense;
    EXPECT_THAT(read.morphs.targets[0].positions.deltas, ElementsAre(glm::vec3(0, 0, 4), glm::vec3(2, 0, 0))) << dense;
  }
}

/// Values that number the vertices of the file, `components` per vertex.
std::vector<float> counted(std::size_t components) {
  std::vector<float> out;
  for (std::uint32_t v = 0; v < kVertices; ++v) out.insert(out.end(), components, static_cast<float>(v + 1));
  return out;
}

template <class V>
void expect_in_order_3012(const SparseDeltas<V>& read, const char* what) {
  EXPECT_THAT(read.vertices, ElementsAre(0, 1, 2, 3)) << what;
  std::vector<float> numbers;
  for (const V& delta : read.deltas) numbers.push_back(delta.x);
  EXPECT_THAT(numbers, ElementsAre(4, 1, 2, 3)) << what;
}

TEST(build_morph_sets, displacements_of_every_attribute_follow_their_vertex_here_and_into_a_file) {
  for (const std::size_t color_components : {3u, 4u}) {
    TinyGltf file = points();
    Json& primitive = file.root["meshes"][0]["primitives"][0];
    primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["attributes"]["TANGENT"] = file.vec4({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    primitive["attributes"]["COLOR_0"] = file.vec4(std::vector<float>(4 * kVertices, 0.5f));
    primitive["attributes"]["TEXCOORD_0"] = file.add(std::vector<float>(2 * kVertices), "VEC2", 5126, 2);
    const std::size_t vec3 = file.vec3(counted(3)), vec2 = file.add(counted(2), "VEC2", 5126, 2),
                      color = color_components == 3 ? vec3 : file.vec4(counted(4));
    primitive["targets"] = Json::array(
        {{{"POSITION", vec3}, {"NORMAL", vec3}, {"TANGENT", vec3}, {"COLOR_0", color}, {"TEXCOORD_0", vec2}}});
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok");
    ASSERT_THAT(result->scene.meshes[0].primitives[0].source_vertex, ElementsAre(3, 0, 1, 2));
    const MorphTarget& read = result->scene.meshes[0].primitives[0].morphs.targets.at(0);
    expect_in_order_3012(read.positions, "position");
    expect_in_order_3012(read.normals, "normal");
    expect_in_order_3012(read.tangents, "tangent");
    expect_in_order_3012(read.colors, "color");
    expect_in_order_3012(read.texcoords.at(0), "texcoord");
    const auto bytes = export_glb(result->scene);
    ASSERT_TRUE(bytes);
    const auto again = import_gltf(*bytes, "again.glb");
    ASSERT_EQ(outcome(again), "ok");
    expect_equal(result->scene, again->scene);
  }
}

TEST(build_morph_sets, second_sets_that_the_mesh_does_not_show_leave_the_first_alone) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["COLOR_0"] = file.vec3(std::vector<float>(9, .5f));
  primitive["attributes"]["COLOR_1"] = file.vec3(std::vector<float>(9, .75f));
  primitive["attributes"]["TEXCOORD_0"] = file.add(std::vector<float>(6), "VEC2", 5126, 2);
  primitive["targets"] = Json::array({{{"COLOR_1", file.vec3(std::vector<float>(9, .25f))},
                                       {"TEXCOORD_1", file.add(std::vector<float>(6, .25f), "VEC2", 5126, 2)}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const Primitive& read = result->scene.meshes[0].primitives[0];
  EXPECT_THAT(read.colors, testing::Each(glm::vec4(.5f, .5f, .5f, 1)));
  EXPECT_THAT(read.morphs.targets[0].colors.vertices, IsEmpty());
  EXPECT_THAT(read.morphs.targets[0].texcoords, IsEmpty());
  for (const std::string name : {"COLOR_1", "TEXCOORD_1"})
    EXPECT_TRUE(warns(result, "morph-no-base", "/meshes/0/primitives/0/targets/0/" + name)) << name;
}

TEST(build_morph_sets, targets_have_names_where_each_has_one) {
  const std::vector<std::string> lists[] = {{"a"}, {"a", "b"}, {"a", "b", "c"}};
  for (const auto& names : lists) {
    TinyGltf file;
    file.add_triangle()["targets"] = Json::array({{{"POSITION", 0}}, {{"POSITION", 0}}});
    file.root["meshes"][0]["extras"]["targetNames"] = names;
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok") << names.size();
    EXPECT_EQ(result->scene.meshes[0].target_names, names.size() == 2 ? names : std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace sinew::test
