// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/import_error.h"

namespace sinew {

struct EncodeGeometryOptions {
  std::uint32_t segment_frames = 32;  ///< frames between key frames: largest number that a seek decodes
  bool keep_triangles = true;         ///< store triangles, so that the file can be shown without a glTF file
};

/// Encodes a geometry cache (.sgeo) within an error budget. Values are quantized to a grid. Points are sorted into
/// blocks of neighbours with similar motion. Each block is predicted from earlier frames by the motion model that needs
/// the fewest bits. Finally decodes all frames and stores the measured errors; the budget holds for every vertex of
/// every frame.
/// err  cache-frames  frames with different vertex counts, or no frames
///      cache-values  a value that is not finite
///      cache-triangles  an incomplete triangle, or an invalid vertex index
///      cache-budget  a budget that float positions of this magnitude cannot meet
/// cost O(values), some microseconds per point; allocates several copies of one stream
ImportResult<std::vector<std::byte>> encode_geometry_cache(const GeometryTake& take,
                                                           const EncodeGeometryOptions& options = {});

}  // namespace sinew
