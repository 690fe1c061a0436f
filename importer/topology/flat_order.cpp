// SPDX-License-Identifier: MIT
#include "importer/topology/flat_order.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "importer/topology/gather_vertices.h"

namespace sinew {
namespace {

/// Sort key of a vertex.
struct CornerPlace {
  std::uint32_t group = 0;
  std::array<std::uint32_t, 3> groups_of_triangle{kNone, kNone, kNone};
  std::uint32_t corner = 0;
  std::uint32_t first_vertex = 0;  ///< first vertex of the triangle

  friend auto operator<=>(const CornerPlace&, const CornerPlace&) = default;
};

/// The influence group of each vertex; 0 for all if there are no groups.
std::vector<std::uint32_t> group_of_vertex(const Primitive& primitive) {
  std::vector<std::uint32_t> groups(primitive.vertex_count(), 0);
  for (std::uint32_t g = 0; g < primitive.influences.groups.size(); ++g) {
    const InfluenceGroup& group = primitive.influences.groups[g];
    std::fill_n(groups.begin() + group.first_vertex, group.vertex_count, g);
  }
  return groups;
}

std::vector<CornerPlace> corner_places(const Primitive& primitive) {
  const std::vector<std::uint32_t> groups = group_of_vertex(primitive);
  std::vector<CornerPlace> places(primitive.vertex_count());
  for (std::size_t v = 0; v < places.size(); ++v) places[v].group = groups[v];
  for (std::uint32_t i = 0; i < primitive.indices.size(); ++i) {
    const std::uint32_t* const triangle = &primitive.indices[i / 3 * 3];
    places[primitive.indices[i]] = {
        .group = groups[primitive.indices[i]],
        .groups_of_triangle = {groups[triangle[0]], groups[triangle[1]], groups[triangle[2]]},
        .corner = i % 3,
        .first_vertex = triangle[0]};
  }
  return places;
}

}  // namespace

void order_flat_corners(Primitive& primitive) {
  const std::vector<CornerPlace> places = corner_places(primitive);
  std::vector<std::uint32_t> old_of_new(primitive.vertex_count());
  std::iota(old_of_new.begin(), old_of_new.end(), 0u);
  std::stable_sort(old_of_new.begin(), old_of_new.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return places[a] < places[b]; });
  if (std::is_sorted(old_of_new.begin(), old_of_new.end())) return;
  permute_vertices(primitive, old_of_new);
}

}  // namespace sinew
