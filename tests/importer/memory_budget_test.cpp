// SPDX-License-Identifier: MIT
#include "importer/read/memory_budget.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

/// A clip that animates the default weights of a mesh used by `nodes` nodes. `end` of its sampler (input or output) has
/// 16 MiB of floats and no bytes in the file.
std::string outcome_of(std::size_t nodes, const char* end) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["targets"] = Json::array({{{"POSITION", file.vec3({1, 0, 0, 0, 0, 0, 0, 0, 0})}}});
  file.root["nodes"] = Json::array();
  for (std::size_t n = 0; n < nodes; ++n) file.root["nodes"].push_back({{"mesh", 0}});
  file.animate("weights", file.times({0}), file.scalars({1}));
  Json& animation = file.root["animations"][0];
  animation["channels"][0]["target"] = {
      {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/meshes/0/weights"}}}}}};
  file.root["accessors"].push_back({{"componentType", 5126}, {"count", 1 << 22}, {"type", "SCALAR"}});
  animation["samplers"][0][end] = file.root["accessors"].size() - 1;
  const auto result = file.import();
  return result ? "ok" : result.error().issue.rule;
}

TEST(memory_budget, keys_count_once_for_each_node_that_they_move) {
  for (const char* end : {"input", "output"}) {
    EXPECT_NE(outcome_of(1, end), "memory-budget") << end;
    EXPECT_EQ(outcome_of(8, end), "memory-budget") << end;
  }
}

}  // namespace
}  // namespace sinew::test
