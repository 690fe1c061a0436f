// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace sinew::test {

/// A rectangular cloth as a triangle mesh, with the positions of all vertices in each frame.
struct ClothFrames {
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint32_t> triangles;
  std::vector<std::vector<glm::vec3>> frames;  ///< [frames][columns * rows] metres
};

struct FlagOptions {
  std::uint32_t columns = 51, rows = 38;  ///< of the grid that is simulated
  double spacing_m = 0.04;
  std::uint32_t pieces = 4;  ///< the mesh has each interval of the grid cut into so many: 201 x 149 vertices
  std::uint32_t frame_count = 90;
  double fps = 30.0;
  std::uint32_t substeps = 12;
};

/// A flag that hangs from its first column and flies in a gusty wind: no skeleton can move such a mesh.
/// Unit masses on a grid with springs along edges and diagonals and, for bending, to the second neighbour.
/// Position-based dynamics (Mueller et al. 2007) with fixed steps in double precision: v += h a; x += h v; the springs
/// are relaxed from the pole to the far end and back; v = (x - x before) / h. The wind pushes each vertex along its
/// normal. cost  O(columns * rows * substeps * frames)
ClothFrames fly_flag(const FlagOptions& options = {});

}  // namespace sinew::test
