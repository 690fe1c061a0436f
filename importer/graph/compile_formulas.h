// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/graph/graph_text.h"

namespace sinew {

/// Adds the formulas of a document to tables whose parameters have the order of the document. A formula comes after
/// those that compute what it reads.
/// err  a text that is no formula, a parameter that does not exist, a parameter that is computed from itself
std::optional<GraphTextFault> compile_formulas(const GraphDocument& document, GraphTables& tables);

}  // namespace sinew
