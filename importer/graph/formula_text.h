// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/graph/graph_nodes.h"

namespace sinew {

/// A step of a formula that reads its parameter by name.
struct NamedFormulaStep {
  GraphFormulaKind kind = GraphFormulaKind::number;
  float value = 0.0f;
  std::string parameter;
};

/// Reads a formula of parameters, such as `if(crouches, 0.5, 1) * max(speed, 0)`.
/// Operators, from loose to tight: `or`; `and`; `not`; `<` `<=` `>` `>=` `==` `!=`; `+` `-`; `*` `/`; minus sign.
/// Functions: min(a, b), max(a, b), clamp(x, low, high), abs(x), length(x, y), if(condition, a, b). Truths are 1 and 0.
/// Names that are no words stand in quotes: 'left foot'. A quote in a name is doubled.
/// err  a sentence with the place, "at character 7: ..."
tl::expected<std::vector<NamedFormulaStep>, std::string> parse_formula(std::string_view text);

/// The same formula with other names of parameters. A text that is no formula stays as it is.
/// in   names  new names by old names
std::string rename_in_formula(const std::string& text, const std::map<std::string, std::string>& names);

}  // namespace sinew
