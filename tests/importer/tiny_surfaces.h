// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew::test {

/// Triangles over these positions, without other attributes.
inline Primitive triangles(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices) {
  Primitive p;
  p.positions = std::move(positions);
  p.indices = std::move(indices);
  for (const glm::vec3& x : p.positions) p.bounds.add(x);
  return p;
}

/// The unit square in the plane z = 0, facing +Z. The texture is upright: u to the right, v down.
inline Primitive upright_square() {
  Primitive p = triangles({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3});
  p.normals.assign(4, {0, 0, 1});
  p.texcoords = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  return p;
}

/// The cube from -1 to 1 with eight shared vertices and faces outwards.
inline Primitive cube() {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  return triangles(corners, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                             2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
}

}  // namespace sinew::test
