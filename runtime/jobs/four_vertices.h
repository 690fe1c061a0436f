// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>

#include "runtime/assets/skin.h"
#include "runtime/jobs/influence_dispatch.h"
#include "runtime/jobs/vertex_streams.h"

namespace sinew {

/// The streams from vertex `v` on.
template <class Streams>
Streams streams_from(const Streams& streams, std::size_t v) noexcept {
  const auto rest = [v](auto span) { return span.empty() ? span : span.subspan(v); };
  return {rest(streams.positions), rest(streams.normals), rest(streams.tangents)};
}

/// Runs `four(in, out)` on up to four last vertices through copies, so that nothing is read or written beyond the arrays.
/// The copies are readable one float beyond the fourth vertex.
template <bool kNormals, bool kTangents, class Four>
void run_on_copies(const Four& four, const VertexInput& in, const VertexOutput& out, std::size_t count) noexcept {
  glm::vec3 positions[5] = {}, normals[5] = {}, out_positions[4], out_normals[4];
  glm::vec4 tangents[4] = {}, out_tangents[4];
  std::copy_n(in.positions.begin(), count, positions);
  if constexpr (kNormals) std::copy_n(in.normals.begin(), count, normals);
  if constexpr (kTangents) std::copy_n(in.tangents.begin(), count, tangents);
  four({positions, normals, tangents}, {out_positions, out_normals, out_tangents});
  std::copy_n(out_positions, count, out.positions.begin());
  if constexpr (kNormals) std::copy_n(out_normals, count, out.normals.begin());
  if constexpr (kTangents) std::copy_n(out_tangents, count, out.tangents.begin());
}

/// Cuts a group into fours and calls `four(VertexJoints (&)[4], in, out)` for each; the last four go through copies, in which
/// the last vertex fills up.
template <int kCount, bool kNormals, bool kTangents, class Four>
void for_each_four(const VertexInfluences& influences, const InfluenceGroup& group, const VertexInput& in, const VertexOutput& out,
                   const Four& four) noexcept {
  const std::size_t count = group.vertex_count;
  for (std::size_t v = 0; v < count; v += 4) {
    const auto at = [&](std::size_t k) { return joints_of<kCount>(influences, group, std::min(v + k, count - 1)); };
    const VertexJoints<kCount> joints[4] = {at(0), at(1), at(2), at(3)};
    const VertexInput from = streams_from(in, group.first_vertex + v);
    const VertexOutput to = streams_from(out, group.first_vertex + v);
    if (v + 4 < count)
      four(joints, from, to);
    else
      run_on_copies<kNormals, kTangents>([&](const VertexInput& i, const VertexOutput& o) { four(joints, i, o); }, from, to, count - v);
  }
}

}  // namespace sinew
