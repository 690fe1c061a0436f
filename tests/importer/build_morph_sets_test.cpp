// SPDX-License-Identifier: MIT
// Displacements that a file stores sparse mean what they mean when each vertex has one.
#include "importer/build/build_morph_sets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t kVertices = 4;

/// Four points; a vertex has one influence more than the one before but the last, which has one. So the order of the
/// scene is a cycle of all, and not its own inverse.
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

/// Displacements of all four vertices, in an accessor that stores each, or only the values and their places.
std::size_t add_displacements(TinyGltf& file, const std::vector<float>& deltas, bool sparse) {
  if (!sparse) return file.vec3(deltas);
  std::vector<std::uint8_t> all(kVertices);
  std::iota(all.begin(), all.end(), std::uint8_t{0});
  const Json indices{{"bufferView", file.add_view(all)}, {"componentType", 5121}};
  const Json replaced{{"count", kVertices}, {"indices", indices}, {"values", {{"bufferView", file.add_view(deltas)}}}};
  file.root["accessors"].push_back(
      {{"componentType", 5126}, {"count", kVertices}, {"type", "VEC3"}, {"sparse", replaced}});
  return file.root["accessors"].size() - 1;
}

TEST(build_morph_sets, sparse_and_dense_displacements_are_the_same_of_vertices_in_any_order) {
  for (const bool sparse : {false, true}) {
    TinyGltf file = points();
    // The first moves by too little to show, in one component alone; the third does not move.
    const std::size_t deltas = add_displacements(file, {1e-30f, 0, 0, 2, 1e-41f, 0, 0, 0, 0, 0, 0, 4}, sparse);
    file.root["meshes"][0]["primitives"][0]["targets"] = Json::array({{{"POSITION", deltas}}});
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok");
    const Primitive& read = result->scene.meshes[0].primitives[0];
    ASSERT_THAT(read.source_vertex, ElementsAre(3, 0, 1, 2));
    EXPECT_THAT(read.morphs.targets[0].positions.vertices, ElementsAre(0, 2)) << sparse;
    EXPECT_THAT(read.morphs.targets[0].positions.deltas, ElementsAre(glm::vec3(0, 0, 4), glm::vec3(2, 0, 0))) << sparse;
  }
}

TEST(build_morph_sets, displaced_colors_of_a_second_set_leave_the_first_alone) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["COLOR_0"] = primitive["attributes"]["COLOR_1"] = file.vec3(std::vector<float>(9, .5f));
  primitive["targets"] = Json::array({{{"COLOR_1", file.vec3(std::vector<float>(9, .25f))}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->scene.meshes[0].primitives[0].morphs.targets[0].colors.vertices, IsEmpty());
  EXPECT_TRUE(warns(result, "morph-no-base", "/meshes/0/primitives/0/targets/0/COLOR_1"));
}

}  // namespace
}  // namespace sinew::test
