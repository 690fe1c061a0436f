// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/scene.h"

namespace sinew {

/// Which joints are not shown: those whose own flag is off, and all below them (KHR_node_visibility).
/// eq   hidden[j] = off(j) or hidden[parent(j)];  off(j): the animated flag is below one half, else j is one of the
///      scene's hidden joints
/// in   properties[P]  of this frame; empty = no flag is animated
/// out  hidden[J]      cost O(J + P), no allocation
void find_hidden(const Scene& scene, std::span<const float> properties, std::span<bool> hidden) noexcept;

}  // namespace sinew
