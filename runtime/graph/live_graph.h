// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/graph/graph_clips.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/graph/graph_layout.h"
#include "runtime/graph/graph_time.h"
#include "runtime/graph/live_motion.h"
#include "runtime/graph/state_blocks.h"

namespace sinew {

inline constexpr std::uint16_t kNoMotion = 0xFFFF;

/// A machine that plays.
struct LiveMachine {
  const GraphMachine* machine;
  MachineSlots slots;
  GraphIndex node;
  std::size_t first;  ///< first slot that plays; slots below are frozen by a cut (inertialize or dead_blend)
  std::size_t end;    ///< slots in use
  bool moves_root;    ///< false: its layer does not contribute to root motion
  float root_weight;  ///< share of the machine in the root motion of the graph, from the last weigh()
  std::array<std::uint16_t, kMostGraphFades + 1> driver;  ///< main motion of each slot, or kNoMotion
};

/// The part of a graph that plays, as flat lists. The lists are valid until a state is entered or left. Nodes that do
/// not play are never visited. Internal to graph/.
class LiveGraph {
 public:
  /// Keeps references to the arguments.
  LiveGraph(const GraphDefinition& graph, const GraphClipSet& clips, std::span<const float> parameters,
            std::byte* state) noexcept
      : graph_(graph), tables_(graph.tables()), clips_(clips), parameters_(parameters), state_(state) {}

  /// Makes the lists of the whole graph.
  void open() noexcept;
  /// Makes the lists of a single node, or of the slots [0, end) of a machine.
  /// out  the main motion of the node, or kNoMotion
  std::uint16_t open_only(GraphIndex node, std::byte* base) noexcept;
  void open_slots(GraphIndex node, std::byte* base, std::size_t end) noexcept;
  /// Sets the steps of motions with segments to those of the segments in which they move on. Lists that have just been
  /// opened are set for the way forwards.
  void follow_segments(bool backwards) noexcept;
  /// Computes the weights that all motions have `ahead` ticks from now.
  void weigh(GraphTicks ahead) noexcept;
  /// Same, for lists that open_slots has made: the shares in the motion of the machine.
  void weigh_slots(GraphTicks ahead) noexcept;
  /// Sets the steps of synchronised motions, by their weights `ahead` ticks from now.
  void match_lengths(GraphTicks ahead) noexcept;

  std::span<LiveMotion> motions() noexcept { return {motions_.data(), motion_count_}; }
  std::span<LiveMachine> machines() noexcept { return {machines_.data(), machine_count_}; }
  std::span<const LiveSample> samples_of(const LiveMotion& motion) const noexcept {
    return {samples_.data() + motion.first_sample, motion.sample_count};
  }
  bool plays_in_step() const noexcept { return plays_in_step_; }       ///< motions are synchronised while states fade
  std::size_t root_samples() const noexcept { return root_samples_; }  ///< samples of motions that move the root
  bool has_root_cuts() const noexcept { return has_root_cuts_; }       ///< frozen states still move the root

  const GraphDefinition& graph() const noexcept { return graph_; }
  const GraphTables& tables() const noexcept { return tables_; }
  const GraphClipSet& clips() const noexcept { return clips_; }
  std::span<const float> parameters() const noexcept { return parameters_; }
  std::byte* state() const noexcept { return state_; }
  GraphHeader& header() const noexcept { return block_at<GraphHeader>(state_); }
  float value_of(GraphIndex parameter) const noexcept { return parameters_[parameter]; }

  MachineSlots slots_of(GraphIndex node, std::byte* base) const noexcept {
    const GraphIndex machine = tables_.nodes[node].settings;
    return {base + graph_.offset_of(node), graph_.slot_bytes(machine), graph_.largest_state(machine)};
  }
  GraphIndex choice_of(const GraphSelect& select) const noexcept;
  float weight_of(const GraphLayer& layer) const noexcept;
  GraphTransitionKind kind_of(const GraphTransition& transition) const noexcept {
    return clips_.any_root_in_pose() ? GraphTransitionKind::cross_fade : transition.kind;
  }
  bool is_cut(const SlotState& slot) const noexcept {
    return slot.whole == 0 && kind_of(tables_.transitions[slot.transition]) != GraphTransitionKind::cross_fade;
  }
  /// The first slot of [0, end) that plays. It is the uppermost cut: all slots below it are frozen.
  std::size_t first_playing(const MachineSlots& slots, std::size_t end) const noexcept;
  /// Duration of the fade or transition by which a slot was entered.
  GraphTicks duration_of(const SlotState& slot) const noexcept { return graph_.duration_of(slot.transition); }
  /// Share of the slot's state in the mix with the slots below it.
  float fade_of(const SlotState& slot, GraphTicks ahead) const noexcept;
  /// Share that the states above the cut in slot `first`, and above all cuts below it, have in root motion. The frozen
  /// states below each cut have the remainder. 1 without a cut.
  float share_above_cuts(const MachineSlots& slots, std::size_t first, GraphTicks ahead) const noexcept;

 private:
  std::uint16_t open_node(GraphIndex node, std::byte* base) noexcept;
  std::uint16_t open_clip(GraphIndex node, std::byte* base) noexcept;
  std::uint16_t open_space(GraphIndex node, std::byte* base) noexcept;
  std::uint16_t open_machine(GraphIndex node, std::byte* base, std::size_t end) noexcept;
  void clear() noexcept;
  void follow_segment(LiveMotion& motion, bool backwards) noexcept;
  void weaken(std::size_t first_motion, std::size_t first_machine, float factor) noexcept;
  void weigh_node(GraphIndex node, std::byte* base, float weight, float root_weight) noexcept;
  void weigh_machine(LiveMachine& live, float weight, float root_weight) noexcept;
  double speed_of(const GraphClipNode& clip) const noexcept;

  const GraphDefinition& graph_;
  const GraphTables& tables_;
  const GraphClipSet& clips_;
  std::span<const float> parameters_;
  std::byte* state_;

  std::size_t motion_count_ = 0, sample_count_ = 0, machine_count_ = 0;
  std::size_t weighed_ = 0, weighed_machines_ = 0;  // weighed so far by the current weigh()
  GraphTicks ahead_ = 0;                            // argument of the current weigh()
  std::size_t root_samples_ = 0;
  bool plays_in_step_ = false, has_segments_ = false, has_root_cuts_ = false, moves_root_ = true, is_fresh_ = true;
  // Only the entries below the counts are initialised.
  std::array<LiveMotion, kMostPoseOps> motions_;
  std::array<LiveSample, kMostPoseOps> samples_;
  std::array<LiveMachine, kMostLiveMachines> machines_;
};

}  // namespace sinew
