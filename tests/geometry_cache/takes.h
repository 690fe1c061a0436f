// SPDX-License-Identifier: MIT
// Small takes (recorded motions) that tests bake.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "samples/showcase/flag_cloth.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {

inline GeometryTake take_of(std::vector<std::vector<glm::vec3>> frames, std::vector<std::uint32_t> triangles,
                            double budget = 1e-4) {
  GeometryTake take;
  TakeMesh& mesh = take.meshes.emplace_back();
  mesh.name = "mesh";
  mesh.vertex_count = frames.empty() ? 0 : static_cast<std::uint32_t>(frames[0].size());
  mesh.triangles = std::move(triangles);
  mesh.streams.push_back({GeometryKind::positions, std::move(frames), budget});
  return take;
}

/// A small flag in the wind: 33 x 25 vertices.
inline GeometryTake flag_take(std::uint32_t frames = 40, double budget = 1e-4) {
  showcase::ClothFrames cloth = showcase::fly_flag({.columns = 9, .rows = 7, .spacing_m = 0.1, .frame_count = frames});
  return take_of(std::move(cloth.frames), std::move(cloth.triangles), budget);
}

/// Points without a surface that jump randomly, so that no prediction fits.
inline GeometryTake noise_take(std::uint32_t points, std::uint32_t frames, double budget = 1e-4) {
  FixedRandom random(5);
  std::vector<std::vector<glm::vec3>> all(frames);
  for (auto& frame : all)
    for (std::uint32_t p = 0; p < points; ++p) frame.push_back(random.vec3(-3.0, 3.0));
  return take_of(std::move(all), {}, budget);
}

}  // namespace sinew::test
