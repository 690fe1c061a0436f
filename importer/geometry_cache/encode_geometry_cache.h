// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/import_error.h"

namespace sinew {

struct EncodeGeometryOptions {
  std::uint32_t segment_frames = 32;  ///< frames from one key frame to the next: most that a seek decodes
  bool keep_triangles = true;         ///< so that the file can be shown alone
};

/// A geometry cache (.sgeo) within a budget. Values are whole numbers of a step, points are ordered in blocks of
/// neighbours that move alike, each block follows from the frames before by the motion that leaves the fewest bits.
/// Decodes all frames again and stores what was measured; the asked budget holds for every vertex of every frame.
/// err  cache-frames  frames that differ in their number of vertices, or no frames
///      cache-values  a value that is not finite
///      cache-triangles  a triangle that is cut off, or names a vertex that is not there
///      cache-budget  a budget that float positions of this size cannot hold
/// cost O(values), some microseconds per point; allocates some copies of one stream
ImportResult<std::vector<std::byte>> encode_geometry_cache(const GeometryTake& take,
                                                           const EncodeGeometryOptions& options = {});

}  // namespace sinew
