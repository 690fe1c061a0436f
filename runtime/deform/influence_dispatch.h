// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "runtime/deform/vertex_checks.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Influences of one vertex. `kCount` > 0 fixes their number at compile time; 0 leaves it to run time.
template <int kCount>
struct VertexJoints {
  const std::uint16_t* joints;
  const float* weights;
  std::size_t runtime_count;

  constexpr std::size_t count() const noexcept {
    if constexpr (kCount > 0)
      return static_cast<std::size_t>(kCount);
    else
      return runtime_count;
  }
};

/// Calls `body(std::integral_constant<int, n>)` with n = count for the usual counts and n = 0 for all others. The
/// constant lets the compiler unroll the loop over influences.
template <class Body>
void with_influence_count(std::uint32_t count, const Body& body) noexcept {
  switch (count) {
    case 1: body(std::integral_constant<int, 1>{}); break;
    case 2: body(std::integral_constant<int, 2>{}); break;
    case 3: body(std::integral_constant<int, 3>{}); break;
    case 4: body(std::integral_constant<int, 4>{}); break;
    case 8: body(std::integral_constant<int, 8>{}); break;
    default: body(std::integral_constant<int, 0>{}); break;
  }
}

/// Influences of the `v`-th vertex of a group.
template <int kCount>
VertexJoints<kCount> joints_of(const VertexInfluences& influences, const InfluenceGroup& group,
                               std::size_t v) noexcept {
  const std::size_t at = group.first_influence + v * group.influence_count;
  return {&influences.joints[at], &influences.weights[at], group.influence_count};
}

/// Calls `body(vertex, VertexJoints<kCount>)` for every vertex. `kCount` is chosen once per group.
template <class Body>
void for_each_vertex(const VertexInfluences& influences, const Body& body) noexcept {
  for (const auto& group : influences.groups)
    with_influence_count(group.influence_count, [&](auto count) {
      for (std::size_t v = 0; v < group.vertex_count; ++v)
        body(group.first_vertex + v, joints_of<count>(influences, group, v));
    });
}

/// Calls `body(normals, tangents)`, each a std::true_type or std::false_type. An attribute that is not wanted then
/// costs nothing per vertex.
template <class Body>
void with_attributes(AttributesPresent wanted, const Body& body) noexcept {
  if (wanted.normals && wanted.tangents)
    body(std::true_type{}, std::true_type{});
  else if (wanted.normals)
    body(std::true_type{}, std::false_type{});
  else if (wanted.tangents)
    body(std::false_type{}, std::true_type{});
  else
    body(std::false_type{}, std::false_type{});
}

/// Calls `body(group, influence count)` for each group; the count is a std::integral_constant.
template <class Body>
void for_each_group(const InfluenceStreams& influences, const Body& body) noexcept {
  for (const InfluenceGroup& group : influences.groups)
    with_influence_count(group.influence_count, [&](auto count) { body(group, count); });
}

/// Calls `body(group, influence count, stretched)`; both are std::integral_constants. Skins with rigid joints alone
/// then pay nothing for the stretch phase.
template <class Body>
void for_each_group(const InfluenceStreams& influences, bool any_stretch, const Body& body) noexcept {
  for_each_group(influences, [&](const InfluenceGroup& group, auto count) {
    if (any_stretch)
      body(group, count, std::true_type{});
    else
      body(group, count, std::false_type{});
  });
}

}  // namespace sinew
