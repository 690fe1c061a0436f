// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/graph/graph_machine.h"

namespace sinew {

/// The keys of a fade curve from (0, 0) to (1, 1) through points between them.
/// eq   the slope at a point is the harmonic mean of the slopes to its neighbours, weighted by their distances, and 0
///      where these differ in sign (Fritsch and Butland 1984), so that no cubic leaves the range of its two points
/// in   points  `at` and `share` are used
SINEW_API std::vector<GraphFadeKey> fade_curve_keys(float start_slope, float end_slope,
                                                    std::span<const GraphFadeKey> points);

}  // namespace sinew
