// SPDX-License-Identifier: MIT
#include "runtime/deform/vertex_checks.h"

#include <algorithm>

namespace sinew {

AttributesPresent present(const VertexInput& in, const VertexOutput& out) noexcept {
  return {.normals = !in.normals.empty() && !out.normals.empty(),
          .tangents = !in.tangents.empty() && !out.tangents.empty()};
}

ErrorCode check_streams(const VertexInput& in, const VertexOutput& out) noexcept {
  const std::size_t count = in.positions.size();
  const auto fits = [count](std::size_t input, std::size_t output, bool optional) {
    if (optional && (input == 0 || output == 0)) return true;
    return input == count && output >= count;
  };
  if (!have_memory(in.positions, in.normals, in.tangents, out.positions, out.normals, out.tangents))
    return ErrorCode::size_mismatch;
  const bool ok = fits(in.positions.size(), out.positions.size(), false) &&
                  fits(in.normals.size(), out.normals.size(), true) &&
                  fits(in.tangents.size(), out.tangents.size(), true);
  return ok ? ErrorCode::ok : ErrorCode::size_mismatch;
}

ErrorCode check_influences(const InfluenceStreams& influences, std::size_t vertex_count,
                           std::size_t joint_count) noexcept {
  if (influences.joint_count() != influences.weight_count() || !influences.have_memory())
    return ErrorCode::size_mismatch;
  std::size_t next_vertex = 0;
  for (const auto& group : influences.groups) {
    const std::size_t end = group.first_influence + std::size_t{group.vertex_count} * group.influence_count;
    if (group.first_vertex != next_vertex || group.influence_count == 0 || end > influences.joint_count())
      return ErrorCode::size_mismatch;
    if (!influences.is_wide() && group.influence_count > InfluenceStreams::kMostWidened) return ErrorCode::unsupported;
    next_vertex += group.vertex_count;
  }
  if (next_vertex != vertex_count) return ErrorCode::size_mismatch;
  const auto all_below_count = [&](auto joints) {
    return std::all_of(joints.begin(), joints.end(), [&](auto joint) { return joint < joint_count; });
  };
  return std::visit(all_below_count, influences.joints) ? ErrorCode::ok : ErrorCode::index_out_of_range;
}

ErrorCode check_skinning(const InfluenceStreams& influences, const VertexInput& in, const VertexOutput& out,
                         std::size_t joint_count) noexcept {
  if (const ErrorCode error = check_streams(in, out); error != ErrorCode::ok) return error;
  return check_influences(influences, in.positions.size(), joint_count);
}

}  // namespace sinew
