// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/graph/graph_definition.h"

namespace sinew {

/// A change of a graph's parameter at a time. Any value but 0 sets a trigger.
struct GraphSetting {
  double time_s = 0.0;
  std::string parameter;
  float value = 0.0f;
};

/// Reads "NAME=VALUE" (at time 0) or "NAME=VALUE@SECONDS".
/// err  a sentence that quotes the text
inline tl::expected<GraphSetting, std::string> parse_graph_setting(std::string_view text) {
  const auto number = [](std::string_view part) -> std::optional<double> {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc{} || stop != part.data() + part.size() || !(std::fabs(value) <= 1e30)) return std::nullopt;
    return value;
  };
  const std::size_t equals = text.find('='), at = text.rfind('@');
  const bool timed = equals != text.npos && at != text.npos && at > equals;
  const auto value =
      equals == text.npos ? std::nullopt : number(text.substr(equals + 1, timed ? at - equals - 1 : text.npos));
  const auto time_s = timed ? number(text.substr(at + 1)) : 0.0;
  if (equals == 0 || !value || !time_s || *time_s < 0.0)
    return tl::unexpected("'" + std::string(text) + "' is not NAME=VALUE or NAME=VALUE@SECONDS");
  return GraphSetting{*time_s, std::string(text.substr(0, equals)), static_cast<float>(*value)};
}

/// Brings settings into the order of time, and checks that callers may set their parameters.
/// err  "--set NAME: sentence"
inline tl::expected<std::vector<GraphSetting>, std::string> settings_for(const GraphDefinition& graph,
                                                                         std::vector<GraphSetting> settings) {
  const GraphTables& t = graph.tables();
  for (const GraphSetting& setting : settings) {
    const GraphIndex parameter = graph.find_parameter(setting.parameter);
    if (parameter != kNoGraphIndex && graph.is_computed(parameter))
      return tl::unexpected("--set " + setting.parameter + ": the graph computes this parameter");
    if (parameter != kNoGraphIndex) continue;
    std::string known;
    for (const GraphParameter& p : t.parameters)
      known += (known.empty() ? "\"" : ", \"") + std::string(t.name_at(p.name)) + '"';
    return tl::unexpected("--set " + setting.parameter + ": the graph has no such parameter; it has " +
                          (known.empty() ? "none" : known));
  }
  std::stable_sort(settings.begin(), settings.end(), [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  return settings;
}

}  // namespace sinew
