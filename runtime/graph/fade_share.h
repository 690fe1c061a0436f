// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/graph/graph_machine.h"

namespace sinew {

/// Share of the new pose after fraction u of a fade. T is float or double.
/// in   u  clamped to [0, 1].   out  0 at u = 0, 1 at u = 1
template <class T>
T fade_share(GraphFade fade, T u) noexcept {
  u = std::clamp(u, T(0), T(1));
  switch (fade) {
    case GraphFade::linear: return u;
    case GraphFade::smooth: return u * u * (T(3) - T(2) * u);
    case GraphFade::smoother: return u * u * u * (T(10) + u * (T(6) * u - T(15)));
    case GraphFade::ease_in: return u * u;
    case GraphFade::ease_out: return u * (T(2) - u);
  }
  return u;
}

/// Share of the new pose after fraction u of a fade with a curve of its own.
/// eq   between two keys, h apart: p0 + t (h s0 + t (3 d - h (2 s0 + s1) + t (h (s0 + s1) - 2 d))), d = p1 - p0,
///      t in [0, 1] from the first key to the second
/// in   keys  of a checked GraphFadeCurve
inline double curve_share(std::span<const GraphFadeKey> keys, double u) noexcept {
  u = std::clamp(u, 0.0, 1.0);
  std::size_t next = 1;
  while (next + 1 < keys.size() && u >= static_cast<double>(keys[next].at)) ++next;
  const GraphFadeKey &a = keys[next - 1], &b = keys[next];
  const double h = static_cast<double>(b.at) - static_cast<double>(a.at), t = (u - static_cast<double>(a.at)) / h;
  const double d = static_cast<double>(b.share) - static_cast<double>(a.share);
  const double s0 = h * static_cast<double>(a.slope), s1 = h * static_cast<double>(b.slope);
  const double share = static_cast<double>(a.share) + t * (s0 + t * (3 * d - 2 * s0 - s1 + t * (s0 + s1 - 2 * d)));
  return std::clamp(share, 0.0, 1.0);  // rounding may leave the range of the shares
}

/// Share of the new state in root motion and events after fraction u of a transition that is no cross-fade. It has the
/// curve of the pose: inertialize 1 - (1 - u)^4 (1 + 4 u), the decay of an offset without velocity; dead_blend
/// u^2 (3 - 2 u).
/// in   u  clamped to [0, 1].   out  0 at u = 0, 1 at u = 1
template <class T>
T cut_share(GraphTransitionKind kind, T u) noexcept {
  if (kind != GraphTransitionKind::inertialize) return fade_share(GraphFade::smooth, u);
  u = std::clamp(u, T(0), T(1));
  const T left = (T(1) - u) * (T(1) - u);
  return T(1) - left * left * (T(1) + T(4) * u);
}

}  // namespace sinew
