// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_normals.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/near.h"

namespace sinew::test {
namespace {

const std::vector<std::uint32_t> kTriangle = {0, 1, 2};

std::vector<glm::vec3> flat(const std::vector<glm::vec3>& positions, bool turned = false) {
  const std::vector<glm::vec3> rest(positions.size(), glm::vec3(0, 1, 0));
  std::vector<glm::vec3> normals(positions.size());
  flat_normals(kTriangle, positions, rest, turned, normals);
  return normals;
}

TEST(flat_normals, G46_a_face_has_the_normal_of_its_winding) {
  for (const glm::vec3& n : flat({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}})) EXPECT_EQ(n, glm::vec3(0, 0, 1));
  for (const glm::vec3& n : flat({{0, 0, 0}, {0, 3, 0}, {2, 0, 0}})) EXPECT_EQ(n, glm::vec3(0, 0, -1));
  for (const glm::vec3& n : flat({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, true)) EXPECT_EQ(n, glm::vec3(0, 0, -1));
}

TEST(flat_normals, tiny_and_huge_faces_have_unit_normals) {
  for (const float size : {1e-30f, 1e-12f, 1.0f, 1e12f, 1e30f})
    for (const glm::vec3& n : flat({{0, 0, 0}, {size, 0, 0}, {0, size, size}}))
      EXPECT_TRUE(is_near(n, glm::vec3(0, -0.70710678f, 0.70710678f), 1e-7)) << size;
}

TEST(flat_normals, a_face_without_area_keeps_the_normals_of_rest) {
  for (const glm::vec3& n : flat({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}})) EXPECT_EQ(n, glm::vec3(0, 1, 0));
}

TEST(flat_normals, vertices_of_no_face_keep_the_normals_of_rest) {
  EXPECT_EQ(flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}})[3], glm::vec3(0, 1, 0));
}

}  // namespace
}  // namespace sinew::test
