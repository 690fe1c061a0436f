// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew {

/// Where the error of a pose is measured: at the corners of a box around each joint, in the joint's space. The box of a
/// joint that moves vertices holds all of them, each also where its morph targets put it: by convexity no vertex can be
/// farther off than the worst corner. Any other joint has a cube that reaches kShell in each direction. A box sees
/// errors along all three axes, whatever the pose (C13).
struct VirtualVertices {
  static constexpr float kShell = 0.03f;  ///< in the file's units

  std::vector<Aabb> boxes;               ///< [J] never empty
  std::vector<bool> moves_vertices;      ///< [J] the box is of vertices
  std::vector<float> metres_per_weight;  ///< [W] longest displacement by each morph weight of the scene, mesh space;
                                         ///< kShell for targets that displace nothing
};

/// in   a scene that passed its checks      cost O(vertices x influences), allocates
VirtualVertices virtual_vertices(const Scene& scene);

/// The boxes alone, for a skeleton without meshes.
VirtualVertices virtual_vertices(const Skeleton& skeleton);

/// The eight corners of a box.
std::array<Vec3<double>, 8> corners_of(const Aabb& box) noexcept;

}  // namespace sinew
