// SPDX-License-Identifier: MIT
#include "importer/write/file_vertices.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace sinew::write {
namespace {

FileVertices scene_order(std::size_t count) {
  FileVertices out;
  out.scene_vertex.resize(count);
  std::iota(out.scene_vertex.begin(), out.scene_vertex.end(), 0u);
  out.file_vertex = out.scene_vertex;
  return out;
}

std::optional<FileVertices> source_order(const Primitive& primitive) {
  const auto& source = primitive.source_vertex;
  const bool copies_are_equal = primitive.flat_normals && primitive.tangents.empty();
  FileVertices out;
  out.file_vertex = source;
  for (std::uint32_t v = 0; v < source.size(); ++v) {
    if (source[v] >= source.size()) return std::nullopt;
    if (source[v] >= out.scene_vertex.size()) out.scene_vertex.resize(source[v] + 1, kNone);
    std::uint32_t& first = out.scene_vertex[source[v]];
    if (first == kNone)
      first = v;
    else if (!copies_are_equal)
      return std::nullopt;
  }
  const bool gaps = std::find(out.scene_vertex.begin(), out.scene_vertex.end(), kNone) != out.scene_vertex.end();
  return gaps ? std::nullopt : std::optional(std::move(out));
}

}  // namespace

FileVertices file_vertices(const Primitive& primitive) {
  if (primitive.source_vertex.size() == primitive.vertex_count())
    if (auto order = source_order(primitive)) return *std::move(order);
  return scene_order(primitive.vertex_count());
}

}  // namespace sinew::write
