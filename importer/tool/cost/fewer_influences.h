// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/model/skin.h"

namespace sinew::cost {

/// At most `count` influences a vertex: the heaviest, which come first, with weights of sum 1 again.
VertexInfluences heaviest_influences(const VertexInfluences& influences, std::uint32_t count);

/// Weights as normalised integers of type N, of sum 1 in each vertex: each rounded, the heaviest takes what is missing.
/// Those that round to 0 stay as influences of weight 0: the work is the same.
template <class N>
std::vector<N> whole_weights(const VertexInfluences& influences);
extern template std::vector<std::uint8_t> whole_weights(const VertexInfluences&);
extern template std::vector<std::uint16_t> whole_weights(const VertexInfluences&);

}  // namespace sinew::cost
