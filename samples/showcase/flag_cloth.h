// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace sinew::showcase {

/// A rectangular cloth as a triangle mesh, with the positions of all vertices in each frame.
struct ClothFrames {
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint32_t> triangles;
  std::vector<std::vector<glm::vec3>> frames;  ///< [frames][columns * rows] metres
};

/// The wind at a place and a time, in metres a second; angles in radians, x in metres from the pole.
/// eq   x  speed + sin(gust t)
///      y  0.5 sin(lift t)
///      z  sin(swing t) + sin(4 x - wave t)
struct FlagWind {
  double speed = 4.0;
  double gust = 1.7, lift = 0.9, swing = 2.3, wave = 5.0;  ///< radians a second
};

struct FlagOptions {
  std::uint32_t columns = 51, rows = 38;  ///< size of the simulated grid
  double spacing_m = 0.04;
  std::uint32_t pieces = 4;  ///< mesh cells per grid cell, along each side: 201 x 149 vertices
  std::uint32_t frame_count = 90;
  double fps = 30.0;
  std::uint32_t substeps = 12;
  FlagWind wind;
};

/// A flag that hangs from its first column and flies in a gusty wind: no skeleton can move such a mesh.
/// Unit masses on a grid with springs along edges and diagonals and, for bending, to the second neighbour.
/// Position-based dynamics (Mueller et al. 2007) with fixed steps in double precision: v += h a; x += h v; the springs
/// are relaxed from the pole to the far end and back; v = (x - x before) / h. The wind pushes each vertex along its
/// normal. The same bits on every machine.
/// cost  O(columns * rows * substeps * frames)
ClothFrames fly_flag(const FlagOptions& options = {});

/// The last `loop_frames` intervals of a flight as a loop: its last frame is its first one.
/// eq   the last `blend_frames` are mix(x(t), x(t - loop), smoothstep), x(t - loop) being the flight before the loop
/// in   flight  more than loop_frames + blend_frames frames;   blend_frames  1 or more
ClothFrames loop_of(ClothFrames flight, std::uint32_t loop_frames, std::uint32_t blend_frames);

/// The cloth of flag_in_wind(), over four seconds that repeat.
ClothFrames flag_flight();

}  // namespace sinew::showcase
