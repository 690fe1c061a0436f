// SPDX-License-Identifier: MIT
#include "importer/graph/compile_formulas.h"

#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "importer/graph/formula_text.h"
#include "importer/graph/json_path.h"

namespace sinew {
namespace {

class FormulaCompiler {
 public:
  FormulaCompiler(const GraphDocument& document, GraphTables& tables) : document_(document), tables_(tables) {}

  std::optional<GraphTextFault> fault;

  void compile() {
    for (const auto& [name, parameter] : document_.parameters)
      if (!parameter.formula.empty() && !read(name, parameter)) return;
    for (const auto& [name, steps] : formulas_) {
      std::vector<std::string> path;
      if (!add(name, path)) return;
    }
  }

 private:
  bool refuse(const std::string& parameter, const char* member, const std::string& sentence) {
    const JsonPath root, all(&root, "parameters"), one(&all, parameter);
    fault = GraphTextFault{JsonPath(&one, member).text(), sentence};
    return false;
  }

  bool read(const std::string& name, const GraphDocument::Parameter& parameter) {
    if (parameter.kind == GraphParameterKind::trigger)
      return refuse(name, "formula", "a trigger has no value to compute");
    if (parameter.initial != 0.0f) return refuse(name, "initial", "a computed parameter has no initial value");
    auto steps = parse_formula(parameter.formula);
    if (!steps) return refuse(name, "formula", steps.error());
    for (const NamedFormulaStep& step : *steps)
      if (step.kind == GraphFormulaKind::parameter && !document_.parameters.contains(step.parameter))
        return refuse(name, "formula", "there is no parameter \"" + step.parameter + "\"");
    formulas_.emplace(name, std::move(*steps));
    return true;
  }

  /// Adds the formulas that this one reads, then itself, unless they are there.
  /// in   path  parameters that are being added because each reads the next
  bool add(const std::string& name, std::vector<std::string>& path) {
    if (is_added_[name]) return true;
    for (const std::string& other : path)
      if (other == name) return refuse(path.front(), "formula", cycle_text(path, name));
    if (path.size() > 256) return refuse(path.front(), "formula", "more than 256 formulas read each other in a row");
    path.push_back(name);
    const std::vector<NamedFormulaStep>& steps = formulas_.at(name);
    for (const NamedFormulaStep& step : steps)
      if (step.kind == GraphFormulaKind::parameter && formulas_.contains(step.parameter) && !add(step.parameter, path))
        return false;
    path.pop_back();
    is_added_[name] = true;
    tables_.formulas.push_back(
        {index_of(name), static_cast<GraphIndex>(tables_.formula_steps.size()), static_cast<GraphIndex>(steps.size())});
    for (const NamedFormulaStep& step : steps)
      tables_.formula_steps.push_back(
          {step.value, step.kind == GraphFormulaKind::parameter ? index_of(step.parameter) : kNoGraphIndex, step.kind});
    return true;
  }

  static std::string cycle_text(const std::vector<std::string>& path, const std::string& name) {
    std::string text = "is computed from itself: ";
    for (const std::string& one : path) text += "\"" + one + "\" reads ";
    return text + "\"" + name + "\"";
  }

  GraphIndex index_of(const std::string& name) const {
    return static_cast<GraphIndex>(std::distance(document_.parameters.begin(), document_.parameters.find(name)));
  }

  const GraphDocument& document_;
  GraphTables& tables_;
  std::map<std::string, std::vector<NamedFormulaStep>> formulas_;
  std::map<std::string, bool> is_added_;
};

}  // namespace

std::optional<GraphTextFault> compile_formulas(const GraphDocument& document, GraphTables& tables) {
  FormulaCompiler compiler(document, tables);
  compiler.compile();
  return compiler.fault;
}

}  // namespace sinew
