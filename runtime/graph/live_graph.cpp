// SPDX-License-Identifier: MIT
#include "runtime/graph/live_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sinew {
namespace {

/// Shortest length of a round, in ticks. Eight rounds then fit into the range of positions, and steps are bounded.
constexpr double kShortestRound = 0.001 * static_cast<double>(kTicksPerSecond);

/// Points of a blend space with smaller weights are left out. Rounding leaves such weights where the place is exactly
/// at another point.
constexpr float kLeastShare = 1e-6f;

}  // namespace

void LiveGraph::clear() noexcept {
  motion_count_ = sample_count_ = machine_count_ = root_samples_ = 0;
  plays_in_step_ = has_segments_ = has_root_cuts_ = false;
  moves_root_ = is_fresh_ = true;
}

void LiveGraph::open() noexcept { open_only(tables_.root, state_); }

std::uint16_t LiveGraph::open_only(GraphIndex node, std::byte* base) noexcept {
  clear();
  return open_node(node, base);
}

void LiveGraph::open_slots(GraphIndex node, std::byte* base, std::size_t end) noexcept {
  clear();
  open_machine(node, base, end);
}

std::uint16_t LiveGraph::open_node(GraphIndex node, std::byte* base) noexcept {
  const std::size_t s = tables_.nodes[node].settings;
  switch (tables_.nodes[node].kind) {
    case GraphNodeKind::clip: return open_clip(node, base);
    case GraphNodeKind::blend_space: return open_space(node, base);
    case GraphNodeKind::machine: return open_machine(node, base, slots_of(node, base).depth());
    case GraphNodeKind::select: {
      std::byte* const own = base + graph_.offset_of(node);
      return open_node(tables_.children[tables_.selects[s].first_child + block_at<SelectState>(own).child],
                       own + sizeof(SelectState));
    }
    case GraphNodeKind::layers: {
      const GraphLayers& layers = tables_.layers[s];
      const std::uint16_t driver = open_node(layers.base, base);
      const bool moves_root = moves_root_;
      for (std::size_t i = 0; i < layers.layer_count; ++i) {
        const GraphLayer& layer = tables_.layer_list[layers.first_layer + i];
        moves_root_ = moves_root && layer.kind == GraphLayerKind::mean;
        open_node(layer.node, base);
      }
      moves_root_ = moves_root;
      return driver;
    }
    case GraphNodeKind::external: break;
  }
  return kNoMotion;
}

double LiveGraph::speed_of(const GraphClipNode& clip) const noexcept {
  double speed = static_cast<double>(clip.speed);
  if (clip.speed_parameter != kNoGraphIndex) speed *= static_cast<double>(value_of(clip.speed_parameter));
  constexpr double kMost = kMostGraphSpeed;
  return std::isfinite(speed) ? std::clamp(speed, -kMost, kMost) : 0.0;
}

std::uint16_t LiveGraph::open_clip(GraphIndex node, std::byte* base) noexcept {
  const GraphClipNode& clip = tables_.clips[tables_.nodes[node].settings];
  const GraphClipSet::Entry& entry = clips_.entries()[clip.clip];
  const double speed = speed_of(clip);
  LiveMotion& motion = motions_[motion_count_];
  motion.state = &block_at<MotionState>(base + graph_.offset_of(node));
  motion.period = entry.period;
  motion.own_step = entry.period > 0 ? nearest_whole(speed / kTicksOfClip) : 0;
  motion.step = motion.own_step;
  motion.length =
      motion.own_step != 0 ? static_cast<double>(entry.period) / std::fabs(static_cast<double>(motion.own_step)) : 0.0;
  motion.first_sample = static_cast<std::uint16_t>(sample_count_);
  motion.sample_count = 1;
  motion.segments = 0;
  motion.node = node;
  motion.loop = clip.loop;
  motion.is_space = false;
  motion.moves_root = moves_root_;
  root_samples_ += moves_root_ ? 1 : 0;
  samples_[sample_count_++] = {&entry, nullptr, motion.length, 1.0f, clip.clip, kNoGraphIndex, clip.mirror};
  return static_cast<std::uint16_t>(motion_count_++);
}

std::uint16_t LiveGraph::open_space(GraphIndex node, std::byte* base) noexcept {
  const GraphIndex index = tables_.nodes[node].settings;
  const GraphBlendSpace& space = tables_.spaces[index];
  const std::uint32_t segments = clips_.space_beats().segments(index);
  const std::span points = std::span(tables_.points).subspan(space.first_point, space.point_count);
  std::array<float, kMostBlendPoints> weights;
  blend_space_weights(graph_.blend_space(index), value_of(space.x), space.y == kNoGraphIndex ? 0.0f : value_of(space.y),
                      std::span(weights).first(points.size()));
  LiveMotion& motion = motions_[motion_count_];
  motion.first_sample = static_cast<std::uint16_t>(sample_count_);
  double length = 0.0, moving = 0.0, direction = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > kLeastShare)) continue;
    const GraphClipNode& clip = tables_.clips[tables_.nodes[points[i].node].settings];
    const GraphClipSet::Entry& entry = clips_.entries()[clip.clip];
    const auto point = static_cast<GraphIndex>(space.first_point + i);
    const double* const bounds = segments == 0 ? nullptr : clips_.space_beats().bounds(point);
    LiveSample& sample = samples_[sample_count_++];
    sample = {&entry, bounds, 0.0, weights[i], clip.clip, point, clip.mirror};
    const double speed = speed_of(clip), weight = static_cast<double>(weights[i]);
    if (entry.period == 0 || speed == 0.0) continue;
    sample.length = static_cast<double>(entry.period) * kTicksOfClip / std::fabs(speed);
    length += weight * sample.length * (segments == 0 ? 1.0 : clips_.space_beats().rounds(point));
    moving += weight;
    direction += weight * speed;
  }
  motion.sample_count = static_cast<std::uint16_t>(sample_count_ - motion.first_sample);
  motion.state = &block_at<MotionState>(base + graph_.offset_of(node));
  motion.length = moving > 0.0 ? std::max(length / moving, kShortestRound) : 0.0;
  motion.own_step = moving > 0.0 ? nearest_whole(static_cast<double>(kPhasePeriod) / motion.length) : 0;
  if (direction < 0.0) motion.own_step = -motion.own_step;
  motion.step = motion.own_step;
  motion.period = kPhasePeriod;
  motion.segments = static_cast<std::uint16_t>(segments);
  if (segments > 0) {
    has_segments_ = true;
    follow_segment(motion, false);
  }
  motion.node = node;
  motion.loop = motion.is_space = true;
  motion.moves_root = moves_root_;
  root_samples_ += moves_root_ ? motion.sample_count : 0;
  return static_cast<std::uint16_t>(motion_count_++);
}

void LiveGraph::follow_segment(LiveMotion& motion, bool backwards) noexcept {
  if (motion.segments == 0 || motion.own_step == 0) return;
  const std::uint64_t k = motion.segment(backwards);
  double length = 0.0, moving = 0.0;
  for (const LiveSample& sample : samples_of(motion)) {
    if (!(sample.length > 0.0)) continue;
    length += static_cast<double>(sample.share) * sample.length * (sample.bounds[k + 1] - sample.bounds[k]);
    moving += static_cast<double>(sample.share);
  }
  const double ticks = std::max(length / moving, kShortestRound) * static_cast<double>(motion.segments);
  const std::int64_t step = nearest_whole(static_cast<double>(kPhasePeriod) / ticks);
  motion.own_step = motion.own_step < 0 ? -step : step;
  motion.step = motion.own_step;
}

void LiveGraph::follow_segments(bool backwards) noexcept {
  if (!has_segments_ || (std::exchange(is_fresh_, false) && !backwards)) return;
  for (LiveMotion& motion : motions()) follow_segment(motion, backwards);
}

std::size_t LiveGraph::first_playing(const MachineSlots& slots, std::size_t end) const noexcept {
  for (std::size_t i = end; i-- > 1;)
    if (is_cut(slots.slot(i))) return i;
  return 0;
}

std::uint16_t LiveGraph::open_machine(GraphIndex node, std::byte* base, std::size_t end) noexcept {
  LiveMachine& live = machines_[machine_count_++];
  live.machine = &tables_.machines[tables_.nodes[node].settings];
  live.slots = slots_of(node, base);
  live.node = node;
  live.first = first_playing(live.slots, end);
  live.end = end;
  has_root_cuts_ |= live.first > 0 && moves_root_;
  live.moves_root = moves_root_;
  for (std::size_t i = 0; i < live.first; ++i) live.driver[i] = kNoMotion;
  for (std::size_t i = live.first; i < end; ++i) {
    const SlotState& slot = live.slots.slot(i);
    live.driver[i] = open_node(tables_.states[live.machine->first_state + slot.state].node, live.slots.inside(i));
    if (i > live.first && slot.whole == 0 && tables_.transitions[slot.transition].sync == GraphSync::locked)
      plays_in_step_ = true;
  }
  return live.driver[end - 1];
}

GraphIndex LiveGraph::choice_of(const GraphSelect& select) const noexcept {
  const float value = std::floor(value_of(select.parameter) + 0.5f);
  if (!(value > 0.0f)) return 0;
  const auto last = static_cast<float>(select.child_count - 1);
  return static_cast<GraphIndex>(std::min(value, last));
}

float LiveGraph::weight_of(const GraphLayer& layer) const noexcept {
  if (layer.weight_parameter == kNoGraphIndex) return layer.weight;
  const float weight = layer.weight * value_of(layer.weight_parameter);
  return weight > 0.0f && std::isfinite(weight) ? weight : 0.0f;
}

}  // namespace sinew
