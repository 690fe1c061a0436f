// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"

namespace sinew {

/// Finds the hidden joints: joints whose own flag is off, and all joints below them (KHR_node_visibility).
/// eq   hidden[j] = off(j) or hidden[parent(j)]
///      off(j): the animated flag is below one half. A joint without an animated flag is off if the scene hides it.
/// in   properties[P]  of this frame; empty = no flag is animated
/// out  hidden[J]      cost O(J + P), no allocation. Internal to plan/
void find_hidden(const Scene& scene, std::span<const float> properties, std::span<bool> hidden) noexcept;

/// Flags that decide which instances a frame shows.
struct Visibility {
  std::span<const bool> hidden;               ///< [joints] empty = no joint is hidden
  std::span<const std::uint8_t> out_of_view;  ///< [instances] nonzero = out of view; empty = none

  bool is_hidden(const CompiledPlan& plan, std::size_t instance) const noexcept {
    return !hidden.empty() && hidden[plan.scene->instances[instance].joint];
  }
  bool is_out_of_view(std::size_t instance) const noexcept {
    return !out_of_view.empty() && out_of_view[instance] != 0;
  }
  bool is_deformed(const CompiledPlan& plan, std::size_t instance) const noexcept {
    return !is_out_of_view(instance) && (plan.needs.out.hidden_meshes || !is_hidden(plan, instance));
  }
};

/// Finds the skins whose palettes visible instances need. An instance that fully shows its geometry cache needs none,
/// unless the plan's needs ask for palettes.
/// in   geometry  FrameInput::geometry;   shown[cached instances]  FrameTables::shown
/// out  [skins] in the frame's memory
std::span<const bool> wanted_palettes(const CompiledPlan& plan, const Visibility& visibility,
                                      std::span<const GeometryInput> geometry, std::span<const ShownVertices> shown,
                                      FrameMemory memory) noexcept;

}  // namespace sinew
