// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew {

/// Work done by one frame of one instance. A stage that the plan leaves out counts exactly zero.
struct WorkCounters {
  std::uint64_t tracks_sampled = 0;
  std::uint64_t properties_sampled = 0;
  std::uint64_t poses_blended = 0;
  std::uint64_t poses_added = 0;
  std::uint64_t poses_interpolated = 0;  ///< between two that are there
  std::uint64_t poses_compared = 0;      ///< with the samples of correctives
  std::uint64_t joints_composed = 0;
  std::uint64_t palette_entries = 0;
  std::uint64_t palette_entries_split = 0;
  std::uint64_t combinations_blended = 0;
  std::uint64_t morph_deltas = 0;
  std::uint64_t vertices_morphed = 0;
  std::uint64_t vertices_skinned_linear = 0;
  std::uint64_t normals_by_cofactors = 0;  ///< of the vertices that are skinned linearly
  std::uint64_t vertices_skinned_dual_quaternion = 0;
  std::uint64_t vertices_skinned_center_of_rotation = 0;
  std::uint64_t windings_tested = 0;  ///< of mesh instances, whose scale may change its sign
  std::uint64_t flat_triangles = 0;
  std::uint64_t bounds_vertices = 0;

  friend bool operator==(const WorkCounters&, const WorkCounters&) = default;
};

}  // namespace sinew
