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
    const std::int64_t from_turns = divided_down(from, motion.period), to_turns = divided_down(to, motion.period);
    from -= from_turns * motion.period;
    to -= to_turns * motion.period;
    step.from_turns = static_cast<double>(from_turns);
    step.to_turns = static_cast<double>(to_turns);
  } else {
    from = std::clamp(from, std::int64_t{0}, motion.period);
    to = std::clamp(to, std::int64_t{0}, motion.period);
  }
  step.from_s = motion.time_s(sample, from);
  step.to_s = motion.time_s(sample, to);
  const DualQuatd moved = sample.entry->root->motion(step);
  return sample.mirror ? mirrored_motion(moved, live.clips().mirror_normal()) : moved;
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
  if (live.root_samples() == 1) {
    for (const LiveMotion& motion : live.motions())
      if (motion.moves_root)
        return sample_motion(live, motion, live.samples_of(motion)[0], motion.state->position,
                             motion.state->position + motion.step * ticks);
  }
  const bool backwards = ticks < 0;
  const GraphTicks behind = cell_start(live.header().now, backwards) - live.header().now;
  live.weigh(to_cell_middle(live.header().now, backwards));
  RigidTwist sum;
  double total = 0.0;
  for (const LiveMotion& motion : live.motions()) {
    if (!motion.moves_root || !(motion.root_weight > 0.0f)) continue;
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
      const RigidTwist twist = logarithm(sample_motion(live, motion, sample, from, to));
      sum.turn += twist.turn * (weight * scale);
      sum.shift += twist.shift * (weight * scale);
    }
  }
  if (!(total > 0.0)) return {};
  const double part = static_cast<double>(ticks) / static_cast<double>(kRootCell) / total;
  return exponential({sum.turn * part, sum.shift * part});
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
      if (sample.entry->root != nullptr) {
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
