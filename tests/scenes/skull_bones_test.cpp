// SPDX-License-Identifier: MIT
// Tests of the showcase's skull: its bones and its teeth.
#include "samples/showcase/skull_bones.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/glm.hpp>

#include "samples/showcase/polygonise.h"
#include "samples/showcase/showcase.h"
#include "samples/showcase/skull_teeth.h"
#include "tests/scenes/closed_surface.h"

namespace sinew::test {
namespace {

using namespace showcase;

/// z at which a ray parallel to -Z at (x, y) meets the front of the cranium.
float front_at(float x, float y) {
  float z = 12.0f;
  while (z > -12.0f && cranium({x, y, z}) > 0.0f) z -= 0.02f;
  return z;
}

TEST(skull_bones, are_closed_and_lie_in_their_bounds) {
  for (const auto& [bone, bounds] : {std::pair(&cranium, kCranium), std::pair(&mandible, kMandible)}) {
    const Primitive surface = polygonise(bone, bounds, 0.34f);
    EXPECT_EQ(open_edges(surface), 0u);
    for (const glm::vec3& p : surface.positions) ASSERT_LT(std::abs(bone(p)), 0.15f);
  }
}

TEST(skull_bones, have_hollow_eyes_and_a_hollow_nose_under_a_brow) {
  for (const float side : {-1.0f, 1.0f}) {
    const float brow = front_at(side * 2.5f, 3.6f), cheek = front_at(side * 4.3f, -1.5f);
    EXPECT_LT(front_at(side * 2.6f, 1.5f), brow - 3.0f) << "eye socket";
    EXPECT_LT(front_at(side * 2.6f, 1.5f), cheek - 2.0f) << "eye socket";
    EXPECT_LT(front_at(side * 0.5f, -1.6f), brow - 2.0f) << "nose";
    EXPECT_GT(front_at(side * 0.2f, 0.9f), brow) << "nasal bone";
    EXPECT_LT(front_at(side * 2.5f, 8.0f), brow) << "forehead";
  }
}

TEST(skull_bones, have_a_jaw_that_hangs_free) {
  for (const glm::vec3& p : polygonise(mandible, kMandible, 0.34f).positions) ASSERT_GT(cranium(p), 0.0f);
}

TEST(skull_bones, hold_28_teeth_by_the_root) {
  const Primitive teeth = skull_teeth();
  constexpr std::size_t kTeeth = 28;
  ASSERT_EQ(teeth.positions.size() % kTeeth, 0u);
  const std::size_t each = teeth.positions.size() / kTeeth;
  for (std::size_t tooth = 0; tooth < kTeeth; ++tooth) {
    float least = 1.0f, most = -1.0f;
    for (std::size_t v = tooth * each; v < (tooth + 1) * each; ++v) {
      const float outside = std::min(cranium(teeth.positions[v]), mandible(teeth.positions[v]));
      least = std::min(least, outside);
      most = std::max(most, outside);
    }
    EXPECT_LT(least, 0.0f) << "root of tooth " << tooth;
    EXPECT_GT(most, 0.2f) << "edge of tooth " << tooth;
  }
}

TEST(skull_bones, are_a_small_mesh_of_valid_colours_in_the_showcase) {
  const auto shown = skull_flight();
  const auto skull = std::find_if(shown.scene.meshes.begin(), shown.scene.meshes.end(),
                                  [](const Mesh& mesh) { return mesh.name == "skull"; });
  ASSERT_NE(skull, shown.scene.meshes.end());
  std::size_t vertices = 0;
  for (const Primitive& primitive : skull->primitives) {
    vertices += primitive.positions.size();
    for (const glm::vec4& c : primitive.colors)
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(c, glm::vec4(0.0f))) &&
                  glm::all(glm::lessThanEqual(c, glm::vec4(1.0f))));
  }
  EXPECT_LT(vertices, 20000u);
}

}  // namespace
}  // namespace sinew::test
