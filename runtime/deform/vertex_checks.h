// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/run_job.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"

namespace sinew {

/// Attributes that the input has and the output has room for.
struct AttributesPresent {
  bool normals = false, tangents = false;
};

AttributesPresent present(const VertexInput& in, const VertexOutput& out) noexcept;

/// Every attribute of the input has the vertex count of the positions, and its output, where wanted, has room for it.
/// err  size_mismatch
ErrorCode check_streams(const VertexInput& in, const VertexOutput& out) noexcept;

/// Groups cover [0, vertex_count) in order, their joints and weights exist, and every joint is below `joint_count`.
/// err  size_mismatch, index_out_of_range, unsupported (more than kMostWidened influences that have to be converted)
/// cost O(influences)
ErrorCode check_influences(const InfluenceStreams& influences, std::size_t vertex_count,
                           std::size_t joint_count) noexcept;

/// check_streams, then check_influences.
ErrorCode check_skinning(const InfluenceStreams& influences, const VertexInput& in, const VertexOutput& out,
                         std::size_t joint_count) noexcept;

}  // namespace sinew
