// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// The attributes that the input has and the output has room for.
struct AttributesPresent {
  bool normals = false, tangents = false;
};

AttributesPresent present(const VertexInput& in, const VertexOutput& out) noexcept;

/// Checks that every attribute of the input has as many vertices as the positions, and that its output has room for
/// them.
/// err  size_mismatch
ErrorCode check_streams(const VertexInput& in, const VertexOutput& out) noexcept;

/// Checks that groups cover [0, vertex_count) in order, that their joints and weights exist, and that every joint is
/// below `joint_count`.
/// err  size_mismatch, index_out_of_range, unsupported (more than kMaxConverted influences that must be converted)
/// cost O(influences)
ErrorCode check_influences(const InfluenceStreams& influences, std::size_t vertex_count,
                           std::size_t joint_count) noexcept;

/// check_streams, then check_influences.
ErrorCode check_skinning(const InfluenceStreams& influences, const VertexInput& in, const VertexOutput& out,
                         std::size_t joint_count) noexcept;

/// True if all indices of the pairs are below `count`.
inline bool are_in_range(std::span<const JointPair> pairs, std::size_t count) noexcept {
  return std::all_of(pairs.begin(), pairs.end(),
                     [count](const JointPair& pair) { return pair.first < count && pair.second < count; });
}

}  // namespace sinew
