// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/graph/graph_definition.h"

namespace sinew {

/// Writes a graph as bytes. A head of 8 bytes ("SINEWGR" and the version) comes first. Then comes each table of
/// GraphTables: its count and its entries, field by field, in little-endian order without padding. Equal tables give
/// equal bytes: version 1, or 2 if the graph has formulas or curves of its own.
SINEW_API std::vector<std::byte> write_graph_bytes(const GraphTables& tables);

/// Reads tables. Any bytes may be passed; GraphDefinition::make checks what the tables say.
/// err  unsupported (not a graph, another version, an unknown value of an enumeration), size_mismatch (the bytes end
///      too early, or go on)
/// cost O(bytes), allocates no more than a small multiple of them
SINEW_API Result<GraphTables> read_graph_bytes(std::span<const std::byte> bytes);

}  // namespace sinew
