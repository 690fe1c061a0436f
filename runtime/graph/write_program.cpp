// SPDX-License-Identifier: MIT
#include "runtime/graph/write_program.h"

#include <algorithm>
#include <array>

#include "runtime/graph/raw_array.h"

namespace sinew {
namespace {

/// Threshold of a mean: if the weights sum to less, the rest pose gets the missing weight. Here they sum to about 1, so
/// the threshold only guards against an empty sum.
constexpr double kThreshold = 0.001;

/// Time step, in ticks, over which transitions measure velocities.
constexpr GraphTicks kVelocityStep = kTicksPerSecond / 1000;

struct OpList {
  std::size_t count = 0;
  RawArray<PoseOp, kMostPoseOps> ops;

  void push(const PoseOp& op) noexcept { ops.put(count++, op); }
  PoseOp& last() noexcept { return ops[count - 1]; }
};

/// Writes operations for the lists of a live graph, as they are `ahead` ticks from now.
class ProgramWriter {
 public:
  ProgramWriter(LiveGraph& live, OpList& out, GraphTicks ahead) noexcept
      : live_(live), t_(live.tables()), out_(out), ahead_(ahead) {}

  /// Writes the node as a single pose, with this weight and mask for the operation that takes it.
  void write_pose(GraphIndex node, std::byte* base, float weight, std::uint8_t mask) noexcept {
    join(write_operands(node, base, 1.0f));
    out_.last().weight = weight;
    out_.last().mask = mask;
  }

 private:
  void join(std::size_t operands) noexcept {
    if (operands != 1)
      out_.push({.time_s = kThreshold, .index = static_cast<std::uint16_t>(operands), .kind = PoseOpKind::mean});
  }

  /// Writes the node as poses whose weights sum to `weight`. Returns the number of poses.
  std::size_t write_operands(GraphIndex node, std::byte* base, float weight) noexcept {
    const std::size_t s = t_.nodes[node].settings;
    switch (t_.nodes[node].kind) {
      case GraphNodeKind::clip:
      case GraphNodeKind::blend_space: return write_motion(weight);
      case GraphNodeKind::external:
        out_.push({.weight = weight, .index = t_.nodes[node].settings, .kind = PoseOpKind::external});
        return 1;
      case GraphNodeKind::select: {
        std::byte* const own = base + live_.graph().offset_of(node);
        return write_operands(t_.children[t_.selects[s].first_child + block_at<SelectState>(own).child],
                              own + sizeof(SelectState), weight);
      }
      case GraphNodeKind::layers: return write_layers(t_.layers[s], base, weight);
      case GraphNodeKind::machine: return write_slots(node, base, live_.slots_of(node, base).depth(), weight);
    }
    return 0;
  }

  std::size_t write_motion(float weight) noexcept {
    const LiveMotion& motion = live_.motions()[motion_++];
    const LiveMotion::Place place = motion.place_at(motion.position_at(ahead_));
    for (const LiveSample& sample : live_.samples_of(motion))
      out_.push({motion.time_s(sample, place), weight * sample.share,
                 static_cast<std::uint16_t>(std::min<std::uint32_t>(sample.entry->clip, 0xFFFF)), PoseOp::kNoMask,
                 sample.mirror ? PoseOpKind::sample_mirrored : PoseOpKind::sample});
    return motion.sample_count;
  }

  std::size_t write_layers(const GraphLayers& layers, std::byte* base, float weight) noexcept {
    write_pose(layers.base, base, 1.0f, PoseOp::kNoMask);
    for (std::size_t i = 0; i < layers.layer_count; ++i) {
      const GraphLayer& layer = t_.layer_list[layers.first_layer + i];
      const float w = live_.weight_of(layer);
      const std::size_t before = out_.count;
      write_pose(layer.node, base, w, layer.mask);
      if (!(w > 0.0f)) {  // it plays, but is not visible
        out_.count = before;
        continue;
      }
      PoseOp join;
      switch (layer.kind) {
        case GraphLayerKind::mean: join = {.time_s = kThreshold, .index = 2, .kind = PoseOpKind::mean}; break;
        case GraphLayerKind::overlay: join.kind = PoseOpKind::overlay; break;
        case GraphLayerKind::overlay_model: join.kind = PoseOpKind::overlay_model; break;
        case GraphLayerKind::additive: join.kind = PoseOpKind::add_to_rest; break;
      }
      out_.push(join);
    }
    out_.last().weight = weight;
    return 1;
  }

  GraphIndex node_of(GraphIndex machine, const SlotState& slot) const noexcept {
    return t_.states[t_.machines[t_.nodes[machine].settings].first_state + slot.state].node;
  }

  /// Writes the slots [0, end) of a machine: first the mix of the states that play, then a transition operation for
  /// each cut. The newest cut comes first, since it compares only the states that it left with the state that it
  /// entered.
  std::size_t write_slots(GraphIndex machine, std::byte* base, std::size_t end, float weight) noexcept {
    const MachineSlots slots = live_.slots_of(machine, base);
    const std::size_t first = live_.first_playing(slots, end);
    if (first == 0) return write_mix(machine, slots, 0, end, weight);
    join(write_mix(machine, slots, first, end, 1.0f));
    for (std::size_t cut = first; cut > 0; cut = live_.first_playing(slots, cut)) write_cut(machine, base, slots, cut);
    out_.last().weight = weight;
    return 1;
  }

  std::size_t write_mix(GraphIndex machine, const MachineSlots& slots, std::size_t first, std::size_t end,
                        float weight) noexcept {
    std::array<float, kMostGraphFades + 1> shares;
    float rest = weight;
    for (std::size_t i = end; i-- > first;) {
      const float fade = i == first ? 1.0f : live_.fade_of(slots.slot(i), ahead_);
      shares[i] = rest * fade;
      rest *= 1.0f - fade;
    }
    std::size_t operands = 0;
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t before = out_.count;
      const std::size_t of_state = write_operands(node_of(machine, slots.slot(i)), slots.inside(i), shares[i]);
      if (shares[i] > 0.0f)
        operands += of_state;
      else
        out_.count = before;
    }
    return operands;
  }

  /// Writes a transition operation for a cut, with the last pose written as target. Its other operands do not change
  /// during the transition, so frames evaluate them once.
  void write_cut(GraphIndex machine, std::byte* base, const MachineSlots& slots, std::size_t index) noexcept {
    const SlotState& slot = slots.slot(index);
    const GraphTicks duration = live_.duration_of(slot), time = std::max(slot.time + ahead_, GraphTicks{0});
    if (time >= duration) return;
    const auto steps = std::clamp<GraphTicks>(duration / kVelocityStep, 1, 0xFFFF);
    const GraphTicks step = duration / steps;
    const std::span<const float> parameters{slots.started_parameters(index), t_.parameters.size()};
    const bool inertializes = live_.kind_of(t_.transitions[slot.transition]) == GraphTransitionKind::inertialize;
    LiveGraph then(live_.graph(), live_.clips(), parameters, live_.state());
    then.open_slots(machine, base, index);
    for (const GraphTicks ahead : {GraphTicks{0}, -step})
      ProgramWriter(then, out_, ahead).write_playing(machine, slots, index);
    if (inertializes) {
      const GraphIndex node = node_of(machine, slot);
      then.open_only(node, slots.started(index));
      // The target did not play before its start. Its pose one step before is extrapolated from its pose one step
      // later.
      for (const GraphTicks ahead : {GraphTicks{0}, GraphTicks{0}, GraphTicks{0}, step})
        ProgramWriter(then, out_, ahead).write_pose(node, slots.started(index), 1.0f, PoseOp::kNoMask);
      out_.push({.index = static_cast<std::uint16_t>(DeltaFrame::parent), .kind = PoseOpKind::add});
    }
    out_.push({.time_s = static_cast<double>(time) / static_cast<double>(duration),
               .index = static_cast<std::uint16_t>(steps),
               .kind = inertializes ? PoseOpKind::inertialize : PoseOpKind::dead_blend});
  }

  /// Writes the states that play in the slots below `end` as one pose.
  void write_playing(GraphIndex machine, const MachineSlots& slots, std::size_t end) noexcept {
    join(write_mix(machine, slots, live_.first_playing(slots, end), end, 1.0f));
    out_.last().weight = 1.0f;
  }

  LiveGraph& live_;
  const GraphTables& t_;
  OpList& out_;
  GraphTicks ahead_;
  std::size_t motion_ = 0;  // index in the list of motions, in the order of opening
};

}  // namespace

void write_program(LiveGraph& live, PoseProgram& program) noexcept {
  OpList list;
  ProgramWriter(live, list, 0).write_pose(live.tables().root, live.state(), 1.0f, PoseOp::kNoMask);
  program.clear();
  for (std::size_t i = 0; i < list.count; ++i) program.push(list.ops[i]);
}

}  // namespace sinew
