// SPDX-License-Identifier: MIT
// The shares of what plays, and the steps of motions that follow from them.
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/graph/fade_share.h"
#include "runtime/graph/live_graph.h"

namespace sinew {

float LiveGraph::fade_of(const SlotState& slot, GraphTicks ahead) const noexcept {
  if (slot.whole != 0) return 1.0f;
  const GraphTransition& transition = tables_.transitions[slot.transition];
  const auto u = static_cast<double>(slot.time + ahead) / static_cast<double>(duration_of(slot));
  if (is_cut(slot)) return static_cast<float>(cut_share(kind_of(transition), u));
  if (transition.curve != kNoGraphIndex) return static_cast<float>(curve_share(tables_.keys_of(transition.curve), u));
  return static_cast<float>(fade_share(transition.fade, u));
}

void LiveGraph::weigh(GraphTicks ahead) noexcept {
  weighed_ = weighed_machines_ = 0;
  ahead_ = ahead;
  weigh_node(tables_.root, state_, 1.0f, 1.0f);
}

void LiveGraph::weigh_slots(GraphTicks ahead) noexcept {
  weighed_ = 0;
  weighed_machines_ = 1;
  ahead_ = ahead;
  weigh_machine(machines_[0], 1.0f, 1.0f);
}

/// Multiplies the weights that this weigh() has found for the motions and machines from these indices on.
void LiveGraph::weaken(std::size_t first_motion, std::size_t first_machine, float factor) noexcept {
  for (std::size_t m = first_motion; m < weighed_; ++m) {
    motions_[m].weight *= factor;
    motions_[m].root_weight *= factor;
  }
  for (std::size_t m = first_machine; m < weighed_machines_; ++m) machines_[m].root_weight *= factor;
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
      const std::size_t base_motion = weighed_, base_machine = weighed_machines_;
      weigh_node(layers.base, base, weight, root_weight);
      for (std::size_t i = 0; i < layers.layer_count; ++i) {
        const GraphLayer& layer = tables_.layer_list[layers.first_layer + i];
        const float w = weight_of(layer), mean = w / (1.0f + w);
        const bool is_mean = layer.kind == GraphLayerKind::mean;
        if (is_mean) weaken(base_motion, base_machine, 1.0f - mean);
        weigh_node(layer.node, base, weight * (is_mean ? mean : std::min(w, 1.0f)),
                   is_mean ? root_weight * mean : 0.0f);
      }
      return;
    }
    case GraphNodeKind::machine: return weigh_machine(machines_[weighed_machines_++], weight, root_weight);
    case GraphNodeKind::external: return;
  }
}

void LiveGraph::weigh_machine(LiveMachine& live, float weight, float root_weight) noexcept {
  live.root_weight = root_weight;
  const MachineSlots& slots = live.slots;
  float rest = share_above_cuts(slots, live.first, ahead_);
  std::array<float, kMostGraphFades + 1> shares;
  for (std::size_t i = live.end; i-- > live.first;) {
    const float fade = i == live.first ? 1.0f : fade_of(slots.slot(i), ahead_);
    shares[i] = rest * fade;
    rest *= 1.0f - fade;
  }
  for (std::size_t i = live.first; i < live.end; ++i)
    weigh_node(tables_.states[live.machine->first_state + slots.slot(i).state].node, slots.inside(i),
               weight * shares[i], root_weight * shares[i]);
}

float LiveGraph::share_above_cuts(const MachineSlots& slots, std::size_t first, GraphTicks ahead) const noexcept {
  float share = 1.0f;
  for (std::size_t cut = first; cut > 0; cut = first_playing(slots, cut)) share *= fade_of(slots.slot(cut), ahead);
  return share;
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
        motion.step = nearest_whole(static_cast<double>(motion.own_step) * (motion.length / length));
      }
    }
  }
}

}  // namespace sinew
