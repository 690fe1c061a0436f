// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The points at which pose errors are measured: the corners of a box around each joint, in the joint's space. The box
/// of a joint that moves vertices contains all of them, in all places to which morph targets move them. By convexity no
/// vertex can have a larger error than the worst corner. All other joints get a cube of half-width kShell. Unlike one
/// or two points, a box shows errors along all three axes.
struct VirtualVertices {
  static constexpr float kShell = 0.03f;  ///< half-width of the cube of a joint without vertices, in the file's units

  std::vector<Aabb> boxes;           ///< [J] box of each joint, never empty
  std::vector<bool> moves_vertices;  ///< [J] the box contains vertices of a mesh
  /// [W] longest displacement by each morph weight, in mesh space; kShell for empty targets
  std::vector<float> metres_per_weight;
};

/// Computes the boxes of all joints of a scene.
/// in   scene  must have passed its checks      cost O(vertices x influences), allocates
SINEW_API VirtualVertices virtual_vertices(const Scene& scene);

/// Same, for a skeleton without meshes.
SINEW_API VirtualVertices virtual_vertices(const Skeleton& skeleton);

/// The eight corners of a box.
SINEW_API std::array<Vec3<double>, 8> corners_of(const Aabb& box) noexcept;

}  // namespace sinew
