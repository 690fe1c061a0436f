// SPDX-License-Identifier: MIT
#include "runtime/graph/update_graph.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/graph/enter_state.h"
#include "runtime/graph/graph_values.h"
#include "runtime/graph/live_graph.h"
#include "runtime/graph/move_root.h"
#include "runtime/graph/next_moment.h"
#include "runtime/graph/play_motions.h"
#include "runtime/graph/raw_array.h"
#include "runtime/graph/write_program.h"

namespace sinew {
namespace {

/// One update of one character. The step is cut into pieces at the moments where something starts or ends.
class GraphUpdate {
 public:
  GraphUpdate(const UpdateGraphJob& job, GraphStep& step) noexcept
      : values_(job.graph->tables(), job.parameters),
        live_(*job.graph, *job.clips, values_.all(), job.state.data()),
        step_(step),
        log_(job.events, step) {}

  void play(double dt_s) noexcept {
    GraphHeader& header = live_.header();
    const double due_s = dt_s + header.rest_s;
    const GraphTicks ticks = ticks_of(due_s);
    header.rest_s = due_s - seconds_of(ticks);
    if (!live_.tables().selects.empty()) follow_choices(live_, live_.tables().root, live_.state());
    live_.open();
    if (ticks < 0)
      play_backwards(-ticks);
    else
      play_forwards(ticks);
    if (live_.clips().any_root()) {
      step_.root_motion = normalised(step_.root_motion);
      step_.root_place = root_place_now(live_);
    }
  }

  LiveGraph& live() noexcept { return live_; }

 private:
  bool needs_cells() const noexcept {
    return live_.plays_in_step() || (live_.clips().any_root() && (live_.root_samples() > 1 || live_.has_root_cuts()));
  }

  /// Prepares the next piece and returns its longest length in ticks. The steps of motions are constant within it.
  GraphTicks prepare_piece(GraphTicks left, bool backwards) noexcept {
    const GraphTicks now = live_.header().now;
    live_.follow_segments(backwards);
    if (live_.plays_in_step()) live_.match_lengths(to_cell_middle(now, backwards));
    GraphTicks piece = longest_piece(live_, left, backwards);
    if (needs_cells()) piece = std::min(piece, to_cell_end(now, backwards));
    return piece;
  }

  void play_piece(GraphTicks ticks) noexcept {
    if (ticks == 0) return;
    if (live_.clips().any_root() && (live_.root_samples() > 0 || live_.has_root_cuts()))
      step_.root_motion = step_.root_motion * move_root(live_, ticks);
    play_motions(live_, ticks, log_);
    live_.header().now += ticks;
  }

  void play_backwards(GraphTicks left) noexcept {
    while (left > 0) {
      const GraphTicks piece = prepare_piece(left, true);
      play_piece(-piece);
      left -= piece;
    }
  }

  void play_forwards(GraphTicks left) noexcept {
    for (;;) {
      GraphTicks piece = prepare_piece(left, false);
      piece = find_next_moments(piece);
      play_piece(piece);
      left -= piece;
      for (const LiveMachine& machine : live_.machines())
        for (std::size_t i = 0; i < machine.slots.depth(); ++i)
          if (SlotState& slot = machine.slots.slot(i); i >= machine.first || live_.is_cut(slot)) slot.time += piece;
      if (pass_moment(piece)) {
        live_.open();
      } else if (left == 0) {
        break;
      }
    }
    live_.header().asked_machine = kNoGraphIndex;
  }

  /// out  ticks until the first transition or end of a fade, at most `piece`
  GraphTicks find_next_moments(GraphTicks piece) noexcept {
    const auto machines = live_.machines();
    const bool may_take = taken_ < kMostGraphTransitions;
    GraphTicks first = piece;
    for (std::size_t m = 0; m < machines.size(); ++m) {
      next_.put(m, may_take ? next_transition(live_, live_.motions(), machines[m], piece) : NextTransition{});
      first = std::min({first, next_[m].in, next_fade_end(live_, machines[m])});
    }
    return first;
  }

  /// Ends fades and takes transitions that are due. If a state has moved in memory, machines within it wait for the
  /// next piece, which may have length 0.
  /// out  true: a state was entered or left, so the live lists must be made again
  bool pass_moment(GraphTicks piece) noexcept {
    const std::byte* moved_end = nullptr;
    std::uint64_t triggers = 0;
    const auto machines = live_.machines();
    for (std::size_t m = 0; m < machines.size(); ++m) {
      const LiveMachine& machine = machines[m];
      if (machine.slots.memory < moved_end) continue;
      bool moved = end_fades(live_, machine);
      if (next_[m].in == piece && taken_ < kMostGraphTransitions) {
        take(machine, next_[m], triggers);
        moved = true;
      }
      if (moved) moved_end = machine.slots.at(machine.machine->fades + 1u);
    }
    live_.header().triggers &= ~triggers;
    step_.transitions_left_out = taken_ >= kMostGraphTransitions;
    return moved_end != nullptr;
  }

  void take(const LiveMachine& machine, const NextTransition& next, std::uint64_t& triggers) noexcept {
    GraphHeader& header = live_.header();
    if (header.asked_machine == machine.node) header.asked_machine = kNoGraphIndex;
    take_transition(live_, machine, next, triggers);
    log_.add({.at = header.now, .node = machine.node, .index = next.to, .kind = GraphEventKind::state});
    ++taken_;
  }

  GraphValues values_;
  LiveGraph live_;
  GraphStep& step_;
  GraphEventLog log_;
  std::uint32_t taken_ = 0;
  RawArray<NextTransition, kMostLiveMachines> next_;  // [machines]
};

ErrorCode check_assets(const GraphDefinition* graph, const GraphClipSet* clips, std::span<const float> parameters,
                       std::span<const std::byte> state) noexcept {
  if (graph == nullptr || clips == nullptr) return ErrorCode::size_mismatch;
  const GraphTables& t = graph->tables();
  if (clips->entries().size() < t.clip_names.size() || parameters.size() < t.parameters.size() ||
      state.size() < graph->state_bytes() || !have_memory(parameters, state))
    return ErrorCode::size_mismatch;
  if (reinterpret_cast<std::uintptr_t>(state.data()) % alignof(GraphHeader) != 0) return ErrorCode::size_mismatch;
  for (std::size_t p = 0; p < t.parameters.size(); ++p)
    if (!std::isfinite(parameters[p])) return ErrorCode::not_finite;
  return ErrorCode::ok;
}

ErrorCode check_state(const GraphDefinition& graph, std::span<std::byte> state) noexcept {
  if (state.size() < graph.state_bytes() || state.empty()) return ErrorCode::wrong_plan;
  return block_at<GraphHeader>(state.data()).signature == graph.signature() ? ErrorCode::ok : ErrorCode::wrong_plan;
}

}  // namespace

ErrorCode check(const StartGraphJob& job) noexcept {
  return check_assets(job.graph, job.clips, job.parameters, job.state);
}

void run_unchecked(const StartGraphJob& job) noexcept {
  std::memset(job.state.data(), 0, job.graph->state_bytes());
  block_at<GraphHeader>(job.state.data()) = {.signature = job.graph->signature()};
  const GraphValues values(job.graph->tables(), job.parameters);
  const LiveGraph live(*job.graph, *job.clips, values.all(), job.state.data());
  start_node(live, job.graph->tables().root, job.state.data());
}

ErrorCode check(const UpdateGraphJob& job) noexcept {
  const ErrorCode code = check_assets(job.graph, job.clips, job.parameters, job.state);
  if (code != ErrorCode::ok) return code;
  if (job.program == nullptr || job.step == nullptr || !have_memory(job.events)) return ErrorCode::size_mismatch;
  if (!std::isfinite(job.dt_s)) return ErrorCode::not_finite;
  if (std::fabs(job.dt_s) > kMostGraphStep_s) return ErrorCode::too_large;
  return check_state(*job.graph, job.state);
}

void run_unchecked(const UpdateGraphJob& job) noexcept {
  *job.step = {};
  GraphUpdate update(job, *job.step);
  update.play(job.dt_s);
  write_program(update.live(), *job.program);
}

namespace {

ErrorCode change_trigger(const GraphDefinition& graph, std::span<std::byte> state, GraphIndex parameter,
                         bool set) noexcept {
  const auto& parameters = graph.tables().parameters;
  if (parameter >= parameters.size() || parameters[parameter].kind != GraphParameterKind::trigger)
    return ErrorCode::index_out_of_range;
  if (const ErrorCode code = check_state(graph, state); code != ErrorCode::ok) return code;
  std::uint64_t& triggers = block_at<GraphHeader>(state.data()).triggers;
  const std::uint64_t bit = std::uint64_t{1} << parameter;
  triggers = set ? triggers | bit : triggers & ~bit;
  return ErrorCode::ok;
}

}  // namespace

ErrorCode set_trigger(const GraphDefinition& graph, std::span<std::byte> state, GraphIndex parameter) noexcept {
  return change_trigger(graph, state, parameter, true);
}

ErrorCode reset_trigger(const GraphDefinition& graph, std::span<std::byte> state, GraphIndex parameter) noexcept {
  return change_trigger(graph, state, parameter, false);
}

ErrorCode request_state(const GraphDefinition& graph, std::span<std::byte> state, GraphIndex machine,
                        GraphIndex target) noexcept {
  const GraphTables& t = graph.tables();
  if (machine >= t.nodes.size() || t.nodes[machine].kind != GraphNodeKind::machine)
    return ErrorCode::index_out_of_range;
  if (target != kNextState && target >= t.machines[t.nodes[machine].settings].state_count)
    return ErrorCode::index_out_of_range;
  if (const ErrorCode code = check_state(graph, state); code != ErrorCode::ok) return code;
  GraphHeader& header = block_at<GraphHeader>(state.data());
  header.asked_machine = machine;
  header.asked_state = target;
  return ErrorCode::ok;
}

}  // namespace sinew
