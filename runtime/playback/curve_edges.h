// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/curve.h"
#include "runtime/base/api.h"

namespace sinew {

/// The times at which a curve crosses a threshold, for triggers: a foot touches the ground, a door is half open.
///     const sinew::CurveEdges edges = sinew::find_edges(height, 0.02f, clip.duration_s(), true);
///     for (EventCursor crossed(clock.advance(dt), edges.times_s); auto i = crossed.next();)
///       edges.rises[*i] ? lift() : land();
/// If the clip plays backwards, a rising edge is crossed downwards.
struct CurveEdges {
  std::vector<double> times_s;  ///< [E] never decreasing, in [0, duration]
  std::vector<bool> rises;      ///< the value goes from at most the threshold to above it; false: it goes the other way
};

/// Finds all edges of a curve within a clip.
///
/// A value equal to the threshold is not above it. A value that holds crosses at the time of a key. A linear one
/// crosses where u = (threshold - v0) / (v1 - v0). A cubic one is cut where its slope vanishes, and each piece is
/// bisected. In a loop, there is also an edge at 0 if the end and the start are on different sides.
/// in   keys        that check() accepts; keys outside of [0, duration] count too
///      threshold   finite;   duration_s  finite, >= 0, of the clip that the curve belongs to
/// cost O(K), O(K * 64) for cubic curves, allocates
SINEW_API CurveEdges find_edges(Curve<float> keys, float threshold, double duration_s, bool loops);
/// Edges of a flag, which rises when it becomes true.
SINEW_API CurveEdges find_edges(Curve<bool> keys, double duration_s, bool loops);

}  // namespace sinew
