// SPDX-License-Identifier: MIT
#include "importer/tool/info/clip_annotations.h"

#include <cstddef>
#include <variant>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/tool/wrapped_text.h"

namespace sinew::tool {
namespace {

/// "events of "walk": A, B" over as many lines as it takes.
std::string list_of(const char* what, const Json& clip, const std::string& entries) {
  if (entries.empty()) return {};
  const std::string begin = fmt::format("{} of {}: ", what, in_quotes(clip["name"].get<std::string>()));
  return begin + wrapped(entries, 2, begin.size()) + '\n';
}

}  // namespace

void add_annotations(const Annotations& annotations, Json& clip) {
  static constexpr const char* kTypes[] = {"float", "vec2", "vec3", "vec4", "rotation", "flag"};  // as in CurveKeys
  Json events = Json::array(), curves = Json::array();
  for (std::size_t e = 0; e < annotations.event_times_s.size(); ++e)
    events.push_back({{"time_s", annotations.event_times_s[e]}, {"name", annotations.event_names[e]}});
  for (const NamedCurve& curve : annotations.curves)
    curves.push_back({{"name", curve.name},
                      {"type", kTypes[curve.keys.index()]},
                      {"keys", std::visit([](const auto& keys) { return keys.size(); }, curve.keys)}});
  clip["events"] = events;
  clip["curves"] = curves;
}

std::string annotation_lines(const Json& clip) {
  std::string events, curves;
  for (const Json& event : clip["events"])
    events += fmt::format("{}{} at {:g} s", events.empty() ? "" : ", ", in_quotes(event["name"].get<std::string>()),
                          event["time_s"].get<double>());
  for (const Json& curve : clip["curves"])
    curves += fmt::format("{}{} ({}, {})", curves.empty() ? "" : ", ", in_quotes(curve["name"].get<std::string>()),
                          curve["type"].get<std::string>(), counted(curve["keys"].get<std::size_t>(), "key"));
  return list_of("events", clip, events) + list_of("curves", clip, curves);
}

}  // namespace sinew::tool
