// SPDX-License-Identifier: MIT
#include "importer/topology/split_vertices.h"

#include <algorithm>
#include <vector>

#include "importer/topology/gather_vertices.h"
#include "runtime/base/contract.h"

namespace sinew {
namespace {

/// The vertices after the split, and the vertex of each corner.
struct Copies {
  std::vector<std::uint32_t> old_of_new;
  std::vector<std::uint32_t> new_of_corner;
};

/// The corners of each vertex v, in increasing order: corners[begin[v] .. begin[v + 1] - 1].
struct CornersOfVertex {
  std::vector<std::uint32_t> begin, corners;

  explicit CornersOfVertex(const Primitive& p) : begin(p.vertex_count() + 1, 0), corners(p.indices.size()) {
    for (const std::uint32_t v : p.indices) ++begin[v + 1];
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) corners[next[p.indices[c]]++] = static_cast<std::uint32_t>(c);
  }
};

Copies plan_copies(const Primitive& primitive, std::span<const std::uint32_t> group) {
  CornersOfVertex sorted(primitive);
  Copies copies;
  copies.new_of_corner.resize(group.size());
  for (std::size_t v = 0; v < primitive.vertex_count(); ++v) {
    const std::span corners = std::span(sorted.corners).subspan(sorted.begin[v], sorted.begin[v + 1] - sorted.begin[v]);
    std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) { return group[a] < group[b]; });
    copies.old_of_new.push_back(static_cast<std::uint32_t>(v));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool another = i > 0 && group[corners[i]] != group[corners[i - 1]] && group[corners[i]] != kNone;
      if (another) copies.old_of_new.push_back(static_cast<std::uint32_t>(v));
      copies.new_of_corner[corners[i]] = static_cast<std::uint32_t>(copies.old_of_new.size() - 1);
    }
  }
  return copies;
}

}  // namespace

void split_vertices(Primitive& primitive, std::span<const std::uint32_t> group) {
  CONTRACT(group.size() == primitive.indices.size());
  const Copies copies = plan_copies(primitive, group);
  if (copies.old_of_new.size() == primitive.vertex_count()) return;

  primitive.indices = copies.new_of_corner;
  gather_vertices(primitive, copies.old_of_new);
}

}  // namespace sinew
