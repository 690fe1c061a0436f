// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Topology after unrolling: strips, fans and loops become lists, so three topologies remain.
Topology topology_of(gltf::PrimitiveMode mode) noexcept;

/// Converts strips, fans and loops to lists. Drops vertices that do not complete an element.
/// eq   strip triangle i = {i, i + (1 + i % 2), i + (2 - i % 2)}, fan triangle i = {i + 1, i + 2, 0} (glTF 2.0,
///      "Meshes")
std::vector<std::uint32_t> unroll(gltf::PrimitiveMode mode, std::vector<std::uint32_t> indices);

/// Reads and unrolls the indices of a primitive. Without an accessor, uses all vertices in order.
/// err      mesh-indices (format), mesh-index (past the last vertex)
/// warning  mesh-mode (the count does not fit the mode), mesh-indices-stride
std::vector<std::uint32_t> read_indices(const gltf::Document& document, const gltf::Primitive& primitive,
                                        std::uint32_t vertex_count, const std::string& place, IssueLog& log);

}  // namespace sinew
