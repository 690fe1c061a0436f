// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/assets/skin.h"

namespace sinew::cost {

/// At most `count` influences a vertex: the heaviest, which come first, with weights of sum 1 again.
VertexInfluences heaviest_influences(const VertexInfluences& influences, std::uint32_t count);

/// Weights rounded to multiples of 1 / `steps`, then of sum 1 again, as normalised integers in a file are read. Those that round to 0
/// stay as influences of weight 0: the work is the same.
VertexInfluences coarse_weights(const VertexInfluences& influences, std::uint32_t steps);

}  // namespace sinew::cost
