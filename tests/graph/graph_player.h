// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/graph/graph_builder.h"
#include "runtime/graph/state_blocks.h"
#include "runtime/graph/update_graph.h"

namespace sinew::test {

/// One character: a graph, its clips, and everything that happened to it.
class GraphPlayer {
 public:
  GraphPlayer(const GraphBuilder& builder, GraphIndex root, std::vector<GraphClip> clips,
              std::size_t room_for_events = 4096, std::span<const std::uint32_t> mirrored_beats = {})
      : events_(room_for_events) {
    auto graph = builder.build(root);
    if (!graph) ADD_FAILURE() << describe(graph.error(), builder.tables(root));
    graph_ = std::move(graph.value());
    set_ = *GraphClipSet::make(graph_, clips, mirrored_beats);
    for (const GraphParameter& p : graph_.tables().parameters) values_.push_back(p.initial);
    state_.resize(graph_.state_bytes() / sizeof(std::uint64_t) + 1);
    start();
  }

  void start() { EXPECT_EQ(run(StartGraphJob{&graph_, &set_, values_, state()}), ErrorCode::ok); }
  void set(GraphIndex parameter, float value) { values_[parameter] = value; }
  void trigger(GraphIndex parameter) { EXPECT_EQ(set_trigger(graph_, state(), parameter), ErrorCode::ok); }

  const GraphStep& advance(double dt_s) {
    EXPECT_EQ(run(UpdateGraphJob{&graph_, &set_, values_, state(), dt_s, &program_, events_, &step_}), ErrorCode::ok);
    log_.insert(log_.end(), events_.begin(), events_.begin() + step_.event_count);
    root_ = normalised(root_ * step_.root_motion);
    return step_;
  }
  void advance(double dt_s, int times) {
    for (int i = 0; i < times; ++i) advance(dt_s);
  }

  /// Name of the state that a machine which lies at the root is in, or enters.
  std::string_view active() {
    const GraphTables& t = graph_.tables();
    const GraphIndex machine = t.nodes[t.root].settings;
    const MachineSlots slots{state().data() + graph_.offset_of(t.root), graph_.slot_bytes(machine),
                             graph_.largest_state(machine)};
    return t.name_at(t.states[t.machines[machine].first_state + slots.top().state].name);
  }

  std::span<std::byte> state() { return std::as_writable_bytes(std::span(state_)).first(graph_.state_bytes()); }
  PoseProgramSpan ops() const { return program_.ops(); }
  const std::vector<GraphEvent>& log() const { return log_; }
  const GraphDefinition& graph() const { return graph_; }
  const GraphClipSet& clips() const { return set_; }
  const DualQuatd& root() const { return root_; }
  const GraphStep& step() const { return step_; }
  std::vector<float>& values() { return values_; }

 private:
  GraphDefinition graph_;
  GraphClipSet set_;
  std::vector<float> values_;
  std::vector<std::uint64_t> state_;
  std::vector<GraphEvent> events_, log_;
  PoseProgram program_;
  GraphStep step_;
  DualQuatd root_;
};

}  // namespace sinew::test
