// SPDX-License-Identifier: MIT
#include "runtime/graph/move_root.h"

#include <algorithm>
#include <cstddef>

#include "runtime/graph/raw_array.h"
#include "runtime/graph/rigid_exponential.h"
#include "runtime/graph/whole_division.h"

namespace sinew {
namespace {

GraphTicks cell_start(GraphTicks now, bool backwards) noexcept {
  return divided_down(backwards ? now - 1 : now, kRootCell) * kRootCell;
}

/// The motion of one clip between two positions, which may lie in different rounds.
DualQuatd sample_motion(const LiveGraph& live, const LiveMotion& motion, const LiveSample& sample, std::int64_t from,
                        std::int64_t to) noexcept {
  if (sample.entry->root == nullptr || motion.period == 0) return {};
  PlaybackStep step;
  step.mode = motion.loop ? PlayMode::loop : PlayMode::clamp;
  step.duration_s = sample.entry->duration_s;
  if (motion.loop) {
    const ClipPlace start = motion.place_of(sample, from), end = motion.place_of(sample, to);
    step.from_turns = start.turns;
    step.from_s = start.time_s;
    step.to_turns = end.turns;
    step.to_s = end.time_s;
  } else {
    step.from_s = motion.time_s(sample, std::clamp(from, std::int64_t{0}, motion.period));
    step.to_s = motion.time_s(sample, std::clamp(to, std::int64_t{0}, motion.period));
  }
  const DualQuatd moved = sample.entry->root->motion(step);
  return sample.mirror ? mirrored_motion(moved, live.clips().mirror_normal()) : moved;
}

/// The weighted sum of motions over a cell.
struct TwistSum {
  RigidTwist twist;
  double total = 0.0;

  void add(const RigidTwist& other, double weight) noexcept {
    twist.turn += other.turn * weight;
    twist.shift += other.shift * weight;
  }

  /// in   behind  ticks from now to the start of the cell
  void add_cell(const LiveGraph& live, const LiveMotion& motion, GraphTicks behind) noexcept {
    if (!motion.moves_root || !(motion.root_weight > 0.0f)) return;
    std::int64_t from = motion.state->position + motion.step * behind;
    const std::int64_t to = motion.state->position + motion.step * (behind + kRootCell);
    // A clip that started within the cell and does not loop has no motion before its start. Its velocity since the
    // start is used for the whole cell.
    double scale = 1.0;
    if (!motion.loop && from < 0 && to > 0) {
      scale = static_cast<double>(to - from) / static_cast<double>(to);
      from = 0;
    }
    for (const LiveSample& sample : live.samples_of(motion)) {
      const double weight = static_cast<double>(motion.root_weight) * static_cast<double>(sample.share);
      total += weight;
      if (sample.entry->root == nullptr) continue;
      add(logarithm(sample_motion(live, motion, sample, from, to)), weight * scale);
    }
  }
};

/// Adds the motion of the states that the cuts of a machine have frozen. Each goes on with the velocity that it had
/// when it was left, and its share falls with the curve of the pose.
/// in   middle  ticks from now to the middle of the cell
void add_frozen(const LiveGraph& live, const LiveMachine& machine, GraphTicks middle, TwistSum& sum) noexcept {
  const MachineSlots& slots = machine.slots;
  std::byte* const base = slots.memory - live.graph().offset_of(machine.node);
  for (std::size_t cut = machine.first; cut > 0; cut = live.first_playing(slots, cut)) {
    const float share = (1.0f - live.fade_of(slots.slot(cut), middle)) *
                        live.share_above_cuts(slots, live.first_playing(slots, cut), middle);
    const double weight = static_cast<double>(machine.root_weight * share);
    if (!(weight > 0.0)) continue;
    LiveGraph then(live.graph(), live.clips(), {slots.started_parameters(cut), live.parameters().size()}, live.state());
    then.open_slots(machine.node, base, cut);
    then.weigh_slots(0);
    then.match_lengths(0);
    TwistSum frozen;
    for (const LiveMotion& motion : then.motions()) frozen.add_cell(then, motion, 0);
    sum.total += weight;
    if (frozen.total > 0.0) sum.add(frozen.twist, weight / frozen.total);
  }
}

}  // namespace

GraphTicks to_cell_end(GraphTicks now, bool backwards) noexcept {
  const GraphTicks start = cell_start(now, backwards);
  return backwards ? now - start : start + kRootCell - now;
}

GraphTicks to_cell_middle(GraphTicks now, bool backwards) noexcept {
  return cell_start(now, backwards) + kRootCell / 2 - now;
}

DualQuatd move_root(LiveGraph& live, GraphTicks ticks) noexcept {
  if (live.root_samples() == 1 && !live.has_root_cuts()) {
    for (const LiveMotion& motion : live.motions())
      if (motion.moves_root)
        return sample_motion(live, motion, live.samples_of(motion)[0], motion.state->position,
                             motion.state->position + motion.step * ticks);
  }
  const bool backwards = ticks < 0;
  const GraphTicks behind = cell_start(live.header().now, backwards) - live.header().now;
  const GraphTicks middle = to_cell_middle(live.header().now, backwards);
  live.weigh(middle);
  TwistSum sum;
  for (const LiveMotion& motion : live.motions()) sum.add_cell(live, motion, behind);
  for (const LiveMachine& machine : live.machines())
    if (machine.first > 0 && machine.moves_root) add_frozen(live, machine, middle, sum);
  if (!(sum.total > 0.0)) return {};
  const double part = static_cast<double>(ticks) / static_cast<double>(kRootCell) / sum.total;
  return exponential({sum.twist.turn * part, sum.twist.shift * part});
}

DualQuatd root_place_now(LiveGraph& live) noexcept {
  RawArray<RootShare, kMostPoseOps> shares;
  std::size_t count = 0;
  live.weigh(0);
  for (const LiveMotion& motion : live.motions()) {
    if (!motion.moves_root || !(motion.root_weight > 0.0f)) continue;
    for (const LiveSample& sample : live.samples_of(motion)) {
      RootShare share;
      share.weight = static_cast<double>(motion.root_weight) * static_cast<double>(sample.share);
      if (sample.entry->root != nullptr && sample.entry->root_in_pose) {
        share.place = sample.entry->root->place(motion.time_s(sample, motion.state->position));
        if (sample.mirror) share.place = mirrored_motion(share.place, live.clips().mirror_normal());
      }
      shares.put(count++, share);
    }
  }
  if (count == 1) return shares[0].place;
  return blend_root_motion({shares.data(), count}).place;
}

}  // namespace sinew
