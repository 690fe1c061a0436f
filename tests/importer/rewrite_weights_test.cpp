// SPDX-License-Identifier: MIT
// Weights of files that are rewritten with `quantize`.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/importer/recoded.h"

namespace sinew::test {
namespace {

TEST(rewrite_weights, the_weight_that_rounding_moved_farthest_takes_what_is_left) {
  TinyGltf gltf;
  gltf.add_skinned_triangle(std::vector<std::uint8_t>(12), {.2f, .5f, .3f, 0, 0, .5f, .5f, 0, .1f, .1f, .1f, .7f});
  const std::vector<std::byte> bytes = bytes_of(recoded(gltf, how(true, false)).parts, "WEIGHTS_0");
  const int expected[] = {51, 127, 77, 0, 0, 127, 128, 0, 25, 26, 26, 178};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(static_cast<int>(bytes.at(i)), expected[i]) << i;
}

TEST(rewrite_weights, a_weight_that_becomes_zero_names_no_joint) {
  TinyGltf gltf;
  gltf.add_skinned_triangle({0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 0, 0}, {.999f, .001f, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0});
  const GlbParts parts = recoded(gltf, how(true, false)).parts;
  const std::vector<std::byte> joints = bytes_of(parts, "JOINTS_0");
  const int expected[] = {0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 0, 0};  // the file's own zero weights keep what they name
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(static_cast<int>(joints.at(i)), expected[i]) << i;
}

/// A triangle between two joints that are `apart` from each other in a clip, so that weights matter.
TinyGltf stretched_triangle(float apart) {
  TinyGltf gltf;
  gltf.add_skinned_triangle({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {.301f, .699f, 0, 0, .5f, .5f, 0, 0, .4f, .6f, 0, 0});
  const std::size_t joint = gltf.root["skins"][0]["joints"][1];
  gltf.animate("translation", gltf.times({0, 1}), gltf.vec3({0, 0, 0, apart, 0, 0}));
  gltf.root["animations"][0]["channels"][0]["target"]["node"] = joint;
  return gltf;
}

TEST(rewrite_weights, weights_get_16_bits_where_8_would_move_a_vertex_by_a_thousandth_of_the_model) {
  for (const float apart : {0.01f, 10.0f}) {
    const Json json = recoded(stretched_triangle(apart), how(true, false)).parts.json;
    EXPECT_EQ(stored_as(json, json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"]),
              apart > 1.0f ? "5123 normalized" : "5121 normalized");
  }
}

}  // namespace
}  // namespace sinew::test
