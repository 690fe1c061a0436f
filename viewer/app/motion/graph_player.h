// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "runtime/graph/read_graph_state.h"
#include "runtime/graph/update_graph.h"
#include "viewer/app/motion/character_rig.h"

namespace sinew::viewer {

/// A character that a motion graph plays. It can go to any time. Forward it plays on, with the changes of the script.
/// Backward it returns to a recorded moment, and plays from there.
class GraphPlayer {
 public:
  explicit GraphPlayer(std::shared_ptr<const GraphOnScene> graph);

  /// Plays to a time.
  /// in   time_s  >= 0
  void seek(double time_s);

  /// Takes over the state of another player at its time, after the graph's file has changed: what the new graph still
  /// has goes on. Returning to an earlier time plays the new graph from its start.
  void continue_from(const GraphPlayer& before);

  double time_s() const noexcept { return time_s_; }
  PoseProgramSpan program() const noexcept { return program_.ops(); }

  /// The place of the character in the world, and the place that its pose already has. FrameInput::root is the product
  /// of the first and the inverse of the second.
  const DualQuatd& world() const noexcept { return world_; }
  const DualQuatd& place() const noexcept { return place_; }

  /// Values of the parameters. A change takes effect from the current time on; the script's changes after that time
  /// still come.
  std::span<const float> parameters() const noexcept { return values_; }
  void set_parameter(GraphIndex parameter, float value);

  /// States that play, with their weights, and the names to show them.
  std::span<const GraphStateView> states();
  std::string_view state_name(const GraphStateView& state) const noexcept;
  std::string_view machine_name(const GraphStateView& state) const noexcept;

  const GraphOnScene& graph() const noexcept { return *graph_; }

 private:
  /// A moment to return to.
  struct Record {
    double time_s = 0.0;
    std::vector<std::uint64_t> state;
    std::vector<float> values;
    DualQuatd world, place;
    PoseProgram program;
    std::size_t next_setting = 0;
  };
  std::span<const std::byte> bytes() const noexcept { return std::as_bytes(std::span(state_)); }
  std::span<std::byte> bytes() noexcept { return std::as_writable_bytes(std::span(state_)); }
  void start();
  void advance_to(double time_s);
  void apply_script(double until_s);
  void record();
  void return_to(const Record& record);

  std::shared_ptr<const GraphOnScene> graph_;
  std::vector<std::uint64_t> state_;
  std::vector<float> values_;
  std::vector<GraphStateView> views_;
  PoseProgram program_;
  GraphStep step_;
  DualQuatd world_, place_;
  double time_s_ = 0.0;
  std::size_t next_setting_ = 0;  ///< first change of the script that has not happened
  std::vector<Record> records_;   ///< rising times, at least kRecordEvery_s apart
};

}  // namespace sinew::viewer
