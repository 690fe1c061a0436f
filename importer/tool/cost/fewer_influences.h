// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/model/skin.h"

namespace sinew::cost {

/// Keeps at most `count` influences of each vertex: the heaviest, which come first. Their weights are normalised again.
VertexInfluences heaviest_influences(const VertexInfluences& influences, std::uint32_t count);

/// Weights as normalised integers of type N whose sum is 1 in each vertex: all are rounded, and the heaviest takes the
/// difference. Weights that round to 0 stay as influences, so the amount of work does not change.
template <class N>
std::vector<N> whole_weights(const VertexInfluences& influences);
extern template std::vector<std::uint8_t> whole_weights(const VertexInfluences&);
extern template std::vector<std::uint16_t> whole_weights(const VertexInfluences&);

}  // namespace sinew::cost
