// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/base/api.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/graph/raw_array.h"

namespace sinew {

/// Numbers that a step of a formula takes from the stack.
constexpr std::size_t operands_of(GraphFormulaKind kind) noexcept {
  if (kind <= GraphFormulaKind::parameter) return 0;
  if (kind <= GraphFormulaKind::is_false) return 1;
  return kind < GraphFormulaKind::choose ? 2 : 3;
}

/// The values of all parameters: those of the caller, and those that formulas compute from them. Internal to graph/.
class SINEW_API GraphValues {
 public:
  /// Keeps a reference to `given`, and to itself if the graph has formulas.
  GraphValues(const GraphTables& tables, std::span<const float> given) noexcept : all_(given) {
    if (!tables.formulas.empty()) compute(tables);
  }
  GraphValues(const GraphValues&) = delete;
  GraphValues& operator=(const GraphValues&) = delete;

  std::span<const float> all() const noexcept { return all_; }

 private:
  void compute(const GraphTables& tables) noexcept;

  std::span<const float> all_;
  RawArray<float, kMostParametersBeside> computed_;
};

}  // namespace sinew
