// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/graph/graph_definition.h"

namespace sinew {

/// Joint weights of a graph's masks on a skeleton: the list for FrameInput::masks or Needs.
/// eq   all weights are 0, then each entry of the mask in turn sets the weight of its joint, and of all joints below it
///      if GraphMaskJoint::below
/// out  [masks][joints]
/// err  index_out_of_range (the skeleton has no joint of the name)
/// cost O(entries * joints), allocates
SINEW_API Result<std::vector<std::vector<float>>> make_graph_masks(const GraphTables& tables, const Skeleton& skeleton);

}  // namespace sinew
