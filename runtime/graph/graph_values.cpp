// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sinew {
namespace {

double truth(bool holds) noexcept { return holds ? 1.0 : 0.0; }

double result_of(GraphFormulaKind kind, const double* x) noexcept {
  switch (kind) {
    case GraphFormulaKind::negate: return -x[0];
    case GraphFormulaKind::absolute: return std::fabs(x[0]);
    case GraphFormulaKind::is_false: return truth(x[0] == 0.0);
    case GraphFormulaKind::add: return x[0] + x[1];
    case GraphFormulaKind::subtract: return x[0] - x[1];
    case GraphFormulaKind::multiply: return x[0] * x[1];
    case GraphFormulaKind::divide: return x[1] == 0.0 ? 0.0 : x[0] / x[1];
    case GraphFormulaKind::minimum: return std::min(x[0], x[1]);
    case GraphFormulaKind::maximum: return std::max(x[0], x[1]);
    case GraphFormulaKind::length: return std::sqrt(x[0] * x[0] + x[1] * x[1]);
    case GraphFormulaKind::below: return truth(x[0] < x[1]);
    case GraphFormulaKind::below_or_equal: return truth(x[0] <= x[1]);
    case GraphFormulaKind::equal: return truth(x[0] == x[1]);
    case GraphFormulaKind::both: return truth(x[0] != 0.0 && x[1] != 0.0);
    case GraphFormulaKind::either: return truth(x[0] != 0.0 || x[1] != 0.0);
    case GraphFormulaKind::choose: return x[0] != 0.0 ? x[1] : x[2];
    case GraphFormulaKind::number:
    case GraphFormulaKind::parameter: break;  // they have no operands
  }
  return 0.0;
}

/// Each result is limited to the range of float, so that no infinity or NaN arises.
double limited(double value) noexcept {
  constexpr double kMost = std::numeric_limits<float>::max();
  return std::clamp(value, -kMost, kMost);
}

}  // namespace

void GraphValues::compute(const GraphTables& tables) noexcept {
  const std::size_t count = tables.parameters.size();
  for (std::size_t p = 0; p < count; ++p) computed_.put(p, all_[p]);
  for (const GraphFormula& formula : tables.formulas) {
    RawArray<double, kMostFormulaNumbers> stack;
    std::size_t depth = 0;
    for (std::size_t i = 0; i < formula.step_count; ++i) {
      const GraphFormulaStep& step = tables.formula_steps[formula.first_step + i];
      if (step.kind == GraphFormulaKind::number) {
        stack.put(depth++, static_cast<double>(step.value));
      } else if (step.kind == GraphFormulaKind::parameter) {
        stack.put(depth++, static_cast<double>(computed_[step.parameter]));
      } else {
        depth -= operands_of(step.kind);
        stack[depth] = limited(result_of(step.kind, stack.data() + depth));
        ++depth;
      }
    }
    computed_[formula.parameter] = static_cast<float>(stack[0]);
  }
  all_ = {computed_.data(), count};
}

}  // namespace sinew
