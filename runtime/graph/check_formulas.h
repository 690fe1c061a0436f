// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/graph_definition.h"

namespace sinew {

/// Checks the rules of GraphFormula, for tables whose parameters are sound. Internal to graph/.
GraphFault find_formula_fault(const GraphTables& tables);

/// Checks the rules of GraphFadeCurve. Internal to graph/.
GraphFault find_curve_fault(const GraphTables& tables);

}  // namespace sinew
