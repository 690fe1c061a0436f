// SPDX-License-Identifier: MIT
#include "importer/tool/graph/graph_trace.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"
#include "runtime/base/checksum.h"
#include "runtime/graph/read_graph_state.h"
#include "runtime/graph/update_graph.h"

namespace sinew::tool {
namespace {

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// One character that plays.
class Tracer {
 public:
  explicit Tracer(const GraphOfModel& model)
      : graph_(model.graph), clips_(GraphClipSet::make(model.clips).value()), state_(graph_.state_bytes() / 8 + 1) {
    for (const GraphParameter& p : graph_.tables().parameters) values_.push_back(p.initial);
  }

  void set(const GraphScript::Setting& setting) {
    if (graph_.tables().parameters[setting.parameter].kind != GraphParameterKind::trigger)
      values_[setting.parameter] = setting.value;
    else if (setting.value != 0.0f)
      static_cast<void>(set_trigger(graph_, bytes(), setting.parameter));
  }
  ErrorCode start() { return run(StartGraphJob{&graph_, &clips_, values_, bytes()}); }
  ErrorCode advance(double dt_s) {
    return run(UpdateGraphJob{&graph_, &clips_, values_, bytes(), dt_s, &program_, events_, &step_});
  }

  Json frame(double time_s) {
    return {{"time_s", time_s}, {"states", states()}, {"program", program()}, {"events", events()}};
  }

 private:
  std::span<std::byte> bytes() { return std::as_writable_bytes(std::span(state_)); }
  std::string_view node_name(GraphIndex node) const {
    return graph_.tables().name_at(graph_.tables().nodes[node].name);
  }
  std::string_view state_name(GraphIndex machine, GraphIndex state) const {
    const GraphTables& t = graph_.tables();
    return t.name_at(t.states[t.machines[t.nodes[machine].settings].first_state + state].name);
  }

  Json states() {
    std::vector<GraphStateView> views(64);
    views.resize(std::min(read_graph_state(graph_, clips_, values_, bytes(), views), views.size()));
    Json list = Json::array();
    for (const GraphStateView& view : views)
      list.push_back({{"machine", node_name(view.node)},
                      {"state", state_name(view.node, view.state)},
                      {"weight", static_cast<double>(view.weight)},
                      {"time_s", view.time_s},
                      {"rounds", view.rounds}});
    return list;
  }

  Json program() const {
    Json list = Json::array();
    for (const PoseOp& op : program_.ops()) {
      Json entry{{"op", name_of(op.kind)}, {"index", op.index}, {"weight", static_cast<double>(op.weight)}};
      if (op.kind == PoseOpKind::sample || op.kind == PoseOpKind::sample_mirrored) entry["time_s"] = op.time_s;
      if (op.mask != PoseOp::kNoMask) entry["mask"] = op.mask;
      list.push_back(std::move(entry));
    }
    return list;
  }

  Json events() const {
    Json list = Json::array();
    for (std::size_t i = 0; i < step_.event_count; ++i) {
      const GraphEvent& e = events_[i];
      Json entry{{"time_s", seconds_of(e.at)}, {"node", node_name(e.node)}};
      if (e.kind == GraphEventKind::state)
        entry["entered"] = state_name(e.node, static_cast<GraphIndex>(e.index));
      else
        entry["event"] = e.index;
      entry["weight"] = static_cast<double>(e.weight);
      list.push_back(std::move(entry));
    }
    return list;
  }

  const GraphDefinition& graph_;
  GraphClipSet clips_;
  std::vector<float> values_;
  std::vector<std::uint64_t> state_;
  std::vector<GraphEvent> events_ = std::vector<GraphEvent>(1024);
  PoseProgram program_;
  GraphStep step_;
};

}  // namespace

tl::expected<std::vector<GraphScript::Setting>, std::string> read_settings(const std::vector<std::string>& texts,
                                                                           const GraphDefinition& graph) {
  std::vector<GraphScript::Setting> settings;
  for (const std::string& text : texts) {
    const auto refused = [&](const std::string& why) {
      return tl::unexpected("--set " + in_quotes(text) + ": " + why);
    };
    const std::size_t equals = text.find('='), at = text.rfind('@');
    if (equals == std::string::npos) return refused("is not NAME=VALUE@TIME");
    const bool has_time = at != std::string::npos && at > equals;
    const auto value = number_of(std::string_view(text).substr(equals + 1, has_time ? at - equals - 1 : text.npos));
    const auto time_s = has_time ? number_of(std::string_view(text).substr(at + 1)) : 0.0;
    if (!value || !time_s || std::fabs(*value) > 1e30) return refused("VALUE and TIME must be numbers");
    const GraphIndex parameter = graph.find_parameter(text.substr(0, equals));
    if (parameter == kNoGraphIndex) {
      std::string known;
      for (const GraphParameter& p : graph.tables().parameters)
        known += (known.empty() ? "" : ", ") + in_quotes(graph.tables().name_at(p.name));
      return refused("the graph has no such parameter; it has " + (known.empty() ? "none" : known));
    }
    settings.push_back({*time_s, parameter, static_cast<float>(*value)});
  }
  std::stable_sort(settings.begin(), settings.end(), [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  return settings;
}

Json trace_graph(const GraphOfModel& model, const GraphScript& script) {
  Tracer tracer(model);
  Json frames = Json::array();
  std::size_t next = 0;
  const auto apply = [&](double until_s) {
    for (; next < script.settings.size() && script.settings[next].time_s <= until_s + 1e-9; ++next)
      tracer.set(script.settings[next]);
  };
  const auto count = static_cast<std::uint32_t>(std::floor(script.duration_s * script.fps + 1e-9));
  apply(0.0);
  ErrorCode code = tracer.start();
  next = 0;  // start() forgets triggers, so the settings at time 0 are applied again
  for (std::uint32_t i = 0; i <= count && code == ErrorCode::ok; ++i) {
    const double time_s = i / script.fps;
    if (i > 0) apply((i - 1) / script.fps);
    code = tracer.advance(i == 0 ? 0.0 : time_s - (i - 1) / script.fps);
    frames.push_back(tracer.frame(time_s));
  }
  const std::string text = frames.dump();
  Json trace{{"fps", script.fps}, {"frames", frames}};
  trace["hash"] = fmt::format("{:016x}", checksum(std::as_bytes(std::span(text))));
  if (code != ErrorCode::ok) trace["error"] = describe(code);
  return trace;
}

std::string trace_text(const Json& trace) {
  TextTable table({"time", "states", "program", "events"});
  for (const Json& frame : trace["frames"]) {
    std::string states, program, events;
    for (const Json& state : frame["states"])
      states +=
          fmt::format("{}{}:{} {:.3f} ({:.3f} s)", states.empty() ? "" : ", ", state["machine"].get<std::string>(),
                      state["state"].get<std::string>(), state["weight"].get<double>(), state["time_s"].get<double>());
    for (const Json& op : frame["program"]) {
      program += fmt::format("{}{} {}", program.empty() ? "" : ", ", op["op"].get<std::string>(),
                             op["index"].get<std::uint32_t>());
      if (op.contains("time_s")) program += fmt::format(" at {:.3f}", op["time_s"].get<double>());
      program += fmt::format(" x {:.3f}", op["weight"].get<double>());
    }
    for (const Json& event : frame["events"])
      events += fmt::format("{}{} {} at {:.4f}", events.empty() ? "" : ", ", event["node"].get<std::string>(),
                            event.contains("entered") ? "enters " + event["entered"].get<std::string>()
                                                      : "event " + std::to_string(event["event"].get<std::uint32_t>()),
                            event["time_s"].get<double>());
    table.add({fmt::format("{:.4f}", frame["time_s"].get<double>()), states, program, events});
  }
  return table.text() + "hash " + trace["hash"].get<std::string>() + '\n';
}

}  // namespace sinew::tool
