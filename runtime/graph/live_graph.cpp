// SPDX-License-Identifier: MIT
#include "runtime/graph/live_graph.h"

#include <algorithm>
#include <cmath>

#include "runtime/graph/fade_share.h"

namespace sinew {
namespace {

/// Shortest length of a round, in ticks. Eight rounds then fit into the range of positions, and steps are bounded.
constexpr double kShortestRound = 0.001 * static_cast<double>(kTicksPerSecond);

/// Points of a blend space with smaller weights are left out. Rounding leaves such weights where the place is exactly
/// at another point.
constexpr float kLeastShare = 1e-6f;

}  // namespace

double LiveMotion::time_s(const LiveSample& sample, std::int64_t position) const noexcept {
  if (is_space) return static_cast<double>(position) * kRoundsOfPhase * sample.entry->duration_s;
  return static_cast<double>(position) * kTicksOfClip / static_cast<double>(kTicksPerSecond);
}

std::int64_t LiveMotion::position_at(GraphTicks ahead) const noexcept {
  if (ahead == 0 || period == 0) return state->position;
  const std::int64_t position = state->position + step * ahead;
  if (!loop) return std::clamp(position, std::int64_t{0}, period);
  const std::int64_t rest = position % period;
  return rest < 0 ? rest + period : rest;
}

void LiveGraph::clear() noexcept {
  motion_count_ = sample_count_ = machine_count_ = root_samples_ = 0;
  plays_in_step_ = false;
  moves_root_ = true;
}

void LiveGraph::open() noexcept { open_only(tables_.root, state_); }

void LiveGraph::open_only(GraphIndex node, std::byte* base) noexcept {
  clear();
  open_node(node, base);
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
  motion.own_step = entry.period > 0 ? std::llround(speed / kTicksOfClip) : 0;
  motion.step = motion.own_step;
  motion.length =
      motion.own_step != 0 ? static_cast<double>(entry.period) / std::fabs(static_cast<double>(motion.own_step)) : 0.0;
  motion.first_sample = static_cast<std::uint16_t>(sample_count_);
  motion.sample_count = 1;
  motion.node = node;
  motion.loop = clip.loop;
  motion.is_space = false;
  motion.moves_root = moves_root_;
  root_samples_ += moves_root_ ? 1 : 0;
  samples_[sample_count_++] = {&entry, 1.0f, clip.clip, clip.mirror};
  return static_cast<std::uint16_t>(motion_count_++);
}

std::uint16_t LiveGraph::open_space(GraphIndex node, std::byte* base) noexcept {
  const GraphBlendSpace& space = tables_.spaces[tables_.nodes[node].settings];
  const std::span points = std::span(tables_.points).subspan(space.first_point, space.point_count);
  std::array<float, kMostBlendPoints> weights;
  blend_space_weights(graph_.blend_space(tables_.nodes[node].settings), value_of(space.x),
                      space.y == kNoGraphIndex ? 0.0f : value_of(space.y), std::span(weights).first(points.size()));
  LiveMotion& motion = motions_[motion_count_];
  motion.first_sample = static_cast<std::uint16_t>(sample_count_);
  double length = 0.0, moving = 0.0, direction = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > kLeastShare)) continue;
    const GraphClipNode& clip = tables_.clips[tables_.nodes[points[i].node].settings];
    const GraphClipSet::Entry& entry = clips_.entries()[clip.clip];
    samples_[sample_count_++] = {&entry, weights[i], clip.clip, clip.mirror};
    const double speed = speed_of(clip), weight = static_cast<double>(weights[i]);
    if (entry.period == 0 || speed == 0.0) continue;
    length += weight * static_cast<double>(entry.period) * kTicksOfClip / std::fabs(speed);
    moving += weight;
    direction += weight * speed;
  }
  motion.sample_count = static_cast<std::uint16_t>(sample_count_ - motion.first_sample);
  motion.state = &block_at<MotionState>(base + graph_.offset_of(node));
  motion.length = moving > 0.0 ? std::max(length / moving, kShortestRound) : 0.0;
  motion.own_step = moving > 0.0 ? std::llround(static_cast<double>(kPhasePeriod) / motion.length) : 0;
  if (direction < 0.0) motion.own_step = -motion.own_step;
  motion.step = motion.own_step;
  motion.period = kPhasePeriod;
  motion.node = node;
  motion.loop = motion.is_space = true;
  motion.moves_root = moves_root_;
  root_samples_ += moves_root_ ? motion.sample_count : 0;
  return static_cast<std::uint16_t>(motion_count_++);
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

float LiveGraph::fade_of(const SlotState& slot, GraphTicks ahead) const noexcept {
  if (slot.whole != 0) return 1.0f;
  const GraphFade fade = is_cut(slot) ? GraphFade::smoother : tables_.transitions[slot.transition].fade;
  const auto u = static_cast<double>(slot.time + ahead) / static_cast<double>(duration_of(slot));
  return static_cast<float>(fade_share(fade, u));
}

void LiveGraph::weigh(GraphTicks ahead) noexcept {
  weighed_ = 0;
  ahead_ = ahead;
  weigh_node(tables_.root, state_, 1.0f, 1.0f);
}

void LiveGraph::weigh_node(GraphIndex node, std::byte* base, float weight, float root_weight) noexcept {
  const std::size_t s = tables_.nodes[node].settings;
  switch (tables_.nodes[node].kind) {
    case GraphNodeKind::clip:
    case GraphNodeKind::blend_space: {
      LiveMotion& motion = motions_[weighed_++];
      motion.weight = weight;
      motion.root_weight = root_weight;
      return;
    }
    case GraphNodeKind::select: {
      std::byte* const own = base + graph_.offset_of(node);
      return weigh_node(tables_.children[tables_.selects[s].first_child + block_at<SelectState>(own).child],
                        own + sizeof(SelectState), weight, root_weight);
    }
    case GraphNodeKind::layers: {
      const GraphLayers& layers = tables_.layers[s];
      const std::size_t base_motion = weighed_;
      weigh_node(layers.base, base, weight, root_weight);
      for (std::size_t i = 0; i < layers.layer_count; ++i) {
        const GraphLayer& layer = tables_.layer_list[layers.first_layer + i];
        const float w = weight_of(layer), mean = w / (1.0f + w);
        const bool is_mean = layer.kind == GraphLayerKind::mean;
        if (is_mean)
          for (std::size_t m = base_motion; m < weighed_; ++m) {
            motions_[m].weight *= 1.0f - mean;
            motions_[m].root_weight *= 1.0f - mean;
          }
        weigh_node(layer.node, base, weight * (is_mean ? mean : std::min(w, 1.0f)),
                   is_mean ? root_weight * mean : 0.0f);
      }
      return;
    }
    case GraphNodeKind::machine: {
      const GraphMachine& machine = tables_.machines[s];
      const MachineSlots slots = slots_of(node, base);
      std::array<float, kMostGraphFades + 1> shares;
      float rest = 1.0f;
      for (std::size_t i = slots.depth(); i-- > 0;) {
        const float fade = i == 0 ? 1.0f : fade_of(slots.slot(i), ahead_);
        shares[i] = rest * fade;
        rest *= 1.0f - fade;
      }
      for (std::size_t i = first_playing(slots, slots.depth()); i < slots.depth(); ++i)
        weigh_node(tables_.states[machine.first_state + slots.slot(i).state].node, slots.inside(i), weight * shares[i],
                   root_weight * shares[i]);
      return;
    }
    case GraphNodeKind::external: return;
  }
}

void LiveGraph::match_lengths(GraphTicks ahead) noexcept {
  for (LiveMotion& motion : motions()) motion.step = motion.own_step;
  if (!plays_in_step_) return;
  for (const LiveMachine& live : machines()) {
    const auto is_locked = [&](std::size_t i) {
      const SlotState& slot = live.slots.slot(i);
      return i > live.first && slot.whole == 0 && tables_.transitions[slot.transition].sync == GraphSync::locked &&
             live.driver[i] != kNoMotion && live.driver[i - 1] != kNoMotion && motions_[live.driver[i]].length > 0.0 &&
             motions_[live.driver[i - 1]].length > 0.0;
    };
    for (std::size_t first = live.first, end = 1; first < live.slots.depth(); first = end) {
      double length = live.driver[first] == kNoMotion ? 0.0 : motions_[live.driver[first]].length;
      for (end = first + 1; end < live.slots.depth() && is_locked(end); ++end) {
        const double share = static_cast<double>(fade_of(live.slots.slot(end), ahead));
        length += share * (motions_[live.driver[end]].length - length);
      }
      if (end == first + 1) continue;
      for (std::size_t i = first; i < end; ++i) {
        LiveMotion& motion = motions_[live.driver[i]];
        motion.step = std::llround(static_cast<double>(motion.own_step) * (motion.length / length));
      }
    }
  }
}

}  // namespace sinew
