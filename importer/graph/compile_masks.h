// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/graph/graph_text.h"

namespace sinew {

/// Appends the masks of a document to the tables. The entries of a mask within a mask take the place of its name.
/// err  an entry that is neither a joint nor a mask, or both; a mask that is not there, or lies within itself; more than
///      65,534 entries in all, or masks that lie more than 16 deep
std::optional<GraphTextFault> compile_masks(const GraphDocument& document, GraphTables& tables);

}  // namespace sinew
