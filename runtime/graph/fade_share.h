// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

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

}  // namespace sinew
