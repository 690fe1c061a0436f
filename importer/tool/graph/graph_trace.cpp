// SPDX-License-Identifier: MIT
#include "importer/tool/graph/graph_trace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"
#include "runtime/base/checksum.h"
#include "runtime/graph/read_graph_state.h"
#include "runtime/graph/update_graph.h"

namespace sinew::tool {
namespace {

/// One character that plays.
class Tracer {
 public:
  explicit Tracer(const GraphOfModel& model)
      : graph_(model.graph), clips_(model.clips), state_(graph_.state_bytes() / 8 + 1) {
    for (const GraphParameter& p : graph_.tables().parameters) values_.push_back(p.initial);
  }

  void set(const GraphSetting& setting) {
    const GraphIndex parameter = graph_.find_parameter(setting.parameter);
    if (graph_.tables().parameters[parameter].kind != GraphParameterKind::trigger)
      values_[parameter] = setting.value;
    else if (setting.value != 0.0f)
      static_cast<void>(set_trigger(graph_, bytes(), parameter));
  }
  ErrorCode start() { return run(StartGraphJob{&graph_, &clips_, values_, bytes()}); }
  ErrorCode advance(double dt_s) {
    return run(UpdateGraphJob{&graph_, &clips_, values_, bytes(), dt_s, &program_, events_, &step_});
  }

  const PoseProgram& pose_program() const { return program_; }
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
  const GraphClipSet& clips_;
  std::vector<float> values_;
  std::vector<std::uint64_t> state_;
  std::vector<GraphEvent> events_ = std::vector<GraphEvent>(1024);
  PoseProgram program_;
  GraphStep step_;
};

/// Plays a script. Calls each_frame(time in seconds) after each frame.
template <class EachFrame>
ErrorCode play(Tracer& tracer, const GraphScript& script, const EachFrame& each_frame) {
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
    each_frame(time_s);
  }
  return code;
}

}  // namespace

Json trace_graph(const GraphOfModel& model, const GraphScript& script) {
  Tracer tracer(model);
  Json frames = Json::array();
  const ErrorCode code = play(tracer, script, [&](double time_s) { frames.push_back(tracer.frame(time_s)); });
  const std::string text = frames.dump();
  Json trace{{"fps", script.fps}, {"frames", frames}};
  trace["hash"] = fmt::format("{:016x}", checksum(std::as_bytes(std::span(text))));
  if (code != ErrorCode::ok) trace["error"] = describe(code);
  return trace;
}

GraphMoment play_graph(const GraphOfModel& model, const GraphScript& script) {
  Tracer tracer(model);
  GraphMoment moment;
  if (play(tracer, script, [&](double time_s) { moment.time_s = time_s; }) != ErrorCode::ok) return moment;
  moment.program = tracer.pose_program();
  moment.states = tracer.states();
  return moment;
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
