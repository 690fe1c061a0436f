// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/strided_vertices.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/model/aabb.h"

namespace sinew {

/// Copies packed vertices, such as those of a frame, to an interleaved vertex buffer.
/// out  out  An attribute is written if the input has it and it is not empty here. Must not overlap the input.
/// err  size_mismatch (counts, memory, strides below the size of an attribute)     cost O(V), no allocation
struct WriteVerticesJob {
  VertexInput vertices;
  StridedOutput out;
};

/// Vertices of 16-bit integers, with a stride for each attribute.
struct QuantizedOutput {
  StridedSpan<std::array<std::uint16_t, 3>> positions;  ///< 0 = the lower corner of the box, 65535 = the upper corner
  StridedSpan<std::array<std::int16_t, 2>> normals;     ///< octahedral: x, y; 32767 = 1
  StridedSpan<std::array<std::int16_t, 3>> tangents;    ///< octahedral: x, y; then the handedness, 32767 or -32767
};

/// Copies packed vertices to a buffer of 16-bit integers, which is a third of the size.
/// eq   position = lower + (upper - lower) * q / 65535
///      o = q / 32767;  z = 1 - |o.x| - |o.y|;  direction = normalise(z < 0 ? ((1 - |o.yx|) * sign(o.xy), z) : (o.xy,
///      z)) (Cigolle et al. 2014, octahedral unit vectors; sign(0) = 1) A position within the box is off by at most
///      0.51 / 65535 of the side of the box on each axis, and by the rounding of float. A direction is off by at most
///      6e-5 radians.
/// in   vertices  unit directions;   box  of the vertices. Positions outside of it are moved to its sides
/// out  out  as WriteVerticesJob
/// err  as WriteVerticesJob, not_finite (box; also an empty one)     cost O(V), no allocation
struct QuantizeVerticesJob {
  VertexInput vertices;
  Aabb box;
  QuantizedOutput out;
};

SINEW_API ErrorCode check(const WriteVerticesJob& job) noexcept;
SINEW_API void run_unchecked(const WriteVerticesJob& job) noexcept;
SINEW_API ErrorCode check(const QuantizeVerticesJob& job) noexcept;
SINEW_API void run_unchecked(const QuantizeVerticesJob& job) noexcept;

}  // namespace sinew
