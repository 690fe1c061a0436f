// SPDX-License-Identifier: MIT
#include "runtime/graph/check_formulas.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "runtime/graph/graph_values.h"

namespace sinew {
namespace {

/// A rule that an entry breaks, or null.
struct Broken {
  ErrorCode code = ErrorCode::ok;
  const char* rule = nullptr;
};

template <class Table>
bool has_entries(const Table& table, std::size_t first, std::size_t count) {
  return first <= table.size() && count <= table.size() - first;
}

/// in   computed_by  [parameters] index of its formula, or the number of formulas
Broken broken_by_step(const GraphTables& t, const GraphFormulaStep& step, const std::vector<std::size_t>& computed_by,
                      std::size_t formula) {
  if (step.kind > GraphFormulaKind::choose) return {ErrorCode::unsupported, "a step of it is of an unknown kind"};
  if (!std::isfinite(step.value)) return {ErrorCode::not_finite, "a number of it is not finite"};
  if (step.kind != GraphFormulaKind::parameter) return {};
  if (step.parameter >= t.parameters.size())
    return {ErrorCode::index_out_of_range, "it reads a parameter that does not exist"};
  if (t.parameters[step.parameter].kind == GraphParameterKind::trigger)
    return {ErrorCode::unsupported, "it reads a trigger, which has no value"};
  const std::size_t other = computed_by[step.parameter];
  if (other != t.formulas.size() && other >= formula)
    return {ErrorCode::unsupported, "it reads a parameter that is not computed before it"};
  return {};
}

Broken broken_by_formula(const GraphTables& t, std::size_t index, const std::vector<std::size_t>& computed_by) {
  const GraphFormula& formula = t.formulas[index];
  if (computed_by[formula.parameter] != index)
    return {ErrorCode::unsupported, "its parameter has another formula, too"};
  if (t.parameters[formula.parameter].kind == GraphParameterKind::trigger)
    return {ErrorCode::unsupported, "its parameter is a trigger, which has no value"};
  if (!has_entries(t.formula_steps, formula.first_step, formula.step_count))
    return {ErrorCode::index_out_of_range, "its steps do not exist"};
  std::size_t depth = 0;
  for (std::size_t i = 0; i < formula.step_count; ++i) {
    const GraphFormulaStep& step = t.formula_steps[formula.first_step + i];
    if (const Broken broken = broken_by_step(t, step, computed_by, index); broken.rule != nullptr) return broken;
    const std::size_t operands = operands_of(step.kind);
    if (depth < operands) return {ErrorCode::size_mismatch, "a step of it lacks operands"};
    depth += 1 - operands;
    if (depth > kMostFormulaNumbers) return {ErrorCode::too_large, "it needs more than 16 numbers at once"};
  }
  if (depth != 1) return {ErrorCode::size_mismatch, "its steps do not end with one number"};
  return {};
}

/// True if a cubic between two keys stays within the range of their shares.
bool stays_between(const GraphFadeKey& a, const GraphFadeKey& b) {
  const double secant = (static_cast<double>(b.share) - static_cast<double>(a.share)) /
                        (static_cast<double>(b.at) - static_cast<double>(a.at));
  const auto fits = [&](float slope) {
    const double s = static_cast<double>(slope), most = 3.0 * secant * (1.0 + 1e-6);  // slopes are rounded to float
    return secant < 0.0 ? s <= 0.0 && s >= most : s >= 0.0 && s <= most;
  };
  return fits(a.slope) && fits(b.slope);
}

Broken broken_by_curve(const GraphTables& t, const GraphFadeCurve& curve) {
  if (curve.key_count < 2 || !has_entries(t.curve_keys, curve.first_key, curve.key_count))
    return {ErrorCode::index_out_of_range, "it has less than two keys, or they do not exist"};
  const GraphFadeKey* const keys = t.curve_keys.data() + curve.first_key;
  const std::size_t last = curve.key_count - 1u;
  if (keys[0].at != 0.0f || keys[0].share != 0.0f || keys[last].at != 1.0f || keys[last].share != 1.0f)
    return {ErrorCode::not_a_fraction, "it does not lead from (0, 0) to (1, 1)"};
  for (std::size_t i = 1; i <= last; ++i) {
    if (!(keys[i - 1].at < keys[i].at)) return {ErrorCode::times_not_increasing, "its keys do not rise in time"};
    if (!(keys[i].share >= 0.0f && keys[i].share <= 1.0f))
      return {ErrorCode::not_a_fraction, "a share of it is not between 0 and 1"};
  }
  for (std::size_t i = 1; i <= last; ++i)
    if (!stays_between(keys[i - 1], keys[i]))
      return {ErrorCode::not_a_fraction,
              "a slope of it is not between 0 and three times the way to the next key, so it would overshoot"};
  return {};
}

GraphFault fault_of(GraphTable table, std::size_t index, const Broken& broken) {
  return {broken.code, table, static_cast<std::uint32_t>(index), kNoGraphIndex, broken.rule};
}

}  // namespace

GraphFault find_formula_fault(const GraphTables& t) {
  if (t.formulas.empty()) return {};
  if (t.parameters.size() > kMostParametersBeside)
    return fault_of(GraphTable::formula, 0,
                    {ErrorCode::too_large, "a graph with formulas has more than 256 parameters"});
  std::vector<std::size_t> computed_by(t.parameters.size(), t.formulas.size());
  for (std::size_t i = 0; i < t.formulas.size(); ++i) {
    if (t.formulas[i].parameter >= t.parameters.size())
      return fault_of(GraphTable::formula, i, {ErrorCode::index_out_of_range, "its parameter does not exist"});
    if (std::size_t& by = computed_by[t.formulas[i].parameter]; by == t.formulas.size()) by = i;
  }
  for (std::size_t i = 0; i < t.formulas.size(); ++i)
    if (const Broken broken = broken_by_formula(t, i, computed_by); broken.rule != nullptr)
      return fault_of(GraphTable::formula, i, broken);
  return {};
}

GraphFault find_curve_fault(const GraphTables& t) {
  for (std::size_t i = 0; i < t.curves.size(); ++i)
    if (const Broken broken = broken_by_curve(t, t.curves[i]); broken.rule != nullptr)
      return fault_of(GraphTable::curve, i, broken);
  return {};
}

}  // namespace sinew
