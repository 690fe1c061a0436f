// SPDX-License-Identifier: MIT
#include "runtime/graph/read_graph_state.h"

#include <array>

#include "runtime/base/contract.h"
#include "runtime/graph/graph_values.h"
#include "runtime/graph/live_graph.h"

namespace sinew {

std::size_t read_graph_state(const GraphDefinition& graph, const GraphClipSet& clips, std::span<const float> parameters,
                             std::span<const std::byte> state, std::span<GraphStateView> views) noexcept {
  CONTRACT(state.size() >= graph.state_bytes() && parameters.size() >= graph.tables().parameters.size());
  // The const_cast is safe, because open() does not write into the state.
  const GraphValues values(graph.tables(), parameters);
  LiveGraph live(graph, clips, values.all(), const_cast<std::byte*>(state.data()));
  live.open();
  std::size_t count = 0;
  for (const LiveMachine& machine : live.machines()) {
    const std::size_t depth = machine.slots.depth();
    std::array<float, kMostGraphFades + 1> shares{};
    float rest = 1.0f;
    for (std::size_t i = depth; i-- > 0;) {
      const float fade = i == 0 ? 1.0f : live.fade_of(machine.slots.slot(i), 0);
      shares[i] = rest * fade;
      rest *= 1.0f - fade;
    }
    for (std::size_t i = 0; i < depth; ++i, ++count) {
      if (count >= views.size()) continue;
      const SlotState& slot = machine.slots.slot(i);
      GraphStateView& view = views[count];
      view = {machine.node, slot.state, shares[i], seconds_of(slot.time), 0.0, i + 1 == depth};
      if (machine.driver[i] == kNoMotion) continue;
      const LiveMotion& motion = live.motions()[machine.driver[i]];
      if (motion.period > 0)
        view.rounds = static_cast<double>(motion.state->rounds) +
                      static_cast<double>(motion.state->position) / static_cast<double>(motion.period);
    }
  }
  return count;
}

}  // namespace sinew
