// SPDX-License-Identifier: MIT
#include "importer/tool/graph/golden_trace.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/file/regular_file.h"
#include "importer/graph/graph_files.h"
#include "importer/platform/files.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

/// Six digits, so that a frame of another machine has the same text nearly always.
std::string rounded(double value) { return fmt::format("{:.6g}", value == 0.0 ? 0.0 : value); }

/// The graph's name for a clip of the model.
std::string clip_name(const GraphOfModel& model, std::uint32_t clip) {
  const GraphTables& tables = model.graph.tables();
  for (std::size_t c = 0; c < tables.clip_names.size(); ++c)
    if (model.clips.entries()[c].clip == clip) return std::string(tables.name_at(tables.clip_names[c]));
  return std::to_string(clip);
}

std::string states_of(const Json& frame) {
  std::string text;
  for (const Json& state : frame["states"])
    text += fmt::format("{}{}:{} {} for {} s", text.empty() ? "" : ", ", state["machine"].get<std::string>(),
                        state["state"].get<std::string>(), rounded(state["weight"].get<double>()),
                        rounded(state["time_s"].get<double>()));
  return text;
}

std::string program_of(const GraphOfModel& model, const Json& frame) {
  std::string text;
  for (const Json& op : frame["program"]) {
    const bool is_sample = op.contains("time_s");
    const auto index = op["index"].get<std::uint32_t>();
    text += (text.empty() ? "" : ", ") + op["op"].get<std::string>() + ' ' +
            (is_sample ? clip_name(model, index) : std::to_string(index));
    if (is_sample) text += " at " + rounded(op["time_s"].get<double>());
    text += " x " + rounded(op["weight"].get<double>());
    if (op.contains("mask")) text += " mask " + std::to_string(op["mask"].get<std::uint32_t>());
  }
  return text;
}

std::string events_of(const Json& frame) {
  std::string text;
  for (const Json& event : frame["events"]) {
    text += (text.empty() ? "" : ", ") + event["node"].get<std::string>();
    if (event.contains("entered"))
      text += " enters " + event["entered"].get<std::string>();
    else
      text +=
          fmt::format(" event {} x {}", event["event"].get<std::uint32_t>(), rounded(event["weight"].get<double>()));
    text += " at " + rounded(event["time_s"].get<double>());
  }
  return text;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// A number, perhaps with a comma behind it.
std::optional<double> number_in(std::string_view word) {
  if (word.ends_with(',')) word.remove_suffix(1);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || stop != word.data() + word.size()) return std::nullopt;
  return value;
}

bool agree(const std::string& before, const std::string& now) {
  if (before == now) return true;
  const auto a = number_in(before), b = number_in(now);
  return a && b && before.ends_with(',') == now.ends_with(',') &&
         std::fabs(*a - *b) <= 2e-5 * std::max({1.0, std::fabs(*a), std::fabs(*b)});
}

tl::expected<std::vector<GraphSetting>, std::string> settings_of(const TraceDocument& document,
                                                                 const GraphDefinition& graph) {
  std::vector<GraphSetting> settings;
  for (const std::string& text : document.set) {
    auto setting = parse_graph_setting(text);
    if (!setting) return tl::unexpected("/set: " + setting.error());
    settings.push_back(std::move(*setting));
  }
  return settings_for(graph, std::move(settings));
}

}  // namespace

bool is_golden_trace(const std::string& file) {
  const std::vector<std::byte> bytes = RegularFile(platform::path_of(file)).read_up_to(64);
  std::string begin(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::erase_if(begin, [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
  return begin.starts_with("{\"trace\":");
}

std::vector<std::string> trace_lines(const GraphOfModel& model, const Json& trace) {
  std::vector<std::string> lines;
  for (const Json& frame : trace["frames"])
    lines.push_back(rounded(frame["time_s"].get<double>()) + " s | " + states_of(frame) + " | " +
                    program_of(model, frame) + " | " + events_of(frame));
  return lines;
}

std::string compare_trace_lines(const std::string& before, const std::string& now) {
  const std::vector<std::string> a = words_of(before), b = words_of(now);
  if (a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), agree)) return {};
  return "was \"" + before + "\" and is \"" + now + '"';
}

std::string golden_trace_text(const TraceDocument& trace) {
  Json json{{"trace", 1}, {"graph", trace.graph}};
  if (!trace.variation.empty()) json["variation"] = trace.variation;
  if (!trace.set.empty()) json["set"] = Json(trace.set);
  json["duration_s"] = trace.duration_s;
  json["fps"] = trace.fps;
  json["frames"] = Json(trace.frames);
  return json.dump(2) + '\n';
}

tl::expected<TraceComparison, std::string> compare_with_golden(const std::string& golden, const Scene& scene) {
  const auto text = read_json_file(golden);
  if (!text) return tl::unexpected(text.error());
  const auto document = read_trace(*text);
  if (!document) return tl::unexpected(fault_text(golden, document.error()));
  if (!(document->duration_s >= 0.0 && document->fps > 0.0 && document->duration_s * document->fps <= 1e6))
    return tl::unexpected(fault_text(golden, {"/fps", "has too many frames, or none"}));
  const std::string graph =
      platform::text_of(platform::path_of(golden).parent_path() / platform::path_of(document->graph));
  const auto model = load_graph(graph, scene, {.variation = document->variation});
  if (!model) return tl::unexpected(model.error());
  auto settings = settings_of(*document, model->graph);
  if (!settings) return tl::unexpected(golden + ": " + settings.error());
  const Json trace = trace_graph(*model, {std::move(*settings), document->duration_s, document->fps});
  TraceComparison comparison{*document, 0, {}};
  comparison.today.frames = trace_lines(*model, trace);
  const std::vector<std::string>&before = document->frames, &now = comparison.today.frames;
  comparison.compared = std::min(before.size(), now.size());
  if (before.size() != now.size())
    comparison.differences.push_back(fmt::format("it had {} and has {}", counted(before.size(), "frame"), now.size()));
  for (std::size_t f = 0; f < comparison.compared; ++f)
    if (const std::string difference = compare_trace_lines(before[f], now[f]); !difference.empty())
      comparison.differences.push_back(fmt::format("frame {}: {}", f, difference));
  return comparison;
}

}  // namespace sinew::tool
