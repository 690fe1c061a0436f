// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "runtime/assets/skin.h"

namespace sinew {

/// The influences of one vertex. `kCount` > 0 fixes their number at compile time, 0 leaves it to run time.
template <int kCount>
struct VertexJoints {
  const std::uint16_t* joints;
  const float* weights;
  std::size_t runtime_count;

  constexpr std::size_t count() const noexcept {
    if constexpr (kCount > 0) return static_cast<std::size_t>(kCount);
    else return runtime_count;
  }
};

/// Calls `body(vertex, VertexJoints<kCount>)` for every vertex, group by group: the number of influences is chosen once per
/// group, so that the body has neither a branch nor a loop of unknown length for the usual counts (P11).
template <class Body>
void for_each_vertex(const VertexInfluences& influences, const Body& body) noexcept {
  const auto run_group = [&]<int kCount>(const InfluenceGroup& group, std::integral_constant<int, kCount>) {
    std::size_t at = group.first_influence;
    const std::size_t end = std::size_t{group.first_vertex} + group.vertex_count;
    for (std::size_t v = group.first_vertex; v < end; ++v, at += group.influence_count)
      body(v, VertexJoints<kCount>{&influences.joints[at], &influences.weights[at], group.influence_count});
  };
  for (const auto& group : influences.groups) {
    switch (group.influence_count) {
      case 1: run_group(group, std::integral_constant<int, 1>{}); break;
      case 2: run_group(group, std::integral_constant<int, 2>{}); break;
      case 3: run_group(group, std::integral_constant<int, 3>{}); break;
      case 4: run_group(group, std::integral_constant<int, 4>{}); break;
      default: run_group(group, std::integral_constant<int, 0>{}); break;
    }
  }
}

/// Calls `body(normals, tangents)` with std::true_type or std::false_type for each, so that an attribute that is not wanted
/// costs nothing per vertex (P13).
template <class Body>
void with_attributes(bool normals, bool tangents, const Body& body) noexcept {
  if (normals && tangents) body(std::true_type{}, std::true_type{});
  else if (normals) body(std::true_type{}, std::false_type{});
  else if (tangents) body(std::false_type{}, std::true_type{});
  else body(std::false_type{}, std::false_type{});
}

}  // namespace sinew
