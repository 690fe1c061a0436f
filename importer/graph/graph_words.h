// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "importer/graph/graph_document.h"

namespace sinew::graph_schema {

/// The JSON words of an enumeration; the index of a word is the enumerator's value.
constexpr auto words_of(GraphParameterKind) { return std::array{"number", "flag", "trigger"}; }
constexpr auto words_of(GraphConditionKind) {
  return std::array{"above", "below", "equal", "not_equal", "on", "off", "trigger", "time_in_state", "played", "phase"};
}
constexpr auto words_of(GraphTransitionKind) { return std::array{"cross_fade", "inertialize", "dead_blend"}; }
constexpr auto words_of(GraphFade) { return std::array{"linear", "smooth", "smoother", "ease_in", "ease_out"}; }
constexpr auto words_of(GraphInterruption) {
  return std::array{"none", "source", "target", "source_then_target", "target_then_source"};
}
constexpr auto words_of(GraphSync) { return std::array{"none", "start", "locked"}; }
constexpr auto words_of(SyncStart) { return std::array{"phase", "beat", "time_left"}; }
constexpr auto words_of(BlendSpaceKind) { return std::array{"line", "cartesian", "directional", "radial"}; }
constexpr auto words_of(GraphLayerKind) { return std::array{"mean", "overlay", "overlay_model", "additive"}; }
constexpr auto words_of(GraphDocument::NodeKind) {
  return std::array{"clip", "blend_space", "select", "layers", "machine", "external", "graph"};
}

}  // namespace sinew::graph_schema
