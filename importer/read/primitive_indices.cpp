// SPDX-License-Identifier: MIT
#include "importer/read/primitive_indices.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "runtime/base/all_below.h"
#include "runtime/base/index.h"

namespace sinew {
namespace {

using gltf::PrimitiveMode;
using Indices = std::vector<std::uint32_t>;

bool count_fits(PrimitiveMode mode, std::size_t count) {
  switch (mode) {
    case PrimitiveMode::points: return count > 0;
    case PrimitiveMode::lines: return count > 0 && count % 2 == 0;
    case PrimitiveMode::line_loop:
    case PrimitiveMode::line_strip: return count >= 2;
    case PrimitiveMode::triangles: return count > 0 && count % 3 == 0;
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::triangle_fan: break;
  }
  return count >= 3;
}

void cut_to_multiple(Indices& list, std::size_t of) { list.resize(list.size() / of * of); }

Indices unroll_lines(const Indices& in, bool closed) {
  Indices out;
  if (in.size() < 2) return out;
  out.reserve(2 * in.size());
  for (std::size_t i = 0; i + 1 < in.size(); ++i) out.insert(out.end(), {in[i], in[i + 1]});
  if (closed) out.insert(out.end(), {in.back(), in.front()});
  return out;
}

Indices unroll_strip(const Indices& in) {
  Indices out;
  out.reserve(3 * in.size());
  for (std::size_t i = 0; i + 2 < in.size(); ++i) out.insert(out.end(), {in[i], in[i + 1 + i % 2], in[i + 2 - i % 2]});
  return out;
}

Indices unroll_fan(const Indices& in) {
  Indices out;
  out.reserve(3 * in.size());
  for (std::size_t i = 0; i + 2 < in.size(); ++i) out.insert(out.end(), {in[i + 1], in[i + 2], in[0]});
  return out;
}

bool check_format(const gltf::Document& document, std::uint32_t accessor_index, const std::string& place,
                  IssueLog& log) {
  const auto& accessor = document.accessors[accessor_index];
  if (accessor.type != gltf::ElementType::scalar || !is_unsigned(accessor.component_type) || accessor.normalized) {
    log.report(Rule::mesh_indices, place, "indices are not unsigned integers");
    return false;
  }
  if (accessor.buffer_view != kNone && document.buffer_views[accessor.buffer_view].byte_stride != 0)
    log.report(Rule::mesh_indices_stride, place, "the buffer view of indices has a byteStride, which is used");
  return true;
}

}  // namespace

Topology topology_of(PrimitiveMode mode) noexcept {
  switch (mode) {
    case PrimitiveMode::points: return Topology::points;
    case PrimitiveMode::lines:
    case PrimitiveMode::line_loop:
    case PrimitiveMode::line_strip: return Topology::lines;
    case PrimitiveMode::triangles:
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::triangle_fan: break;
  }
  return Topology::triangles;
}

Indices unroll(PrimitiveMode mode, Indices indices) {
  switch (mode) {
    case PrimitiveMode::points: break;
    case PrimitiveMode::lines: cut_to_multiple(indices, 2); break;
    case PrimitiveMode::triangles: cut_to_multiple(indices, 3); break;
    case PrimitiveMode::line_loop: return unroll_lines(indices, true);
    case PrimitiveMode::line_strip: return unroll_lines(indices, false);
    case PrimitiveMode::triangle_strip: return unroll_strip(indices);
    case PrimitiveMode::triangle_fan: return unroll_fan(indices);
  }
  return indices;
}

Indices read_indices(const gltf::Document& document, const gltf::Primitive& primitive, std::uint32_t vertex_count,
                     const std::string& place, IssueLog& log) {
  Indices indices;
  const std::string where = pointer(place, "indices");
  if (primitive.indices == gltf::kAbsent) {
    indices.resize(vertex_count);
    std::iota(indices.begin(), indices.end(), 0u);
  } else {
    if (!check_format(document, primitive.indices, where, log)) return {};
    indices = read_unsigned(document, primitive.indices);
  }
  if (!all_below(indices, vertex_count)) {
    const auto bad =
        std::find_if(indices.begin(), indices.end(), [&](std::uint32_t index) { return index >= vertex_count; });
    log.report(Rule::mesh_index, where,
               "entry " + std::to_string(bad - indices.begin()) + " is " + std::to_string(*bad) + ", there are " +
                   std::to_string(vertex_count) + " vertices");
    return {};
  }
  if (!count_fits(mode_of(primitive), indices.size()))
    log.report(
        Rule::mesh_mode, pointer(place, "mode"),
        std::to_string(indices.size()) + " vertices do not make whole elements of this mode; the rest is dropped");
  return unroll(mode_of(primitive), std::move(indices));
}

}  // namespace sinew
