// SPDX-License-Identifier: MIT
#include "runtime/graph/write_program.h"

#include <algorithm>
#include <array>

namespace sinew {
namespace {

/// Weights of a mean sum to 1 within rounding: it normalises them.
constexpr double kThreshold = 0.001;

class ProgramWriter {
 public:
  explicit ProgramWriter(LiveGraph& live) noexcept : live_(live), t_(live.tables()) {}

  void write(PoseProgram& program) noexcept {
    write_pose(t_.root, live_.state(), 1.0f, PoseOp::kNoMask);
    for (std::size_t i = 0; i < count_; ++i) program.push(ops_[i]);
  }

 private:
  void push(const PoseOp& op) noexcept { ops_[count_++] = op; }

  /// One pose, which weighs so much in what takes it.
  void write_pose(GraphIndex node, std::byte* base, float weight, std::uint8_t mask) noexcept {
    const std::size_t operands = write_operands(node, base, 1.0f);
    if (operands != 1)
      push({.time_s = kThreshold, .index = static_cast<std::uint16_t>(operands), .kind = PoseOpKind::mean});
    ops_[count_ - 1].weight = weight;
    ops_[count_ - 1].mask = mask;
  }

  /// Poses whose weights sum to `weight`. Returns how many.
  std::size_t write_operands(GraphIndex node, std::byte* base, float weight) noexcept {
    const std::size_t s = t_.nodes[node].settings;
    switch (t_.nodes[node].kind) {
      case GraphNodeKind::clip:
      case GraphNodeKind::blend_space: return write_motion(weight);
      case GraphNodeKind::external:
        push({.weight = weight, .index = t_.nodes[node].settings, .kind = PoseOpKind::external});
        return 1;
      case GraphNodeKind::select: {
        std::byte* const own = base + live_.graph().offset_of(node);
        return write_operands(t_.children[t_.selects[s].first_child + block_at<SelectState>(own).child],
                              own + sizeof(SelectState), weight);
      }
      case GraphNodeKind::layers: return write_layers(t_.layers[s], base, weight);
      case GraphNodeKind::machine: return write_machine(node, base, weight);
    }
    return 0;
  }

  std::size_t write_motion(float weight) noexcept {
    const LiveMotion& motion = live_.motions()[motion_++];
    for (const LiveSample& sample : live_.samples_of(motion))
      push({motion.time_s(sample, motion.state->position), weight * sample.share,
            static_cast<std::uint16_t>(std::min<std::uint32_t>(sample.entry->clip, 0xFFFF)), PoseOp::kNoMask,
            sample.mirror ? PoseOpKind::sample_mirrored : PoseOpKind::sample});
    return motion.sample_count;
  }

  std::size_t write_layers(const GraphLayers& layers, std::byte* base, float weight) noexcept {
    write_pose(layers.base, base, 1.0f, PoseOp::kNoMask);
    for (std::size_t i = 0; i < layers.layer_count; ++i) {
      const GraphLayer& layer = t_.layer_list[layers.first_layer + i];
      const float w = live_.weight_of(layer);
      const std::size_t before = count_;
      write_pose(layer.node, base, w, layer.mask);
      if (!(w > 0.0f)) {  // it has played, but is not seen
        count_ = before;
        continue;
      }
      PoseOp join;
      switch (layer.kind) {
        case GraphLayerKind::mean: join = {.time_s = kThreshold, .index = 2, .kind = PoseOpKind::mean}; break;
        case GraphLayerKind::overlay: join.kind = PoseOpKind::overlay; break;
        case GraphLayerKind::overlay_model: join.kind = PoseOpKind::overlay_model; break;
        case GraphLayerKind::additive: join.kind = PoseOpKind::add_to_rest; break;
      }
      push(join);
    }
    ops_[count_ - 1].weight = weight;
    return 1;
  }

  std::size_t write_machine(GraphIndex node, std::byte* base, float weight) noexcept {
    const GraphMachine& machine = t_.machines[t_.nodes[node].settings];
    const MachineSlots slots = live_.slots_of(node, base);
    std::array<float, kMostGraphFades + 1> shares;
    float rest = weight;
    for (std::size_t i = slots.depth(); i-- > 0;) {
      const float fade = i == 0 ? 1.0f : live_.fade_of(slots.slot(i), 0);
      shares[i] = rest * fade;
      rest *= 1.0f - fade;
    }
    std::size_t operands = 0;
    for (std::size_t i = 0; i < slots.depth(); ++i) {
      const std::size_t before = count_;
      const std::size_t of_state =
          write_operands(t_.states[machine.first_state + slots.slot(i).state].node, slots.inside(i), shares[i]);
      if (shares[i] > 0.0f)
        operands += of_state;
      else
        count_ = before;
    }
    return operands;
  }

  LiveGraph& live_;
  const GraphTables& t_;
  std::size_t motion_ = 0, count_ = 0;
  std::array<PoseOp, kMostPoseOps> ops_;
};

}  // namespace

void write_program(LiveGraph& live, PoseProgram& program) noexcept {
  program.clear();
  ProgramWriter(live).write(program);
}

}  // namespace sinew
