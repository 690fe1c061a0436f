// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "importer/graph/graph_document.h"
#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"
#include "runtime/sync/sync_track.h"

namespace sinew {

/// Phases at which a foot comes down, from its heights at equal steps of a cycle.
/// eq   it comes down where its height falls through the lowest tenth of its range, if it has been in the upper seven
///      tenths since it last came down
/// in   least_lift  a foot whose range is smaller stays on the ground: no phases
/// out  rising, in [0, 1)
std::vector<double> find_touchdowns(std::span<const double> heights, double least_lift);

/// The beats of a clip: events that a graph names as beats, and for beats without an event in the clip the touchdowns
/// of their foot. Two beats nearer than a thousandth of the clip are one, with the name of the first.
/// out  names are indices of GraphDocument::beats
std::vector<SyncBeat> find_beats(const GraphDocument& document, const Animation& clip, const Skeleton& skeleton);

/// The beat of the other side for each beat, for GraphClipSet::make.
std::vector<std::uint32_t> mirrored_beats(const GraphDocument& document);

}  // namespace sinew
