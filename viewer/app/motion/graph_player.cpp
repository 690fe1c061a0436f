// SPDX-License-Identifier: MIT
#include "viewer/app/motion/graph_player.h"

#include <algorithm>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/graph/carry_state.h"

namespace sinew::viewer {
namespace {

constexpr double kRecordEvery_s = 0.1;
constexpr std::size_t kMostStates = 64;

}  // namespace

GraphPlayer::GraphPlayer(std::shared_ptr<const GraphOnScene> graph)
    : graph_(std::move(graph)), state_(graph_->graph.state_bytes() / 8, 0) {
  start();
}

void GraphPlayer::start() {
  values_.clear();
  for (const GraphParameter& parameter : graph_->graph.tables().parameters) values_.push_back(parameter.initial);
  time_s_ = 0.0;
  next_setting_ = 0;
  world_ = place_ = {};
  records_.clear();
  apply_script(0.0);
  CONTRACT(run(StartGraphJob{&graph_->graph, &graph_->clips, values_, bytes()}) == ErrorCode::ok);
  next_setting_ = 0;  // the start forgets triggers, so the settings of time 0 are applied again
  apply_script(0.0);
  advance_to(0.0);
}

// Applies the changes of the script up to a time, that time included.
void GraphPlayer::apply_script(double until_s) {
  const std::vector<GraphSetting>& script = graph_->script;
  for (; next_setting_ < script.size() && script[next_setting_].time_s <= until_s; ++next_setting_)
    set_parameter(graph_->graph.find_parameter(script[next_setting_].parameter), script[next_setting_].value);
}

void GraphPlayer::set_parameter(GraphIndex parameter, float value) {
  if (graph_->graph.tables().parameters[parameter].kind != GraphParameterKind::trigger)
    values_[parameter] = value;
  else if (value != 0.0f)
    CONTRACT(set_trigger(graph_->graph, bytes(), parameter) == ErrorCode::ok);
  while (!records_.empty() && records_.back().time_s >= time_s_) records_.pop_back();  // the future changes
}

void GraphPlayer::continue_from(const GraphPlayer& before) {
  const GraphTables &old_tables = before.graph_->graph.tables(), &tables = graph_->graph.tables();
  for (std::size_t p = 0; p < tables.parameters.size(); ++p) {
    const GraphIndex old = before.graph_->graph.find_parameter(tables.name_at(tables.parameters[p].name));
    if (old != kNoGraphIndex && old_tables.parameters[old].kind == tables.parameters[p].kind)
      values_[p] = before.values_[old];
  }
  CONTRACT(run(CarryStateJob{&before.graph_->graph, before.bytes(), &graph_->graph, &graph_->clips, values_,
                             bytes()}) == ErrorCode::ok);
  world_ = before.world_;
  time_s_ = before.time_s_;
  records_.clear();
  const std::vector<GraphSetting>& script = graph_->script;
  next_setting_ = static_cast<std::size_t>(
      std::count_if(script.begin(), script.end(), [&](const GraphSetting& s) { return s.time_s <= time_s_; }));
  advance_to(time_s_);
}

void GraphPlayer::advance_to(double time_s) {
  const UpdateGraphJob job{&graph_->graph, &graph_->clips, values_, bytes(), time_s - time_s_, &program_, {}, &step_};
  CONTRACT(run(job) == ErrorCode::ok);
  world_ = normalised(world_ * step_.root_motion);
  place_ = step_.root_place;
  time_s_ = time_s;
}

void GraphPlayer::record() {
  if (!records_.empty() && time_s_ < records_.back().time_s + kRecordEvery_s) return;
  records_.push_back({time_s_, state_, values_, world_, place_, program_, next_setting_});
}

void GraphPlayer::return_to(const Record& record) {
  state_ = record.state;
  values_ = record.values;
  world_ = record.world;
  place_ = record.place;
  program_ = record.program;
  time_s_ = record.time_s;
  next_setting_ = record.next_setting;
}

void GraphPlayer::seek(double time_s) {
  if (time_s < time_s_) {
    while (!records_.empty() && records_.back().time_s > time_s) records_.pop_back();
    if (records_.empty())
      start();
    else
      return_to(records_.back());
  }
  while (time_s_ < time_s) {
    record();
    apply_script(time_s_);
    double until = std::min(time_s, time_s_ + kMostGraphStep_s);
    if (next_setting_ < graph_->script.size()) until = std::min(until, graph_->script[next_setting_].time_s);
    advance_to(until);
  }
}

std::span<const GraphStateView> GraphPlayer::states() {
  views_.resize(kMostStates);
  const std::size_t count = read_graph_state(graph_->graph, graph_->clips, values_, bytes(), views_);
  views_.resize(std::min(count, kMostStates));
  return views_;
}

std::string_view GraphPlayer::state_name(const GraphStateView& state) const noexcept {
  const GraphTables& t = graph_->graph.tables();
  return t.name_at(t.states[t.machines[t.nodes[state.node].settings].first_state + state.state].name);
}

std::string_view GraphPlayer::machine_name(const GraphStateView& state) const noexcept {
  return graph_->graph.tables().name_at(graph_->graph.tables().nodes[state.node].name);
}

}  // namespace sinew::viewer
