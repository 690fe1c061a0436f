// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/result.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"

namespace sinew {

/// Attributes that are both there to read and wanted.
struct AttributesPresent {
  bool normals = false, tangents = false;
};

AttributesPresent present(const VertexInput& in, const VertexOutput& out) noexcept;

/// Every attribute present in the input has the input's vertex count, and its output, when wanted, room for it.
/// err  size_mismatch
ErrorCode check_streams(const VertexInput& in, const VertexOutput& out) noexcept;

/// Groups cover [0, vertex_count) in order, their joints and weights exist, and every joint is below `joint_count`.
/// err  size_mismatch, index_out_of_range, unsupported (more than kMostWidened that have to be widened)     cost
/// O(influences)
ErrorCode check_influences(const InfluenceStreams& influences, std::size_t vertex_count,
                           std::size_t joint_count) noexcept;

/// Both of them.
ErrorCode check_skinning(const InfluenceStreams& influences, const VertexInput& in, const VertexOutput& out,
                         std::size_t joint_count) noexcept;

}  // namespace sinew
