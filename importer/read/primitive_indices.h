// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Strips, fans and loops are unrolled on import, so three topologies remain.
Topology topology_of(gltf::PrimitiveMode mode) noexcept;

/// Turns strips, fans and loops into plain lists. Vertices that do not complete an element are dropped.
/// eq   strip triangle i = {i, i + (1 + i % 2), i + (2 - i % 2)}, fan triangle i = {i + 1, i + 2, 0}
///      (glTF 2.0, "Meshes")
std::vector<std::uint32_t> unroll(gltf::PrimitiveMode mode, std::vector<std::uint32_t> indices);

/// Reads the index list of a primitive, unrolled. Without an accessor it is all vertices in order.
/// err      mesh-indices (format), mesh-index (past the last vertex)
/// warning  mesh-mode (the count does not fit the mode), mesh-indices-stride
std::vector<std::uint32_t> read_indices(const gltf::Document& document, const gltf::Primitive& primitive,
                                        std::uint32_t vertex_count, const std::string& place, IssueLog& log);

}  // namespace sinew
