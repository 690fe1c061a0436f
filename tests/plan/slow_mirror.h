// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/plan/frame_input.h"
#include "runtime/plan/needs.h"

namespace sinew::test {

/// The morph weights of a layer, mirrored if the layer is.
inline std::vector<double> on_side(const Needs& needs, const ClipLayer& layer, const std::vector<double>& weights) {
  if (!layer.mirrored || needs.in.mirror->weight_source.empty()) return weights;
  std::vector<double> mirrored;
  for (const std::uint32_t source : needs.in.mirror->weight_source) mirrored.push_back(weights[source]);
  return mirrored;
}

}  // namespace sinew::test
