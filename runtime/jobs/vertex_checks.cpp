// SPDX-License-Identifier: MIT
#include "runtime/jobs/vertex_checks.h"

namespace sinew {

AttributesPresent present(const VertexInput& in, const VertexOutput& out) noexcept {
  return {.normals = !in.normals.empty() && !out.normals.empty(), .tangents = !in.tangents.empty() && !out.tangents.empty()};
}

ErrorCode check_streams(const VertexInput& in, const VertexOutput& out) noexcept {
  const std::size_t count = in.positions.size();
  const auto fits = [count](std::size_t input, std::size_t output, bool optional) {
    if (optional && (input == 0 || output == 0)) return true;
    return input == count && output >= count;
  };
  const bool ok = fits(in.positions.size(), out.positions.size(), false) && fits(in.normals.size(), out.normals.size(), true) &&
                  fits(in.tangents.size(), out.tangents.size(), true);
  return ok ? ErrorCode::ok : ErrorCode::size_mismatch;
}

ErrorCode check_influences(const VertexInfluences* influences, std::size_t vertex_count, std::size_t joint_count) noexcept {
  if (!influences || influences->joints.size() != influences->weights.size()) return ErrorCode::size_mismatch;
  std::size_t next_vertex = 0;
  for (const auto& group : influences->groups) {
    const std::size_t end = group.first_influence + std::size_t{group.vertex_count} * group.influence_count;
    if (group.first_vertex != next_vertex || group.influence_count == 0 || end > influences->joints.size())
      return ErrorCode::size_mismatch;
    next_vertex += group.vertex_count;
  }
  if (next_vertex != vertex_count) return ErrorCode::size_mismatch;
  for (const std::uint16_t joint : influences->joints)
    if (joint >= joint_count) return ErrorCode::index_out_of_range;
  return ErrorCode::ok;
}

ErrorCode check_skinning(const VertexInfluences* influences, const VertexInput& in, const VertexOutput& out, std::size_t joint_count) noexcept {
  if (const ErrorCode error = check_streams(in, out); error != ErrorCode::ok) return error;
  return check_influences(influences, in.positions.size(), joint_count);
}

}  // namespace sinew
